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

}  // namespace
}  // namespace orthoball
