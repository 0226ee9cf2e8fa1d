// SPDX-License-Identifier: MIT
#include "orthoball/measures/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace orthoball {
namespace {

TEST(Angle, AgreesWithTheCLibraryAllAround) {
  double worst = 0.0;
  for (int i = 0; i <= 200000; ++i) {
    const double turn = std::numbers::pi * i / 200000;
    const double x = 1e3 * std::cos(turn), y = std::abs(1e3 * std::sin(turn));
    const double expected = std::atan2(y, x);
    worst = std::max(worst, std::abs(angle_from_x_axis(x, y) - expected) / std::max(1.0, expected));
  }
  EXPECT_LT(worst, 4 * 0x1p-53);  // 3 of ours and 1 of the library
}

TEST(Angle, IsExactOnTheAxesAndTheDiagonals) {
  EXPECT_EQ(angle_from_x_axis(2.0, 0.0), 0.0);
  EXPECT_EQ(angle_from_x_axis(2.0, 2.0), std::numbers::pi / 4);
  EXPECT_EQ(angle_from_x_axis(0.0, 2.0), std::numbers::pi / 2);
  EXPECT_EQ(angle_from_x_axis(-2.0, 2.0), 3 * std::numbers::pi / 4);
  EXPECT_EQ(angle_from_x_axis(-2.0, 0.0), std::numbers::pi);
}

TEST(Angle, IsZeroForTheZeroVector) { EXPECT_EQ(angle_from_x_axis(0.0, 0.0), 0.0); }

TEST(Angle, KeepsRelativeErrorForSmallAngles) {
  for (double y = 1.0; y > 1e-300; y *= 0.37) {
    EXPECT_NEAR(angle_from_x_axis(3.0, y) / std::atan2(y, 3.0), 1.0, 4 * 0x1p-53) << y;
  }
}

}  // namespace
}  // namespace orthoball
