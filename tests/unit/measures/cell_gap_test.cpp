// SPDX-License-Identifier: MIT
#include "orthoball/measures/cell_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace orthoball {
namespace {

constexpr double kPi = std::numbers::pi;

std::array<Sphere<3>, 4> unit_corner(double radius) {
  std::array<Sphere<3>, 4> balls{{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  for (Sphere<3>& ball : balls) ball = {ball.x, radius * radius, radius};
  return balls;
}

TEST(CellGap, WithoutFacesInTheComplexIsTheCellAndItsCorners) {
  const CellGap<3> gap = cell_gap(unit_corner(0.1), {});
  EXPECT_NEAR(gap.volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(gap.exposed[0], kPi / 2, 1e-15);
  const CellGap<2> flat = cell_gap(
      std::array<Sphere<2>, 3>{{{{0, 0}, 0.01, 0.1}, {{1, 0}, 0.01, 0.1}, {{0, 1}, 0.01, 0.1}}},
      {});
  EXPECT_NEAR(flat.volume, 0.5, 1e-15);
  EXPECT_NEAR(flat.exposed[0], kPi / 2, 1e-15);
  EXPECT_NEAR(flat.exposed[1], kPi / 4, 1e-15);
}

TEST(CellGap, TakesTheWedgeAtAnEdge) {
  // Edges from the origin have length 1: at radius 0.6 those three are in the complex, of which
  // here one is taken. Its wedge is a quarter of a double cone.
  const double circle2 = 0.36 - 0.25;
  const CellGap<3> gap = cell_gap(unit_corner(0.6), {.facets = 0, .edges = 1});
  EXPECT_NEAR(gap.volume, 1.0 / 6 - circle2 * (kPi / 2) / 6, 1e-15);
  EXPECT_NEAR(gap.exposed[0], kPi / 2 - (1 - 0.5 / 0.6) * kPi / 2, 1e-15);
}

TEST(CellGap, IsEmptyWhereAllSpheresMeetInItsOrthocentre) {
  // Facets in the complex on all sides and balls that reach the centre of a regular tetrahedron.
  std::array<Sphere<3>, 4> balls{{{{1, 1, 1}}, {{1, -1, -1}}, {{-1, 1, -1}}, {{-1, -1, 1}}}};
  for (Sphere<3>& ball : balls) ball = {ball.x, 3.0, std::sqrt(3.0)};
  const CellGap<3> gap = cell_gap(balls, {.facets = 15, .edges = 63});
  EXPECT_NEAR(gap.volume, 0.0, 1e-14);
  for (const double exposed : gap.exposed) EXPECT_NEAR(exposed, 0.0, 1e-14);
}

TEST(CellGap, KnowsTheSizesOfItsFacets) {
  EXPECT_NEAR(facet_size(unit_corner(1.0), 0), std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(facet_size(unit_corner(1.0), 3), 0.5, 1e-15);
  const std::array<Sphere<2>, 3> triangle{{{{0, 0}, 1, 1}, {{3, 0}, 1, 1}, {{0, 4}, 1, 1}}};
  EXPECT_NEAR(facet_size(triangle, 0), 5.0, 1e-15);
}

}  // namespace
}  // namespace orthoball
