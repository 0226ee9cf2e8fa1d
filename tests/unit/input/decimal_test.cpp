// SPDX-License-Identifier: MIT
#include "orthoball/input/decimal.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace orthoball {
namespace {

struct Decimal {
  const char* text;
  long long digits;
  int exponent;
};

TEST(ParseDecimal, KeepsTheDigitsWithoutTrailingZeros) {
  for (const Decimal& decimal : {Decimal{"0.1", 1, -1},
                                 {"1.50e-2", 15, -3},
                                 {"-12.340", -1234, -2},
                                 {"+7", 7, 0},
                                 {".0224", 224, -4},
                                 {"5.", 5, 0},
                                 {"1200", 12, 2},
                                 {"1.0D+01", 1, 1},
                                 {"2.5d1", 25, 0},
                                 {"9223372036854775807", 9223372036854775807LL, 0},
                                 {"00000000000000000000000.250000000000000000000", 25, -2},
                                 {"-7.515480024991e-007", -7515480024991LL, -19}}) {
    const DecimalParse parse = parse_decimal(decimal.text);
    EXPECT_EQ(parse.fault, DecimalFault::none) << decimal.text;
    EXPECT_TRUE(parse.number.is_exact) << decimal.text;
    EXPECT_TRUE(parse.number.digits == decimal.digits) << decimal.text;
    EXPECT_EQ(parse.number.exponent, decimal.exponent) << decimal.text;
  }
}

TEST(ParseDecimal, TellsWhatIsWrong) {
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1,5", "12.3x4", "0x1p3", " 1", "1 ",
                           "--1", "1.2.3", "********", "=1+1", "infinit", "nano", "1e5.0"}) {
    EXPECT_EQ(parse_decimal(text).fault, DecimalFault::not_a_number) << text;
  }
  for (const char* text : {"nan", "NaN", "-inf", "Infinity", "nan(0x1)"}) {
    EXPECT_EQ(parse_decimal(text).fault, DecimalFault::not_finite) << text;
  }
  for (const char* text : {"1e400", "-1e400", "1.8e308", "1e99999999999999999999"}) {
    EXPECT_EQ(parse_decimal(text).fault, DecimalFault::out_of_range) << text;
  }
}

TEST(ParseDecimal, ReadsNegativeZeroAndVanishingNumbersAsZero) {
  for (const char* text : {"-0", "-0.0", "0e999", "1e-400", "-1e-400", "1e-99999999999999999999"}) {
    const DecimalParse parse = parse_decimal(text);
    EXPECT_EQ(parse.fault, DecimalFault::none) << text;
    EXPECT_TRUE(parse.number.is_exact && parse.number.digits == 0) << text;
    EXPECT_EQ(parse.number.nearest, 0.0);
    EXPECT_FALSE(std::signbit(parse.number.nearest)) << text;
  }
}

TEST(ParseDecimal, KeepsThirtyEightDigits) {
  const std::string nines(38, '9');
  const DecimalParse exact = parse_decimal("0." + nines + "000");
  EXPECT_TRUE(exact.number.is_exact);
  EXPECT_EQ(exact.number.exponent, -38);
  EXPECT_TRUE(exact.number.digits % 1000000000 == 999999999);
  EXPECT_FALSE(parse_decimal(nines + "9").number.is_exact);
  EXPECT_EQ(parse_decimal(nines + "9").number.nearest, 1e39);
}

TEST(ParseDecimal, RoundsAsTheCLibraryDoes) {
  std::mt19937_64 random(7);
  std::array<char, 400> text{};
  for (int i = 0; i < 100000; ++i) {
    const double number =
        std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 2000) - 1060);
    std::snprintf(text.data(), text.size(), i % 2 == 0 ? "%.*e" : "%.*g",
                  static_cast<int>(random() % 30), number);
    const double expected = std::strtod(text.data(), nullptr);
    const DecimalParse parse = parse_decimal(text.data());
    if (std::isinf(expected)) {
      EXPECT_EQ(parse.fault, DecimalFault::out_of_range) << text.data();
      continue;
    }
    ASSERT_EQ(parse.number.nearest, expected) << text.data();
    if (!parse.number.is_exact) continue;
    ASSERT_EQ(decimal_number(parse.number.digits, parse.number.exponent).nearest, expected)
        << text.data();
  }
}

TEST(ParseDecimal, IsLinearInTheLengthOfTheText) {
  const std::string million(1000000, '1');
  EXPECT_EQ(parse_decimal(million).fault, DecimalFault::out_of_range);
  EXPECT_EQ(parse_decimal("0." + million).number.nearest, 1.0 / 9.0);
  EXPECT_EQ(parse_decimal("0." + std::string(1000000, '0') + "25e1000000").number.nearest, 0.25);
  EXPECT_TRUE(parse_decimal("0." + std::string(1000000, '0') + "25e1000000").number.digits == 25);
}

WeightedPoints points_of(const std::vector<std::array<const char*, 3>>& rows, WeightKind kind) {
  DecimalRows decimals(2, kind);
  for (const auto& row : rows) {
    const std::array coordinates = {parse_decimal(row[0]).number, parse_decimal(row[1]).number};
    decimals.add(coordinates, parse_decimal(row[2]).number);
  }
  return std::move(decimals).points();
}

TEST(DecimalRows, CountsInTheSmallestUnitThatHoldsAll) {
  const WeightedPoints points =
      points_of({{"1", "0.5", "1.50"}, {"1.50e-2", "-2", "0.1"}}, WeightKind::radius);
  ASSERT_EQ(points.decimals(), 3);
  EXPECT_EQ(points.coordinates()[0], 1000.0);
  EXPECT_EQ(points.coordinates()[1], 500.0);
  EXPECT_EQ(points.coordinates()[2], 15.0);
  EXPECT_EQ(points.coordinates()[3], -2000.0);
  EXPECT_EQ(points.weights()[0], 1500.0);
  EXPECT_EQ(points.coordinate(1, 0), 0.015);
}

TEST(DecimalRows, WeightsNeedHalfTheirDecimalsRoundedUp) {
  const WeightedPoints points = points_of({{"1", "2", "0.001"}}, WeightKind::weight);
  ASSERT_EQ(points.decimals(), 2);
  EXPECT_EQ(points.coordinates()[0], 100.0);
  EXPECT_EQ(points.weights()[0], 10.0);  // in units of 10^-4
  EXPECT_TRUE(points.weights_low().empty());
}

TEST(DecimalRows, WeightsOfOneHundredAndSixBitsAreExact) {
  const WeightedPoints points =
      points_of({{"0", "0", "-81129638414606663681390495662081"}}, WeightKind::weight);
  ASSERT_EQ(points.decimals(), 0);
  ASSERT_EQ(points.weights_low().size(), 1U);  // (2^53 - 1)^2 = 2^106 - 2^54 + 1
  EXPECT_EQ(points.weights()[0], -(std::ldexp(1.0, 106) - std::ldexp(1.0, 54)));
  EXPECT_EQ(points.weights_low()[0], -1.0);
  EXPECT_FALSE(
      points_of({{"0", "0", "81129638414606681695789005144065"}}, WeightKind::weight).decimals());
}

TEST(DecimalRows, LowPartsSurviveMoreDecimals) {
  const WeightedPoints points =
      points_of({{"0", "0", "9007199254740993"}, {"0.1", "0", "1"}}, WeightKind::weight);
  ASSERT_EQ(points.decimals(), 1);
  EXPECT_EQ(points.weights()[0] + points.weights_low()[0], 900719925474099300.0);
  EXPECT_EQ(points.weights()[1], 100.0);
}

TEST(DecimalRows, OneNumberThatDoesNotFitMakesAllOfThemDoubles) {
  for (const char* misfit : {"9007199254740993", "0.10000000000000001", "1e16", "1e-17"}) {
    const WeightedPoints points = points_of(
        {{"0.1", "0.3", "0.7"}, {misfit, "1", "1"}, {"0.2", "2.5", "2"}}, WeightKind::radius);
    EXPECT_FALSE(points.decimals()) << misfit;
    EXPECT_EQ(points.coordinates()[0], 0.1);
    EXPECT_EQ(points.coordinates()[1], 0.3);
    EXPECT_EQ(points.weights()[0], 0.7);
    EXPECT_EQ(points.coordinates()[2], std::strtod(misfit, nullptr));
    EXPECT_EQ(points.coordinates()[4], 0.2);
  }
  EXPECT_EQ(points_of({{"9007199254740992", "1", "0"}}, WeightKind::radius).decimals(), 0);
}

TEST(DecimalRows, DoublesOfWeightsAreTheNearest) {
  const WeightedPoints points =
      points_of({{"0.1", "0", "0.30000000000000004"}, {"1e300", "0", "1"}}, WeightKind::weight);
  EXPECT_FALSE(points.decimals());
  EXPECT_EQ(points.weights()[0], 0.30000000000000004);
}

TEST(DecimalRows, NumbersNearZeroStayDistinct) {
  const WeightedPoints points =
      points_of({{"4.9406564584124654e-324", "0", "0"}, {"0", "0", "0"}}, WeightKind::none);
  EXPECT_GT(points.coordinates()[0], 0.0);
  EXPECT_EQ(points.coordinate(0, 0), std::numeric_limits<double>::denorm_min());
}

TEST(DecimalRows, NoRowsMakeNoPoints) { EXPECT_EQ(points_of({}, WeightKind::weight).size(), 0U); }

}  // namespace
}  // namespace orthoball
