// SPDX-License-Identifier: MIT
#include "orthoball/filtration/key_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace orthoball {
namespace {

// Sorted, and every row still beside its key.
void expect_sorted(KeySorter& sorter, const std::vector<std::uint64_t>& given) {
  std::vector<std::uint64_t> keys = given;
  std::vector<std::uint32_t> rows(given.size());
  std::iota(rows.begin(), rows.end(), 0U);
  sorter.sort(keys, rows);
  for (std::size_t i = 0; i < given.size(); ++i) {
    ASSERT_EQ(keys[i], given[rows[i]]);
    ASSERT_TRUE(i == 0 || keys[i - 1] <= keys[i]) << "at " << i;
  }
  std::sort(rows.begin(), rows.end());
  ASSERT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end());
}

TEST(KeySorter, SortsAnyMixOfKeys) {
  std::uint64_t state = 3;
  const auto random = [&] { return state = state * 6364136223846793005U + 1442695040888963407U; };
  KeySorter sorter;
  for (const std::size_t count : {0U, 1U, 2U, 24U, 25U, 300U, 70000U}) {
    std::vector<std::uint64_t> whole(count), near(count), far(count), few(count), equal(count, 7);
    for (std::size_t i = 0; i < count; ++i) {
      whole[i] = random();
      near[i] = (std::uint64_t{1} << 40U) - 100 + (random() >> 56U);
      far[i] = random() >> (random() >> 58U);
      few[i] = random() >> 62U;
    }
    for (const auto& keys : {whole, near, far, few, equal}) expect_sorted(sorter, keys);
  }
}

TEST(KeySorter, TakesTheWholeRange) {
  KeySorter sorter;
  std::vector<std::uint64_t> keys(40, 5);
  keys[3] = ~std::uint64_t{0};
  keys[30] = 0;
  expect_sorted(sorter, keys);
}

}  // namespace
}  // namespace orthoball
