// SPDX-License-Identifier: MIT
#include "orthoball/measures/compensated_sum.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace orthoball
