// SPDX-License-Identifier: MIT
#include "orthoball/measures/compensated_sum.h"

#include <gtest/gtest.h>

#include <limits>

namespace orthoball {
namespace {

TEST(CompensatedSum, KeepsWhatASumOfDoublesLoses) {
  CompensatedSum sum;
  sum.add(1.0);
  for (int i = 0; i < 1000; ++i) sum.add(0x1p-60);
  sum.add(-1.0);
  EXPECT_EQ(sum.value().high, 1000 * 0x1p-60);
}

TEST(CompensatedSum, ReturnsToZeroWhenTermsAreTakenAway) {
  CompensatedSum sum;
  for (int i = 1; i < 1000; ++i) sum.add(1.0 / i);
  for (int i = 1; i < 1000; ++i) sum.add(-1.0 / i);
  EXPECT_EQ(sum.value().high, 0.0);
}

TEST(CompensatedSum, CountsTermsThatCouldOverflow) {
  CompensatedSum sum;
  sum.add(2.0);
  sum.add(std::numeric_limits<double>::infinity());
  sum.add(0x1p+961);
  EXPECT_EQ(sum.value().high, 2.0);
  EXPECT_EQ(sum.large_count(), 2U);
}

}  // namespace
}  // namespace orthoball
