// SPDX-License-Identifier: MIT
#include "orthoball/filtration/label_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace orthoball {
namespace {

// The rows of labels in ascending order, dealt out in so many lists.
std::vector<std::uint32_t> sorted_rows(const std::vector<double>& labels,
                                       const std::vector<double>& sample, std::size_t lists) {
  const BucketRule rule(std::max<std::size_t>(labels.size(), 100000), sample);
  LabelPool pool(labels.size(), rule.bucket_count(), lists);
  std::vector<LabelList> dealt(lists, LabelList(rule, pool));
  for (std::uint32_t row = 0; row < labels.size(); ++row) {
    dealt[row * lists / labels.size()].add(labels[row], row);
  }
  BucketSorter sorter(rule);
  std::vector<std::uint32_t> rows;
  for (std::size_t bucket = 0; bucket < rule.bucket_count(); ++bucket) {
    sorter.sort(dealt, bucket);
    std::size_t size = 0;
    for (const LabelList& list : dealt) size += list.size(bucket);
    EXPECT_EQ(sorter.rows().size(), size);
    EXPECT_EQ(sorter.keys().size(), size);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(sorter.keys()[i], ordered_key(labels[sorter.rows()[i]]));
    }
    rows.insert(rows.end(), sorter.rows().begin(), sorter.rows().end());
  }
  return rows;
}

// Equal labels stay in the order in which they came.
void expect_in_order(const std::vector<double>& labels, const std::vector<double>& sample) {
  std::vector<std::uint32_t> expected(labels.size());
  std::iota(expected.begin(), expected.end(), 0U);
  std::stable_sort(expected.begin(), expected.end(), [&](std::uint32_t a, std::uint32_t b) {
    return ordered_key(labels[a]) < ordered_key(labels[b]);
  });
  for (const std::size_t lists : {1U, 2U, 7U}) {
    ASSERT_EQ(sorted_rows(labels, sample, lists), expected);
  }
}

TEST(LabelBuckets, GiveBackInOrderWhateverTheSample) {
  std::uint64_t state = 5;
  const auto random = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) * 0x1p-53;
  };
  for (const std::size_t count : {0U, 1U, 339U, 340U, 341U, 680U, 100000U}) {
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
  EXPECT_EQ(sorted_rows(labels, labels, 1), (std::vector<std::uint32_t>{3, 5, 2, 0, 4, 1}));
}

TEST(LabelBuckets, NeverFallAsNumbersGrow) {
  const BucketRule rule(1000000, std::vector<double>{-3.0, 0.1, 0.2, 5.0, 1e9});
  std::uint32_t last = 0;
  for (const double label : {-1e300, -4.0, -3.0, -1e-300, -0.0, 0.0, 1e-300, 0.1, 0.15, 0.2, 1.0,
                             4.99, 5.0, 5e8, 1e9, 2e9, 1e300}) {
    EXPECT_GE(rule.place(ordered_key(label)), last) << label;
    last = rule.place(ordered_key(label));
  }
  EXPECT_LT(last >> 16U, rule.bucket_count());
}

}  // namespace
}  // namespace orthoball
