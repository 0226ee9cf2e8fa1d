// SPDX-License-Identifier: MIT
#include "orthoball/filtration/index_counts.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

namespace orthoball {
namespace {

IndexCounts counts_of(std::uint32_t largest, const std::vector<std::uint32_t>& indices) {
  return {largest, [&](const auto& visit) {
            for (const std::uint32_t index : indices) visit(index);
          }};
}

TEST(IndexCounts, OfNothingAreZero) {
  IndexCounts none = counts_of(100000, {});
  for (std::uint32_t index = 0; index <= 100000; index += 999) EXPECT_EQ(none.count(index), 0U);
}

TEST(IndexCounts, CountsOneIndexOften) {
  IndexCounts counts = counts_of(5, std::vector<std::uint32_t>(100000, 3));
  EXPECT_EQ(counts.count(0), 0U);
  EXPECT_EQ(counts.count(3), 100000U);
  EXPECT_EQ(counts.count(3), 100000U);
  EXPECT_EQ(counts.count(4), 0U);
}

TEST(IndexCounts, CountsAcrossStretches) {
  std::vector<std::uint32_t> indices;
  std::map<std::uint32_t, std::uint32_t> expected;
  std::uint32_t state = 1;
  for (int i = 0; i < 30000; ++i) {
    state = state * 1664525U + 1013904223U;
    indices.push_back((state >> 8U) % 100001U);
    ++expected[indices.back()];
  }
  IndexCounts counts = counts_of(100000, indices);
  for (std::uint32_t index = 0; index <= 100000; ++index) {
    ASSERT_EQ(counts.count(index), expected[index]) << index;
  }
}

TEST(IndexCounts, CountsAStretchAtATime) {
  const IndexCounts counts = counts_of(5, {3, 5, 3});
  std::vector<std::uint32_t> stretch(kIndexStretch, 7);
  counts.count_stretch(0, stretch);
  EXPECT_EQ(stretch[3], 2U);
  EXPECT_EQ(stretch[4], 0U);
  EXPECT_EQ(stretch[5], 1U);
  counts.count_stretch(1, stretch);  // beyond the largest
  EXPECT_EQ(stretch[3], 0U);
}

TEST(IndexCounts, SkipsStretchesAndReachesTheLargestIndices) {
  IndexCounts counts = counts_of(0xFFFFFFFFU, {0xFFFFFFFFU, 7, 0xFFFFFFFEU, 0xFFFFFFFFU});
  EXPECT_EQ(counts.count(7), 1U);
  EXPECT_EQ(counts.count(0xFFFFFFFEU), 1U);
  EXPECT_EQ(counts.count(0xFFFFFFFFU), 2U);
}

}  // namespace
}  // namespace orthoball
