// SPDX-License-Identifier: MIT
#include "orthoball/measures/thin_cell.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "orthoball/exact/sites.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {
namespace {

ThinCell measured(const std::vector<double>& coordinates, int exponent = 0) {
  const WeightedPoints points(3, coordinates, WeightKind::none, {});
  const Sites<3> sites(points, {SiteId(0), SiteId(1), SiteId(2), SiteId(3)});
  return thin_cell(sites, {0, 1, 2, 3}, sites.exact_scale_exponent() + exponent);
}

TEST(ThinCell, OfARegularTetrahedronHasTheKnownMeasures) {
  const ThinCell cell = measured({0, 0, 0, 1, 1, 0, 1, 0, 1, 0, 1, 1});
  EXPECT_DOUBLE_EQ(cell.volume, 2.0);
  const double angle = std::numbers::pi - std::acos(1.0 / 3.0);
  EXPECT_DOUBLE_EQ(cell.length, 6 * std::sqrt(2.0) * angle);
}

TEST(ThinCell, OfANeedleIsAsLongAsASegment) {
  // Corners an ulp apart at 1: doubles lose every digit of their normals.
  constexpr double ulp = 0x1p-52;
  const ThinCell cell = measured({0, 0, 0, 1, 1, 1 + ulp, 1 + ulp, 1, 1, 1, 1 + ulp, 1});
  EXPECT_NEAR(cell.length, 2 * std::numbers::pi * std::sqrt(3.0), 1e-14);
  EXPECT_GT(cell.volume, 0.0);
  EXPECT_NEAR(cell.volume, 3 * ulp * ulp, 1e-14 * ulp * ulp);
}

TEST(ThinCell, OfASliverHasTheLengthOfItsFlatSquare) {
  const ThinCell cell = measured({0, 0, 0, 1, 0, 0, 1, 1, 0x1p-60, 0, 1, 0});
  EXPECT_NEAR(cell.length, 4 * std::numbers::pi, 1e-14);
  EXPECT_EQ(cell.volume, 0x1p-60);
}

TEST(ThinCell, OfAnySizeGivesTheSameInItsUnit) {
  const ThinCell cell = measured({0, 0, 0, 3, 1, 0, 1, 4, 1, 0, 1, 5});
  for (const int exponent : {-1000, -200, 200, 1000}) {
    std::vector<double> scaled{0, 0, 0, 3, 1, 0, 1, 4, 1, 0, 1, 5};
    for (double& x : scaled) x = std::ldexp(x, exponent);
    const ThinCell other = measured(scaled, exponent);
    EXPECT_EQ(other.volume, cell.volume);
    EXPECT_EQ(other.length, cell.length);
  }
}

}  // namespace
}  // namespace orthoball
