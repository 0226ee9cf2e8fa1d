// SPDX-License-Identifier: MIT
#include "orthoball/weights/distinct_sites.h"

#include <gtest/gtest.h>

#include <vector>

namespace orthoball {
namespace {

TEST(DistinctSites, AreInLexicographicOrderWithTheirRows) {
  const WeightedPoints points(2, {1, 0, 0, 5, 1, 0, 0, 5, -0.0, 5}, WeightKind::radius,
                              {2, -3, 1, -3, -3});
  const DistinctSites<2> sites(points);
  EXPECT_EQ(sites.x, (std::vector<std::array<double, 2>>{{0, 5}, {1, 0}, {1, 0}}));
  EXPECT_EQ(sites.weight, (std::vector<double>{-9, 1, 4}));
  EXPECT_EQ(sites.site_of_row, (std::vector<std::uint32_t>{2, 0, 1, 0, 0}));
}

TEST(DistinctSites, DifferInTheLowPartsOfWeightsToo) {
  const auto points = WeightedPoints::fixed_point(2, 1, {1, 1, 1, 1}, WeightKind::weight,
                                                  {0x1p+60, 0x1p+60}, {1, 0});
  EXPECT_EQ(DistinctSites<2>(points).site_of_row, (std::vector<std::uint32_t>{1, 0}));
}

}  // namespace
}  // namespace orthoball
