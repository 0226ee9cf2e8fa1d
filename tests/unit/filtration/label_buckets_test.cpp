// SPDX-License-Identifier: MIT
#include "orthoball/filtration/label_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace orthoball {
namespace {

// All labels come back, in order, and equal ones in one part.
void expect_in_order(const std::vector<double>& labels, const std::vector<double>& sample) {
  LabelBuckets buckets(labels.size(), sample);
  for (std::uint32_t row = 0; row < labels.size(); ++row) buckets.add(labels[row], row);
  EXPECT_EQ(buckets.size(), labels.size());
  std::vector<std::uint64_t> all;
  std::vector<std::uint32_t> rows;
  buckets.for_each_part([&](std::span<const std::uint64_t> keys, std::span<std::uint32_t> part) {
    ASSERT_EQ(keys.size(), part.size());
    if (!all.empty() && !keys.empty()) {
      ASSERT_LT(all.back(), keys.front());
    }
    all.insert(all.end(), keys.begin(), keys.end());
    rows.insert(rows.end(), part.begin(), part.end());
  });
  ASSERT_EQ(all.size(), labels.size());
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], ordered_key(labels[rows[i]]));
  std::sort(rows.begin(), rows.end());
  EXPECT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end());
}

TEST(LabelBuckets, GiveBackInOrderWhateverTheSample) {
  std::uint64_t state = 5;
  const auto random = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) * 0x1p-53;
  };
  for (const std::size_t count : {0U, 1U, 127U, 128U, 129U, 100000U}) {
    std::vector<double> uniform(count), wide(count), few(count);
    for (std::size_t i = 0; i < count; ++i) {
      uniform[i] = random();
      wide[i] = std::ldexp(random() - 0.5, static_cast<int>(1000 * random()) - 500);
      few[i] = std::floor(3 * random()) - 1;
    }
    const std::vector<double> part(wide.begin(),
                                   wide.begin() + static_cast<std::ptrdiff_t>(count / 50));
    for (const auto& labels : {uniform, wide, few}) {
      expect_in_order(labels, labels);
      expect_in_order(labels, part);
      expect_in_order(labels, {});
      expect_in_order(labels, {1e300});
    }
  }
}

TEST(LabelBuckets, PutNegativeZeroBeforeZeroAndInfinitiesAtTheEnds) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> labels{0.0, infinity, -0.0, -infinity, 1.0, -1.0};
  LabelBuckets buckets(labels.size(), labels);
  for (std::uint32_t row = 0; row < labels.size(); ++row) buckets.add(labels[row], row);
  std::vector<std::uint32_t> rows;
  buckets.for_each_part([&](std::span<const std::uint64_t>, std::span<std::uint32_t> part) {
    rows.insert(rows.end(), part.begin(), part.end());
  });
  EXPECT_EQ(rows, (std::vector<std::uint32_t>{3, 5, 2, 0, 4, 1}));
}

}  // namespace
}  // namespace orthoball
