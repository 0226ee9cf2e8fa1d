// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filter_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace orthoball {
namespace {

// Simplices with indices from 1 to `indices`, each of which one of the last has, which are not
// attached; of the others one in `attached` is.
void expect_sorted(std::uint32_t simplices, std::uint32_t indices, std::uint32_t attached) {
  std::uint64_t state = simplices + indices + attached;
  const auto random = [&](std::uint32_t below) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>((state >> 32U) % below);
  };
  std::vector<std::uint32_t> enters(simplices);
  std::vector<std::uint64_t> is_attached(simplices / 64 + 1, 0);
  for (std::uint32_t i = 0; i < simplices; ++i) {
    const bool is_last = i >= simplices - indices;
    enters[i] = is_last ? simplices - i : 1 + random(indices);
    if (!is_last && random(attached) == 0) is_attached[i / 64] |= std::uint64_t{1} << i % 64;
  }
  std::vector<SimplexId> expected;
  for (std::uint32_t i = 0; i < simplices; ++i) expected.emplace_back(i);
  std::stable_sort(expected.begin(), expected.end(),
                   [&](SimplexId a, SimplexId b) { return enters[a.row()] < enters[b.row()]; });
  std::vector<SimplexId> order;
  for (const SimplexId simplex : expected) {
    if ((is_attached[simplex.row() / 64] >> simplex.row() % 64 & 1U) == 0) order.push_back(simplex);
  }
  RankedBits starts(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    if (i == 0 || enters[order[i].row()] != enters[order[i - 1].row()]) starts.add(i);
  }
  starts.count_all();

  for (const unsigned threads : {1U, 3U}) {
    std::vector<SimplexId> filter(simplices);
    const auto index_starts =
        fill_filter(order, starts, enters, is_attached, Threads(threads), filter);
    ASSERT_EQ(filter, expected);
    for (std::size_t i = 0; i <= simplices; ++i) {
      const bool is_start =
          i == 0 || i == simplices || enters[filter[i].row()] != enters[filter[i - 1].row()];
      ASSERT_EQ((index_starts[i / 64] >> i % 64 & 1U) != 0, is_start) << "at " << i;
    }
  }
}

TEST(FilterOrder, PutsAttachedSimplicesWhereTheyEnter) {
  expect_sorted(1, 1, 1);
  expect_sorted(1000, 1, 2);
  expect_sorted(1000, 1000, 1);
  expect_sorted(1000, 30, 2);
  expect_sorted(500000, 200000, 1);
  expect_sorted(500000, 40000, 3);
}

TEST(FilterOrder, OfNothingHasOneStart) {
  RankedBits starts(0);
  starts.count_all();
  const std::vector<std::uint64_t> none{0};
  EXPECT_EQ(fill_filter({}, starts, {}, none, Threads(2), {}), (std::vector<std::uint64_t>{1}));
}

}  // namespace
}  // namespace orthoball
