// SPDX-License-Identifier: MIT
#include "orthoball/filtration/label_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "orthoball/radix_sort.h"

namespace orthoball {
namespace {

// Sorted, and every row still beside its label.
void expect_sorted(const std::vector<double>& given) {
  std::vector<double> labels = given;
  std::vector<std::uint32_t> rows(given.size());
  std::iota(rows.begin(), rows.end(), 0U);
  sort_labels(labels, rows);
  for (std::size_t i = 0; i < given.size(); ++i) {
    ASSERT_EQ(ordered_key(labels[i]), ordered_key(given[rows[i]]));
    ASSERT_TRUE(i == 0 || ordered_key(labels[i - 1]) <= ordered_key(labels[i])) << "at " << i;
  }
  std::sort(rows.begin(), rows.end());
  ASSERT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end());
}

TEST(SortLabels, SortsAnyMixOfMagnitudes) {
  std::uint64_t state = 3;
  const auto random = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) * 0x1p-53;
  };
  for (const std::size_t count : {0U, 1U, 2U, 24U, 25U, 300U, 70000U}) {
    std::vector<double> uniform(count), wide(count), few(count), equal(count, -2.5);
    for (std::size_t i = 0; i < count; ++i) {
      uniform[i] = random();
      wide[i] = std::ldexp(random() - 0.5, static_cast<int>(1000 * random()) - 500);
      few[i] = std::floor(3 * random());
    }
    expect_sorted(uniform);
    expect_sorted(wide);
    expect_sorted(few);
    expect_sorted(equal);
  }
}

TEST(SortLabels, PutsNegativeZeroBeforeZeroAndInfinitiesAtTheEnds) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> labels{0.0, infinity, -0.0, -infinity, 1.0, -1.0};
  std::vector<std::uint32_t> rows{0, 1, 2, 3, 4, 5};
  sort_labels(labels, rows);
  EXPECT_EQ(rows, (std::vector<std::uint32_t>{3, 5, 2, 0, 4, 1}));
}

}  // namespace
}  // namespace orthoball
