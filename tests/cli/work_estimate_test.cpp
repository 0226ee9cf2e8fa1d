// SPDX-License-Identifier: MIT
#include "cli/work_estimate.h"

#include <gtest/gtest.h>

namespace {

WorkEstimate estimate_of_a_million() {
  WorkEstimate estimate(
      {Stage::reading, Stage::triangulation, Stage::filtration, Stage::signatures});
  estimate.begin(Stage::reading, 0.0);
  estimate.end(0.1);
  estimate.expect_sites(1'000'000, 3);
  return estimate;
}

TEST(WorkEstimate, KnowsNothingBeforeTheSizeOfTheInput) {
  WorkEstimate estimate({Stage::reading, Stage::triangulation});
  estimate.begin(Stage::reading, 0.0);
  EXPECT_FALSE(estimate.guess(1.0));
  estimate.expect_bytes(3e9);
  ASSERT_TRUE(estimate.guess(1.0));
  EXPECT_GT(estimate.guess(1.0)->seconds_left, 60.0);
}

TEST(WorkEstimate, CountsDownAsTheWorkGoesOn) {
  WorkEstimate estimate = estimate_of_a_million();
  estimate.begin(Stage::triangulation, 0.1);
  const auto first = estimate.guess(0.1), later = estimate.guess(1.1);
  ASSERT_TRUE(first && later);
  EXPECT_NEAR(first->seconds_left - later->seconds_left, 1.0, 1e-9);
  EXPECT_LT(first->share, later->share);
}

TEST(WorkEstimate, LearnsFromStagesThatAreOver) {
  WorkEstimate quick = estimate_of_a_million(), slow = estimate_of_a_million();
  quick.begin(Stage::triangulation, 0.1);
  slow.begin(Stage::triangulation, 0.1);
  quick.begin(Stage::filtration, 2.1);
  slow.begin(Stage::filtration, 10.1);
  EXPECT_NEAR(slow.guess(10.1)->seconds_left, 5.0 * quick.guess(2.1)->seconds_left, 1e-9);
}

TEST(WorkEstimate, IsNeverDoneBeforeTheEnd) {
  WorkEstimate estimate = estimate_of_a_million();
  estimate.begin(Stage::signatures, 5.0);
  const auto late = estimate.guess(1000.0);
  ASSERT_TRUE(late);
  EXPECT_LT(late->share, 1.0);
  EXPECT_GT(late->seconds_left, 0.0);
  estimate.end(1000.0);
  EXPECT_EQ(estimate.guess(1000.0)->share, 1.0);
}

TEST(WorkEstimate, BelievesAStageThatCountsItsWork) {
  WorkEstimate estimate = estimate_of_a_million();
  estimate.begin(Stage::signatures, 10.0);
  estimate.reach(0.25);
  EXPECT_NEAR(estimate.guess(12.0)->seconds_left, 6.0, 1e-9);
}

TEST(WorkEstimate, LeavesOutStagesThatNeverCame) {
  WorkEstimate estimate = estimate_of_a_million();
  estimate.begin(Stage::signatures, 0.1);
  estimate.end(4.0);
  EXPECT_NEAR(estimate.guess(4.0)->seconds_left, 0.0, 1e-9);
}

}  // namespace
