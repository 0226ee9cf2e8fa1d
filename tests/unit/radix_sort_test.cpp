// SPDX-License-Identifier: MIT
#include "orthoball/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>

namespace orthoball {
namespace {

void check_sorted(RawVector<KeyedRow> rows, Threads threads = Threads(1)) {
  RawVector<KeyedRow> expected = rows;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const KeyedRow& a, const KeyedRow& b) { return a.key < b.key; });
  radix_sort(rows, threads);
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].key, expected[i].key) << i;
    ASSERT_EQ(rows[i].row, expected[i].row) << i;
  }
}

// Keys that differ in `bits` bits from `low` on, a part of them equal.
RawVector<KeyedRow> rows_of(std::size_t size, unsigned bits, unsigned low, unsigned seed) {
  std::mt19937_64 random(seed);
  const std::uint64_t same = random();
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max() >> (64 - bits);
  RawVector<KeyedRow> rows;
  for (std::uint32_t row = 0; row < size; ++row) {
    const std::uint64_t key = ((random() & most) << low) ^ same;
    rows.push_back({row % 5 == 4 ? rows[random() % row].key : key, row});
  }
  return rows;
}

TEST(RadixSort, SortsStablyWhateverBitsDiffer) {
  for (const std::size_t size : {0U, 1U, 2U, 20U, 25U, 300U, 5000U}) {
    for (const unsigned bits : {1U, 10U, 11U, 12U, 33U, 34U, 63U, 64U}) {
      for (const unsigned low : {0U, 1U, 30U}) {
        if (bits + low > 64) continue;
        SCOPED_TRACE(testing::Message() << size << " keys, bits " << low << " to " << low + bits);
        check_sorted(rows_of(size, bits, low, 7));
      }
    }
  }
}

TEST(RadixSort, SortsManyThatAgreeInAllButTheirLastBits) {
  RawVector<KeyedRow> rows = rows_of(3000, 20, 0, 1);
  rows.push_back({std::uint64_t{1} << 63U, 3000});  // and one far away
  check_sorted(rows);
  for (KeyedRow& row : rows) row.key = 5;
  check_sorted(rows);
}

TEST(RadixSort, SortsStablyOnSeveralThreads) {
  for (const std::size_t size : {40'000U, 150'000U}) {
    for (const unsigned bits : {1U, 2U, 11U, 34U, 64U}) {
      SCOPED_TRACE(testing::Message() << size << " keys of " << bits << " bits");
      RawVector<KeyedRow> rows = rows_of(size, bits, 0, 3);
      check_sorted(rows, Threads(2));
      check_sorted(rows, Threads(7));
      if (bits < 34) rows.back().key ^= std::uint64_t{1} << 63U;  // one far from all others
      check_sorted(rows, Threads(4));
    }
  }
  RawVector<KeyedRow> same = rows_of(40'000, 1, 0, 3);
  for (KeyedRow& row : same) row.key = 5;
  check_sorted(same, Threads(2));
}

}  // namespace
}  // namespace orthoball
