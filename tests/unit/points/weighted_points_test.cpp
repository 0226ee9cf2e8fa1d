// SPDX-License-Identifier: MIT
#include "orthoball/points/weighted_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "orthoball/error.h"

namespace orthoball {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_refused(const std::function<void()>& make, InputError::Reason reason, std::size_t row,
                    const std::string& part) {
  try {
    make();
    ADD_FAILURE() << "not refused: " << part;
  } catch (const InputError& error) {
    EXPECT_EQ(error.reason(), reason) << error.what();
    EXPECT_EQ(error.row(), row) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(WeightedPoints, KeepTheNumbersTheyAreGiven) {
  const WeightedPoints points(3, {1, 2, 3, 4, 5, 6}, WeightKind::radius, {0.5, -2});
  EXPECT_EQ(points.dimension(), 3);
  EXPECT_EQ(points.size(), 2U);
  EXPECT_FALSE(points.decimals().has_value());
  EXPECT_EQ(points.weight_kind(), WeightKind::radius);
  EXPECT_EQ(points.coordinates()[5], 6.0);
  EXPECT_EQ(points.coordinate(1, 0), 4.0);
  EXPECT_EQ(points.weight(0), 0.25);
  EXPECT_EQ(points.weight(1), -4.0);
  EXPECT_TRUE(points.weights_low().empty());
}

TEST(WeightedPoints, HaveWeightsZeroWithoutAny) {
  const WeightedPoints points(2, {1, 2}, WeightKind::none, {});
  EXPECT_EQ(points.weight(0), 0.0);
  EXPECT_TRUE(points.weights().empty());
  EXPECT_EQ(WeightedPoints(2).size(), 0U);
}

TEST(WeightedPoints, RoundDecimalsOnce) {
  const auto points =
      WeightedPoints::fixed_point(2, 3, {1100, -1, 0x1p+53, 7}, WeightKind::radius, {1500, -10});
  EXPECT_EQ(points.decimals(), 3);
  EXPECT_EQ(points.coordinate(0, 0), 1.1);
  EXPECT_EQ(points.coordinate(0, 1), -0.001);
  EXPECT_EQ(points.coordinate(1, 0), 9007199254740.992);
  EXPECT_DOUBLE_EQ(points.weight(0), 2.25);
  EXPECT_DOUBLE_EQ(points.weight(1), -0.0001);
  // More decimals than there are exact powers of ten.
  const auto fine = WeightedPoints::fixed_point(2, 30, {123, 0, -7, 1}, WeightKind::none, {});
  EXPECT_EQ(fine.coordinate(0, 0), 123e-30);
  EXPECT_EQ(fine.coordinate(1, 0), -7e-30);
}

TEST(WeightedPoints, KeepWeightsOfTwoDoubles) {
  const auto points =
      WeightedPoints::fixed_point(2, 1, {0, 0, 0, 1}, WeightKind::weight, {0x1p+60, 3}, {1, 0});
  EXPECT_EQ(points.weights_low()[0], 1.0);
  EXPECT_DOUBLE_EQ(points.weight(0), 0x1p+60 / 100);
}

TEST(WeightedPoints, NameTheRowThatIsNotFinite) {
  using Reason = InputError::Reason;
  expect_refused(
      [] {
        WeightedPoints(2, {0, 1, kNaN, 3}, WeightKind::none, {});
      },
      Reason::not_finite, 1, "row 1: a coordinate is NaN");
  expect_refused(
      [] {
        WeightedPoints(3, {0, 1, -kInfinity}, WeightKind::none, {});
      },
      Reason::not_finite, 0, "row 0: a coordinate is infinite");
  expect_refused(
      [] {
        WeightedPoints(2, {0, 1, 2, 3}, WeightKind::weight, {0, kNaN});
      },
      Reason::not_finite, 1, "row 1: weight is NaN");
  expect_refused(
      [] {
        WeightedPoints(2, {0, 1, 2, 3}, WeightKind::radius, {kInfinity, 0});
      },
      Reason::not_finite, 0, "row 0: radius is infinite");
}

TEST(WeightedPoints, RefuseArraysThatDoNotFit) {
  using Reason = InputError::Reason;
  const auto none = InputError::kNoRow;
  expect_refused([] { WeightedPoints(4); }, Reason::wrong_size, none, "dimension is 4");
  expect_refused([] { WeightedPoints(1); }, Reason::wrong_size, none, "dimension is 1");
  expect_refused(
      [] {
        WeightedPoints(3, {1, 2}, WeightKind::none, {});
      },
      Reason::wrong_size, none, "2 coordinates");
  expect_refused(
      [] {
        WeightedPoints(2, {1, 2}, WeightKind::none, {3});
      },
      Reason::wrong_size, none, "1 weights for 1 points; there must be 0");
  expect_refused(
      [] {
        WeightedPoints(2, {1, 2}, WeightKind::weight, {});
      },
      Reason::wrong_size, none, "0 weights for 1 points; there must be 1");
}

TEST(WeightedPoints, RefuseFixedPointThatIsNone) {
  using Reason = InputError::Reason;
  const auto with = [](int decimals, std::vector<double> coordinates, WeightKind kind,
                       std::vector<double> weights, std::vector<double> low) {
    return [=] { (void)WeightedPoints::fixed_point(2, decimals, coordinates, kind, weights, low); };
  };
  const auto none = InputError::kNoRow;
  expect_refused(with(-1, {}, WeightKind::none, {}, {}), Reason::wrong_argument, none,
                 "-1 decimals");
  expect_refused(with(401, {}, WeightKind::none, {}, {}), Reason::wrong_argument, none, "401");
  expect_refused(with(1, {0, 1, 2, 0.5}, WeightKind::none, {}, {}), Reason::wrong_argument, 1,
                 "row 1");
  expect_refused(with(1, {0, 0x1p+54}, WeightKind::none, {}, {}), Reason::wrong_argument, 0,
                 "row 0");
  expect_refused(with(1, {0, 1}, WeightKind::radius, {0x1p+54}, {}), Reason::wrong_argument, 0,
                 "row 0");
  expect_refused(with(1, {0, 1}, WeightKind::weight, {0x1p+107}, {}), Reason::wrong_argument, 0,
                 "row 0");
  expect_refused(with(1, {0, 1}, WeightKind::weight, {1.5}, {}), Reason::wrong_argument, 0,
                 "row 0");
  expect_refused(with(1, {0, 1}, WeightKind::radius, {1}, {0}), Reason::wrong_size, none, "low");
  expect_refused(with(1, {0, 1}, WeightKind::weight, {1}, {0, 0}), Reason::wrong_size, none, "low");
  // Two doubles are one number only if the first is the nearest to their sum.
  expect_refused(with(1, {0, 1}, WeightKind::weight, {3}, {1}), Reason::wrong_argument, 0, "row 0");
  expect_refused(with(1, {0, 1, 0, 2}, WeightKind::weight, {0, 0x1p+54 + 4}, {0, 2}),
                 Reason::wrong_argument, 1, "row 1");
}

TEST(WeightedPoints, TakeEveryFiniteNumber) {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const WeightedPoints points(2, {most, -most, least, -0.0}, WeightKind::radius, {most, least});
  EXPECT_EQ(points.size(), 2U);
  EXPECT_EQ(points.weight(0), kInfinity);
}

TEST(WeightedPoints, TellRadiiAsTheyWereGiven) {
  const auto balls =
      WeightedPoints::fixed_point(2, 2, {0, 0, 1, 1}, WeightKind::radius, {170, -152});
  EXPECT_EQ(balls.radius(0), 1.7);
  EXPECT_EQ(balls.radius(1), -1.52);
  const WeightedPoints weights(2, {0, 0, 1, 1}, WeightKind::weight, {4, -9});
  EXPECT_EQ(weights.radius(0), 2.0);
  EXPECT_EQ(weights.radius(1), -3.0);
  EXPECT_EQ(WeightedPoints(2, {0, 0}, WeightKind::none, {}).radius(0), 0.0);
}

TEST(WeightedPoints, HaveBallsWhereTheirWeightsReachZero) {
  const auto balls =
      WeightedPoints::fixed_point(2, 2, {0, 0, 1, 1}, WeightKind::radius, {170, -300});
  EXPECT_EQ(ball_radius(balls, 0, 0.0), 1.7);
  EXPECT_NEAR(ball_radius(balls, 0, 1.11).value_or(0.0), 2.0, 1e-15);
  EXPECT_FALSE(ball_radius(balls, 1, 0.0).has_value());
  EXPECT_EQ(ball_radius(balls, 1, 9.0), 0.0);
  EXPECT_EQ(ball_radius(balls, 1, 25.0), 4.0);
  EXPECT_FALSE(ball_radius(balls, 0, -kInfinity).has_value());
}

}  // namespace
}  // namespace orthoball
