// SPDX-License-Identifier: MIT
#include "orthoball/filtration/interval_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace orthoball {
namespace {

std::vector<std::uint32_t> rows_at(const IntervalTree& tree, std::uint32_t index) {
  std::vector<std::uint32_t> rows;
  tree.for_each_containing(index, [&](std::uint32_t row) { rows.push_back(row); });
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST(IntervalTree, FindsWhatAScanFinds) {
  std::uint64_t state = 1;
  const auto random = [&](std::uint32_t below) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>((state >> 33U) % below);
  };
  for (const std::uint32_t top : {1U, 2U, 5U, 64U, 1000U}) {
    for (int round = 0; round < 40; ++round) {
      std::vector<IndexInterval> intervals(random(80));
      for (IndexInterval& interval : intervals) interval = {random(top), random(top + 2)};
      const IntervalTree tree(intervals);
      for (std::uint32_t index = 0; index <= top + 2; ++index) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t row = 0; row < intervals.size(); ++row) {
          if (intervals[row].begin <= index && index < intervals[row].end) expected.push_back(row);
        }
        ASSERT_EQ(rows_at(tree, index), expected) << "index " << index << " of " << top;
      }
    }
  }
}

TEST(IntervalTree, DoesNotStoreEmptyIntervals) {
  const std::vector<IndexInterval> intervals{{3, 3}, {5, 4}, {2, 7}};
  EXPECT_EQ(IntervalTree(intervals).size(), 1U);
  EXPECT_EQ(rows_at(IntervalTree(intervals), 3), std::vector<std::uint32_t>{2});
  EXPECT_TRUE(rows_at(IntervalTree(), 3).empty());
}

}  // namespace
}  // namespace orthoball
