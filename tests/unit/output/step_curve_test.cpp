// SPDX-License-Identifier: MIT
#include "orthoball/output/step_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace orthoball {
namespace {

TEST(StepCurve, KeepsEveryStepWhereThereAreFew) {
  StepCurve curve(100.0);
  curve.add(10.0, 3.0);
  curve.add(20.25, 1.0);
  ASSERT_EQ(curve.columns().size(), 2U);
  EXPECT_EQ(curve.columns()[0].x, 10.0);
  EXPECT_EQ(curve.columns()[1].x, 20.25);
  EXPECT_EQ(curve.columns()[1].last, 1.0);
}

TEST(StepCurve, MillionsOfStepsLeaveTheExtremesOfEachHalfPixel) {
  StepCurve curve(100.0);
  const int count = 2000000;
  for (int i = 0; i < count; ++i) {
    const double x = 100.0 * (i + 1) / count;
    curve.add(x, i % 1000 == 777 ? 50.0 : std::sin(x));
  }
  EXPECT_LE(curve.columns().size(), 201U);
  for (const StepColumn& column : curve.columns()) {
    if (column.x >= 99.9) continue;
    EXPECT_EQ(column.high, 50.0);
    EXPECT_LE(column.low, std::sin(column.x));
    EXPECT_NEAR(column.last, std::sin(column.x), 0.6);
  }
}

TEST(StepCurve, StepsBeforeThePictureSetItsFirstValueAndStepsBehindItAreLeftOut) {
  StepCurve curve(100.0);
  curve.add(-5.0, 7.0);
  curve.add(0.0, 4.0);
  curve.add(101.0, 99.0);
  EXPECT_EQ(curve.initial(), 4.0);
  EXPECT_TRUE(curve.columns().empty());
  EXPECT_EQ(curve.high(), 4.0);
}

TEST(StepCurve, BeginsAtZeroWithoutAnyStep) {
  const StepCurve curve(100.0);
  EXPECT_EQ(curve.initial(), 0.0);
  EXPECT_EQ(curve.low(), 0.0);
}

}  // namespace
}  // namespace orthoball
