// SPDX-License-Identifier: MIT
#include "orthoball/measures/scaled_balls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

TEST(ScaledBalls, AreTheSpheresAtTheirAlpha2) {
  const Filtration<3> filtration(
      regular_triangulation<3>(WeightedPoints(3, {0, 0, 0, 4, 0, 0}, WeightKind::weight, {1, -3})));
  const ScaledBalls<3> balls(filtration, 0, 1.25);
  ASSERT_EQ(balls.spheres().size(), 2U);
  for (std::uint32_t vertex = 0; vertex < 2; ++vertex) {
    const bool is_first = filtration.triangulation().sites().row(vertex).row() == 0;
    const InputUnits lengths = balls.units(1), areas = balls.units(2);
    EXPECT_EQ(lengths({balls.spheres()[vertex].radius, 0.0}), is_first ? 1.5 : 0.0);
    EXPECT_EQ(areas({balls.spheres()[vertex].weight, 0.0}), is_first ? 1.0 : -3.0);
  }
  // Where volumes would overflow lengths are smaller, by a power of two.
  const ScaledBalls<3> huge(filtration, 1, 1e300);
  for (const Sphere<3>& sphere : huge.spheres()) {
    EXPECT_LT(sphere.radius, 0x1p+301);
    EXPECT_NEAR(huge.units(1)({sphere.radius, 0.0}), 1e150, 1e135);
  }
}

TEST(ScaledBalls, TurnNumbersIntoInputUnitsAndBack) {
  const Filtration<2> filtration(regular_triangulation<2>(
      WeightedPoints::fixed_point(2, 3, {0, 0, 1250, 0}, WeightKind::none, {})));
  const ScaledBalls<2> balls(filtration, 1, 0.25);
  EXPECT_EQ(balls.units(1)({balls.spheres()[0].radius, 0.0}), 0.5);
  EXPECT_EQ(balls.units(2)({balls.from_input(0.375, 2), 0.0}), 0.375);
}

TEST(ScaledBalls, RefuseAnIndexOrAlphaThatIsNone) {
  const Filtration<2> filtration(
      regular_triangulation<2>(WeightedPoints(2, {0, 0, 1, 0}, WeightKind::none, {})));
  EXPECT_NO_THROW(ScaledBalls<2>(filtration, 0, -HUGE_VAL));
  EXPECT_THROW(ScaledBalls<2>(filtration, 3, 1.0), InputError);
  EXPECT_THROW(ScaledBalls<2>(filtration, 2, HUGE_VAL), InputError);
  EXPECT_THROW(ScaledBalls<2>(filtration, 2, std::nan("")), InputError);
}

}  // namespace
}  // namespace orthoball
