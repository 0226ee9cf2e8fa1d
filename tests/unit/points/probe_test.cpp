// SPDX-License-Identifier: MIT
#include "orthoball/points/probe.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "orthoball/error.h"

namespace orthoball {
namespace {

constexpr std::int64_t kLargest = std::int64_t{1} << 53U;

ProbeRadius decimal(double nearest, std::int64_t digits, int decimals) {
  return {nearest, digits, decimals};
}

std::vector<double> copy(std::span<const double> numbers) {
  return {numbers.begin(), numbers.end()};
}

WeightedPoints balls(int decimals, std::vector<double> coordinates, std::vector<double> radii) {
  return WeightedPoints::fixed_point(2, decimals, std::move(coordinates), WeightKind::radius,
                                     std::move(radii));
}

// The message of the InputError with this reason and row that is thrown.
std::string refusal(const WeightedPoints& points, const ProbeRadius& probe,
                    InputError::Reason reason, std::size_t row) {
  try {
    (void)with_probe(points, probe);
  } catch (const InputError& error) {
    EXPECT_EQ(error.reason(), reason);
    EXPECT_EQ(error.row(), row);
    return error.what();
  }
  return "";
}

TEST(Probe, AddsToEveryRadiusExactly) {
  const auto grown = with_probe(balls(2, {123, 0, 5, 7}, {170, 152}), decimal(1.4, 14, 1));
  EXPECT_EQ(grown.decimals(), 2);
  EXPECT_EQ(grown.weight_kind(), WeightKind::radius);
  EXPECT_EQ(copy(grown.coordinates()), (std::vector<double>{123, 0, 5, 7}));
  EXPECT_EQ(copy(grown.weights()), (std::vector<double>{310, 292}));
  EXPECT_EQ(grown.radius(0), 3.1);
}

TEST(Probe, MayHaveMoreDecimalsThanTheBalls) {
  const auto grown = with_probe(balls(1, {10, 0, 5, 70}, {17, 15}), decimal(0.125, 125, 3));
  EXPECT_EQ(grown.decimals(), 3);
  EXPECT_EQ(copy(grown.coordinates()), (std::vector<double>{1000, 0, 500, 7000}));
  EXPECT_EQ(copy(grown.weights()), (std::vector<double>{1825, 1625}));
}

TEST(Probe, LeavesNoMoreDecimalsThanTheSumsNeed) {
  const auto grown = with_probe(balls(1, {10, 0, 50, 70}, {15, 5}), decimal(0.5, 5, 1));
  EXPECT_EQ(grown.decimals(), 0);
  EXPECT_EQ(copy(grown.coordinates()), (std::vector<double>{1, 0, 5, 7}));
  EXPECT_EQ(copy(grown.weights()), (std::vector<double>{2, 1}));
}

TEST(Probe, IsTheRadiusOfPoints) {
  const auto points = WeightedPoints::fixed_point(2, 0, {1, 2}, WeightKind::none, {});
  const auto grown = with_probe(points, decimal(2.5, 25, 1));
  EXPECT_EQ(grown.decimals(), 1);
  EXPECT_EQ(grown.weight_kind(), WeightKind::radius);
  EXPECT_EQ(copy(grown.coordinates()), (std::vector<double>{10, 20}));
  EXPECT_EQ(copy(grown.weights()), (std::vector<double>{25}));
}

TEST(Probe, TakesRootsOfWeights) {
  const WeightedPoints points(3, {0, 0, 0, 1, 1, 1}, WeightKind::weight, {4, 0});
  const auto grown = with_probe(points, decimal(0.5, 5, 1));
  EXPECT_FALSE(grown.decimals().has_value());
  EXPECT_EQ(copy(grown.weights()), (std::vector<double>{2.5, 0.5}));
  const auto fixed = WeightedPoints::fixed_point(3, 1, {0, 0, 15}, WeightKind::weight, {400});
  EXPECT_EQ(copy(with_probe(fixed, decimal(1, 1, 0)).weights()), (std::vector<double>{3}));
  EXPECT_EQ(with_probe(fixed, decimal(1, 1, 0)).coordinate(0, 2), 1.5);
}

TEST(Probe, MakesEverythingDoublesWhereDecimalsDoNotFit) {
  const auto largest = static_cast<double>(kLargest);
  const auto fits = [](const WeightedPoints& points, const ProbeRadius& probe) {
    return with_probe(points, probe).decimals().has_value();
  };
  EXPECT_TRUE(fits(balls(0, {largest, 0}, {largest - 1}), decimal(1, 1, 0)));
  EXPECT_FALSE(fits(balls(0, {largest, 0}, {largest}), decimal(1, 1, 0)));
  EXPECT_FALSE(fits(balls(0, {largest, 0}, {1}), decimal(0.5, 5, 1)));
  EXPECT_TRUE(fits(balls(0, {0, 0}, {0}), decimal(1e-300, 1, 300)));
  EXPECT_FALSE(fits(balls(0, {1, 0}, {0}), decimal(1e-300, 1, 300)));
  EXPECT_FALSE(fits(balls(20, {1, 0}, {1}), decimal(1, 1, 0)));
  EXPECT_FALSE(fits(balls(1, {1, 0}, {1}), {1.25, std::nullopt, 0}));
  EXPECT_FALSE(fits(WeightedPoints(2, {1, 0}, WeightKind::radius, {1}), decimal(1, 1, 0)));
  const auto doubles = with_probe(balls(1, {15, 0}, {17}), {1.25, std::nullopt, 0});
  EXPECT_EQ(copy(doubles.coordinates()), (std::vector<double>{1.5, 0}));
  EXPECT_EQ(copy(doubles.weights()), (std::vector<double>{1.7 + 1.25}));
}

TEST(Probe, OfNoRadiusChangesNothing) {
  const auto same = with_probe(balls(1, {10, 20}, {-30}), {});
  EXPECT_EQ(same.decimals(), 1);
  EXPECT_EQ(copy(same.weights()), (std::vector<double>{-30}));
  EXPECT_EQ(with_probe(WeightedPoints(2), decimal(1, 1, 0)).size(), 0U);
}

TEST(Probe, RefusesImaginaryBallsByTheirRow) {
  using Reason = InputError::Reason;
  EXPECT_EQ(
      refusal(balls(1, {0, 0, 1, 1}, {10, -5}), decimal(1.4, 14, 1), Reason::imaginary_ball, 1),
      "row 1: radius is -0.5, an imaginary ball; with a probe every radius must be 0 or more");
  const WeightedPoints weights(2, {0, 0, 1, 1}, WeightKind::weight, {-4, 1});
  EXPECT_EQ(refusal(weights, decimal(1.4, 14, 1), Reason::imaginary_ball, 0),
            "row 0: weight is -4, an imaginary ball; with a probe every weight must be 0 or more");
}

TEST(Probe, MustBeALength) {
  using Reason = InputError::Reason;
  const WeightedPoints points(2, {0, 0}, WeightKind::radius, {1e308});
  for (const double radius :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(refusal(points, {radius, std::nullopt, 0}, Reason::wrong_argument, InputError::kNoRow)
                  .find("0 or more"),
              std::string::npos);
  }
  EXPECT_NE(refusal(points, {1e308, std::nullopt, 0}, Reason::not_finite, 0).find("row 0"),
            std::string::npos);
}

}  // namespace
}  // namespace orthoball
