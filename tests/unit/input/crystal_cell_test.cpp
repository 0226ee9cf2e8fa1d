// SPDX-License-Identifier: MIT
#include "orthoball/input/crystal_cell.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace orthoball {
namespace {

using Numbers = std::array<double, 3>;

double dot(const Numbers& a, const Numbers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

TEST(CrystalCell, WithRightAnglesScalesEachAxis) {
  const auto cell = CrystalCell::of({2, 3, 5}, {90, 90, 90});
  ASSERT_TRUE(cell);
  EXPECT_EQ(cell->cartesian({0.5, 0.25, -1}), (Numbers{1, 0.75, -5}));
}

TEST(CrystalCell, HasItsLengthsAndAngles) {
  const Numbers lengths = {11.0829, 14.6829, 16.8532};
  const Numbers angles = {105.728, 100.31, 110.62};
  const auto cell = CrystalCell::of(lengths, angles);
  ASSERT_TRUE(cell);
  const std::array<Numbers, 3> axes = {cell->cartesian({1, 0, 0}), cell->cartesian({0, 1, 0}),
                                       cell->cartesian({0, 0, 1})};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::sqrt(dot(axes[i], axes[i])), lengths[i], 1e-12);
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double angle =
        std::acos(dot(axes[j], axes[k]) / (lengths[j] * lengths[k])) * 180.0 / std::acos(-1.0);
    EXPECT_NEAR(angle, angles[i], 1e-11);
  }
  EXPECT_EQ(axes[0][1], 0.0);
  EXPECT_EQ(axes[0][2], 0.0);
  EXPECT_EQ(axes[1][2], 0.0);
}

TEST(CrystalCell, ThatCannotCloseIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CrystalCell::of({0, 1, 1}, {90, 90, 90}));
  EXPECT_FALSE(CrystalCell::of({1, -1, 1}, {90, 90, 90}));
  EXPECT_FALSE(CrystalCell::of({1, 1, nan}, {90, 90, 90}));
  EXPECT_FALSE(CrystalCell::of({1, 1, 1}, {180, 90, 90}));
  EXPECT_FALSE(CrystalCell::of({1, 1, 1}, {90, nan, 90}));
  EXPECT_FALSE(CrystalCell::of({1, 1, 1}, {120, 120, 120})) << "flat";
  EXPECT_FALSE(CrystalCell::of({1, 1, 1}, {150, 60, 60}));
}

}  // namespace
}  // namespace orthoball
