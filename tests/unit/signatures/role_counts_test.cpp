// SPDX-License-Identifier: MIT
#include "orthoball/signatures/role_counts.h"

#include <gtest/gtest.h>

namespace orthoball {
namespace {

TEST(IndexHistogram, CountsMoreThanAByteHolds) {
  IndexHistogram histogram(5);
  for (int i = 0; i < 1000; ++i) histogram.add(3);
  for (int i = 0; i < 256; ++i) histogram.add(1);
  histogram.add(5);
  histogram.finish();
  EXPECT_EQ(histogram.count(0), 0U);
  EXPECT_EQ(histogram.count(1), 256U);
  EXPECT_EQ(histogram.count(2), 0U);
  EXPECT_EQ(histogram.count(3), 1000U);
  EXPECT_EQ(histogram.count(4), 0U);
  EXPECT_EQ(histogram.count(5), 1U);
}

TEST(RoleCounts, OfNothingAreZero) {
  RoleCounts<3> none{Filtration<3>()};
  EXPECT_TRUE(none.has_all_vertices());
  EXPECT_TRUE(none.has_no_singular());
  EXPECT_EQ(none.euler(), 0);
}

}  // namespace
}  // namespace orthoball
