// SPDX-License-Identifier: MIT
#include "orthoball/measures/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <vector>

#include "generators/random.h"

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

// Of any length and alignment, and nothing is written beyond them.
TEST(Angle, OfManyAtOnceHasTheBitsOfEach) {
  generators::Random random(1);
  for (std::size_t size = 0; size <= 40; ++size) {
    for (std::size_t begin = 0; begin < 4; ++begin) {
      std::vector<double> x(begin + size), y(begin + size), angles(begin + size + 1, -7.0);
      for (std::size_t i = 0; i < begin + size; ++i) {
        x[i] = random.integer(-3, 3) * std::ldexp(1.0, random.integer(-60, 60)) * random.uniform();
        y[i] = random.integer(0, 3) * std::ldexp(1.0, random.integer(-60, 60)) * random.uniform();
      }
      angles_from_x_axis(std::span(x).subspan(begin), std::span(y).subspan(begin),
                         std::span(angles).subspan(begin, size));
      for (std::size_t i = 0; i <= begin + size; ++i) {
        const bool is_asked = i >= begin && i < begin + size;
        const double expected = is_asked ? angle_from_x_axis(x[i], y[i]) : -7.0;
        ASSERT_EQ(std::memcmp(&angles[i], &expected, sizeof expected), 0) << size << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace orthoball
