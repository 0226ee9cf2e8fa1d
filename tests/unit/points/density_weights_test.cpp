// SPDX-License-Identifier: MIT
#include "orthoball/points/density_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "generators/cases.h"
#include "generators/point_families.h"
#include "orthoball/error.h"

namespace orthoball {
namespace {

using generators::PointFamily;

std::vector<double> copy(std::span<const double> numbers) {
  return {numbers.begin(), numbers.end()};
}

std::string refusal(const WeightedPoints& points, std::size_t neighbours, std::size_t row) {
  try {
    (void)with_density_weights(points, neighbours);
  } catch (const InputError& error) {
    EXPECT_EQ(error.row(), row);
    return error.what();
  }
  return "";
}

TEST(DensityWeights, AreHalfTheMeanSquareDistanceToTheNearest) {
  // Distances from 0: 1, 3; from 1: 1, 2; from 3: 2, 3.
  const WeightedPoints line(2, {0, 0, 1, 0, 3, 0}, WeightKind::radius, {5, 0, 1});
  const WeightedPoints weighted = with_density_weights(line, 2);
  EXPECT_EQ(weighted.weight_kind(), WeightKind::weight);
  EXPECT_EQ(copy(weighted.weights()), (std::vector<double>{2.5, 1.25, 3.25}));
  EXPECT_EQ(copy(with_density_weights(line, 1).weights()), (std::vector<double>{0.5, 0.5, 2.0}));
  EXPECT_EQ(copy(weighted.coordinates()), copy(line.coordinates()));
}

TEST(DensityWeights, StayDecimalsWithTwoMore) {
  const auto line = WeightedPoints::fixed_point(2, 1, {0, 0, 1, 0, 3, 0}, WeightKind::none, {});
  const WeightedPoints weighted = with_density_weights(line, 2);
  EXPECT_EQ(weighted.decimals(), 3);
  EXPECT_EQ(copy(weighted.coordinates()), (std::vector<double>{0, 0, 100, 0, 300, 0}));
  EXPECT_EQ(copy(weighted.weights()), (std::vector<double>{25000, 12500, 32500}));
  EXPECT_DOUBLE_EQ(weighted.weight(0), 0.025);
}

TEST(DensityWeights, TakeFewerDecimalsWhereCoordinatesNeedTheirDigits) {
  const auto wide =
      WeightedPoints::fixed_point(2, 0, {800000000000000, 0, 0, 0, 3, 0}, WeightKind::none, {});
  const WeightedPoints weighted = with_density_weights(wide, 1);
  EXPECT_EQ(weighted.decimals(), 1);
  EXPECT_EQ(copy(weighted.weights()).at(1), 450.0);
}

TEST(DensityWeights, CountRowsAtOnePositionOnce) {
  const WeightedPoints points(2, {0, 0, 0, 0, 1, 0, 1, 0, 3, 0}, WeightKind::none, {});
  EXPECT_EQ(copy(with_density_weights(points, 2).weights()),
            (std::vector<double>{2.5, 2.5, 1.25, 1.25, 3.25}));
}

TEST(DensityWeights, ScaleWithTheSquareOfLengths) {
  const WeightedPoints points = generators::points_of(PointFamily::uniform, 3, 300, 1);
  const auto weights = copy(with_density_weights(points, 7).weights());
  const WeightedPoints larger = generators::scaled_by_power_of_two(points, 5);
  const auto scaled = copy(with_density_weights(larger, 7).weights());
  for (std::size_t row = 0; row < weights.size(); ++row) {
    ASSERT_EQ(scaled[row], std::ldexp(weights[row], 10));
  }
}

TEST(DensityWeights, DependOnTheSetOfSitesAlone) {
  for (const auto& one : generators::cases(1, 40, 400)) {
    if (generators::is_extreme(one.family)) continue;
    SCOPED_TRACE(testing::Message() << one);
    const WeightedPoints points = one.points();
    const auto order = generators::random_permutation(points.size(), 3);
    const WeightedPoints shuffled = generators::with_rows(points, order);
    WeightedPoints weighted(one.dimension), other(one.dimension);
    try {
      weighted = with_density_weights(points, 3, Threads(1));
    } catch (const InputError&) {
      continue;  // of few positions
    }
    other = with_density_weights(shuffled, 3, Threads(4));
    for (std::size_t i = 0; i < order.size(); ++i) {
      ASSERT_EQ(other.weights()[i], weighted.weights()[order[i]]);
    }
  }
}

TEST(DensityWeights, NeedMorePositionsThanNeighbours) {
  const WeightedPoints points(2, {0, 0, 0, 0, 1, 0, 1, 0, 3, 0}, WeightKind::none, {});
  EXPECT_EQ(refusal(points, 3, InputError::kNoRow),
            "the 3 nearest neighbours are asked for, and there are 3 sites at different positions; "
            "there must be more than neighbours");
  EXPECT_EQ(refusal(points, 0, InputError::kNoRow),
            "0 nearest neighbours are asked for; there must be 1 or more");
  EXPECT_EQ(with_density_weights(WeightedPoints(3), 4).size(), 0U);
}

TEST(DensityWeights, RefuseSquaresBeyondTheRangeOfDoubles) {
  for (const double far : {1e200, 1e-200}) {
    const WeightedPoints points(2, {0, 0, 0, far}, WeightKind::none, {});
    EXPECT_EQ(refusal(points, 1, 0),
              "row 0: the squared distances to its neighbours are beyond the range of doubles; "
              "coordinates must be given in another unit");
  }
}

}  // namespace
}  // namespace orthoball
