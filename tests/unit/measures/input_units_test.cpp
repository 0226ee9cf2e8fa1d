// SPDX-License-Identifier: MIT
#include "orthoball/measures/input_units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace orthoball {
namespace {

TEST(InputUnits, GiveTheDoubleNearestToADecimal) {
  // 123456789 units of 10^-3 cubed, a volume that is 6 times too large and scaled by 2^5.
  const InputUnits units(3, 5, 3, 6);
  EXPECT_EQ(units({6.0 * 0x1p+15 * 123456789.0, 0.0}), 0.123456789);
  for (int decimals = 0; decimals <= 30; ++decimals) {
    for (int power = 1; power <= 3; ++power) {
      const std::string text = "7e-" + std::to_string(power * decimals);
      EXPECT_EQ(InputUnits(power, 0, decimals, 1)({7.0, 0.0}), std::strtod(text.c_str(), nullptr))
          << text;
    }
  }
}

TEST(InputUnits, RoundOnce) {
  // Halfway between two doubles but for the low part.
  const InputUnits units(1, -3, 0, 1);
  EXPECT_EQ(units({1.0, 0x1p-60}), 8.0);
  EXPECT_EQ(units({3.0, 0.0}), 24.0);
  EXPECT_EQ(InputUnits(1, 0, 1, 1)({1.0, 0.0}), 0.1);
}

TEST(InputUnits, OverflowToInfinityAndVanishBelow) {
  EXPECT_EQ(InputUnits(3, -400, 0, 6)({1.0, 0.0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(InputUnits(2, -600, 0, 2)({0.0, 0.0}), 0.0);
  EXPECT_EQ(InputUnits(3, 0, 400, 6)({1.0, 0.0}), 0.0);
  EXPECT_GT(InputUnits(1, 100, 300, 1)({0x1p+120, 0.0}), 0.0);
}

TEST(InputUnits, AreLeftTheWayTheyAreEntered) {
  for (const int scale_exponent : {-400, -7, 0, 3, 250}) {
    for (const int decimals : {0, 1, 3, 15, 40, 120}) {
      for (int power = 1; power <= 3; ++power) {
        const double value = 1.2345678901234567;
        const double scaled = from_input_units(value, power, scale_exponent, decimals);
        if (scaled == 0.0 || std::isinf(scaled) || std::abs(std::log2(scaled)) > 1000) continue;
        const double back = InputUnits(power, scale_exponent, decimals, 1)({scaled, 0.0});
        EXPECT_NEAR(back / value, 1.0, 4 * 0x1p-53)
            << power << ' ' << scale_exponent << ' ' << decimals;
      }
    }
  }
}

TEST(InputUnits, AreEnteredAsWholeUnitsOfDecimals) {
  EXPECT_EQ(from_input_units(0.25, 2, 0, 3), 250000.0);
  EXPECT_EQ(from_input_units(-1.5, 1, 0, 1), -15.0);
  EXPECT_EQ(from_input_units(0.0, 3, 7, 2), 0.0);
  // One unit of the points is 2^5 of the values.
  EXPECT_EQ(from_input_units(3.0, 1, 5, 0), 96.0);
  EXPECT_EQ(from_input_units(3.0, 2, 5, 0), 3072.0);
}

TEST(InputUnits, ThatAreEnteredOverflowAndVanishToo) {
  EXPECT_EQ(from_input_units(1.0, 3, 400, 0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(from_input_units(-1.0, 2, 0, 200), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(from_input_units(1.0, 3, -400, 0), 0.0);
  EXPECT_EQ(from_input_units(0x1p+1020, 1, -100, 1), 10 * 0x1p+920);  // not before it is scaled
}

}  // namespace
}  // namespace orthoball
