// SPDX-License-Identifier: MIT
#include "orthoball/queries/convex_polytope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace orthoball {
namespace {

template <int D>
void expect_closed(const ConvexPolytope<D>& polytope) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& facet : polytope.facets()) {
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
      const std::uint32_t next = i + 1 < facet.end ? i + 1 : facet.begin;
      ++sides[{polytope.loops()[i], polytope.loops()[next]}];
    }
  }
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, (sides[std::pair(side.second, side.first)]));
  }
}

void expect_in_order(const ConvexPolytope<2>& polygon) {
  for (std::uint32_t i = 0; i < polygon.facets().size(); ++i) {
    const auto& side = polygon.facets()[i];
    EXPECT_EQ(polygon.loops()[side.begin], i);
    EXPECT_EQ(polygon.loops()[side.begin + 1], (i + 1) % polygon.corners().size());
  }
}

template <int D>
double area(const ConvexPolytope<D>& polytope) {
  double sum = 0.0;
  for (const auto& facet : polytope.facets()) sum += polytope.area(facet);
  return sum;
}

TEST(ConvexPolytope, IsABoxAtFirst) {
  const ConvexPolytope<3> box({0, 0, 0}, {1, 2, 3}, 10);
  EXPECT_EQ(box.volume(), 6.0);
  EXPECT_EQ(area(box), 22.0);
  expect_closed(box);
  const double areas[] = {6, 6, 3, 3, 2, 2};
  for (const auto& facet : box.facets()) {
    EXPECT_EQ(box.area(facet), areas[facet.label - 10]);
    const std::uint32_t axis = (facet.label - 10) / 2;
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
      EXPECT_EQ(box.corners()[box.loops()[i]][axis], facet.label % 2 == 0 ? 0.0 : axis + 1.0);
    }
  }
  const ConvexPolytope<2> rectangle({0, 0}, {1, 2}, 10);
  EXPECT_EQ(rectangle.volume(), 2.0);
  expect_in_order(rectangle);
  for (const auto& side : rectangle.facets()) {
    const std::uint32_t axis = (side.label - 10) / 2;
    for (const std::uint32_t i : {side.begin, side.begin + 1}) {
      EXPECT_EQ(rectangle.corners()[rectangle.loops()[i]][axis],
                side.label % 2 == 0 ? 0.0 : axis + 1.0);
    }
  }
}

TEST(ConvexPolytope, LosesACornerToACut) {
  ConvexPolytope<3> box({0, 0, 0}, {1, 1, 1}, 0);
  box.cut({{2, 2, 2}, 5}, 7);
  EXPECT_DOUBLE_EQ(box.volume(), 1 - 1.0 / 48);
  expect_closed(box);
  ASSERT_EQ(box.facets().size(), 7U);
  EXPECT_EQ(box.facets()[6].label, 7U);
  EXPECT_DOUBLE_EQ(box.area(box.facets()[6]), std::sqrt(3.0) / 8);

  ConvexPolytope<2> square({0, 0}, {1, 1}, 0);
  square.cut({{-1, -1}, -0.5}, 7);  // the corner between the last side and the first
  EXPECT_DOUBLE_EQ(square.volume(), 0.875);
  expect_closed(square);
  expect_in_order(square);
  EXPECT_EQ(square.facets().size(), 5U);
}

TEST(ConvexPolytope, IsEmptyOrWholeWhereAPlaneOnlyTouches) {
  for (const double side : {1.0, -1.0}) {
    ConvexPolytope<3> box({0, 0, 0}, {1, 1, 1}, 0);
    box.cut({{side, 0, 0}, side == 1.0 ? 1.0 : -1.0}, 7);
    EXPECT_EQ(box.facets().size(), side == 1.0 ? 6U : 0U);
  }
}

// All cuts of a cube through corners or edges that are there already.
TEST(ConvexPolytope, JoinsCornersThatAreOne) {
  ConvexPolytope<3> box({-1, -1, -1}, {1, 1, 1}, 0);
  std::uint32_t label = 10;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      box.cut({{x, y, 0}, 1}, label++);
      box.cut({{x, 0, y}, 1}, label++);
      box.cut({{0, x, y}, 1}, label++);
    }
  }
  box.join_corners();  // a rhombic dodecahedron, of whose corners six are on the cube
  EXPECT_EQ(box.facets().size(), 12U);
  EXPECT_EQ(box.corners().size(), 14U);
  EXPECT_EQ(box.volume(), 2.0);
  expect_closed(box);
}

TEST(ConvexPolytope, CanBeAsNearToASphereAsIsWanted) {
  for (const double tolerance : {0.3, 0.02, 0.001}) {
    const auto ball = ConvexPolytope<3>::in_unit_sphere(tolerance, 1);
    expect_closed(ball);
    EXPECT_GT(ball.volume(), 4 * std::numbers::pi / 3 * std::pow(1 - tolerance, 3));
    EXPECT_LT(ball.volume(), 4 * std::numbers::pi / 3);
    auto disk = ConvexPolytope<2>::in_unit_sphere(tolerance, 1);
    expect_in_order(disk);
    for (std::size_t i = 0; i < disk.corners().size(); ++i) {
      const auto& a = disk.corners()[i];
      const auto& b = disk.corners()[(i + 1) % disk.corners().size()];
      EXPECT_NEAR(std::hypot(a[0], a[1]), 1.0, 1e-15);
      EXPECT_GE(std::hypot(a[0] + b[0], a[1] + b[1]) / 2, 1 - tolerance);
    }
    disk.scale(3.0);
    EXPECT_LT(disk.volume(), 9 * std::numbers::pi);
    EXPECT_GT(disk.volume(), 9 * std::numbers::pi * std::pow(1 - tolerance, 2));
  }
}

TEST(ConvexPolytope, StaysClosedUnderAnyCuts) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 200; ++round) {
    ConvexPolytope<3> body({-1, -1, -1}, {1, 1, 1}, 0);
    double volume = body.volume();
    for (std::uint32_t label = 6; label < 40; ++label) {
      HalfSpace<3> half{{normal(random), normal(random), normal(random)}, 0.0};
      // Every other plane goes through a corner that is there, but for rounding.
      if (label % 2 == 0) {
        const auto& corner = body.corners()[label % body.corners().size()];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          half.offset += half.normal[axis] * corner[axis];
        }
        half.offset *= 1 + 1e-16 * (round % 3);
      } else {
        half.offset = 0.9;
      }
      if (!(half.offset > 0.3)) continue;
      body.cut(half, label);
      expect_closed(body);
      EXPECT_LE(body.volume(), volume + 1e-14);
      volume = body.volume();
    }
    body.join_corners();
    expect_closed(body);
    EXPECT_NEAR(body.volume(), volume, 1e-13);
  }
}

}  // namespace
}  // namespace orthoball
