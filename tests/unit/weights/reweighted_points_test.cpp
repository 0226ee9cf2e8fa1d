// SPDX-License-Identifier: MIT
#include "orthoball/weights/reweighted_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "orthoball/error.h"

namespace orthoball {
namespace {

__extension__ using Int128 = __int128;

std::vector<double> copy(std::span<const double> numbers) {
  return {numbers.begin(), numbers.end()};
}

TEST(ReweightedPoints, KeepDecimalRadiiAsTheirExactSquares) {
  const auto points =
      WeightedPoints::fixed_point(2, 1, {12, 5, 3, 4, 0, 0}, WeightKind::radius, {94906267, -7, 2});
  const NewWeight one{SiteId(2), -1.234};
  const WeightedPoints changed = reweighted(points, 2, {&one, 1});
  EXPECT_EQ(changed.decimals(), 3);
  EXPECT_EQ(changed.weight_kind(), WeightKind::weight);
  EXPECT_EQ(copy(changed.coordinates()), (std::vector<double>{1200, 500, 300, 400, 0, 0}));
  const auto square = static_cast<Int128>(94906267) * 94906267 * 10000;  // is no double
  EXPECT_NE(changed.weights_low()[0], 0.0);
  EXPECT_TRUE(static_cast<Int128>(changed.weights()[0]) +
                  static_cast<Int128>(changed.weights_low()[0]) ==
              square);
  EXPECT_EQ(changed.weights()[1], -490000.0);
  EXPECT_EQ(changed.weights()[2], -12340.0);
}

TEST(ReweightedPoints, KeepDoublesAndTheirRadii) {
  const WeightedPoints points(2, {0.1, 0.2, 0.3, 0.4}, WeightKind::radius, {0.7, 0.9});
  const NewWeight one{SiteId(1), -0.25};
  const WeightedPoints changed = reweighted(points, 5, {&one, 1});
  EXPECT_EQ(changed.weight_kind(), WeightKind::radius);
  EXPECT_EQ(copy(changed.weights()), (std::vector<double>{0.7, -0.5}));
  EXPECT_EQ(copy(changed.coordinates()), copy(points.coordinates()));
}

TEST(ReweightedPoints, TakeAsManyDecimalsAsFit) {
  const auto points = WeightedPoints::fixed_point(2, 0, {900000000000000, 5}, WeightKind::none, {});
  EXPECT_EQ(decimals_for(points, 1e-9), 1);
  const auto small = WeightedPoints::fixed_point(2, 0, {9, 5}, WeightKind::none, {});
  EXPECT_EQ(decimals_for(small, 1e-9), 5);
  EXPECT_EQ(decimals_for(small, 3.0), 0);
  EXPECT_EQ(decimals_for(WeightedPoints(2, {9, 5}, WeightKind::none, {}), 1e-9), 0);
}

TEST(ReweightedPoints, RefuseWeightsBeyondTheNumbersHeldExactly) {
  const auto points = WeightedPoints::fixed_point(2, 0, {9, 5}, WeightKind::none, {});
  const NewWeight one{SiteId(0), 1e40};
  EXPECT_THROW((void)reweighted(points, 0, {&one, 1}), LimitError);
}

}  // namespace
}  // namespace orthoball
