// SPDX-License-Identifier: MIT
#include "orthoball/filtration/crowded_bucket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace orthoball {
namespace {

// All labels in one bucket, dealt out in so many lists.
void check_parts(const std::vector<double>& labels, std::size_t lists, unsigned threads) {
  const BucketRule rule(1, {});
  LabelPool pool(labels.size(), 1, lists);
  std::vector<LabelList> dealt(lists, LabelList(rule, pool));
  for (std::uint32_t row = 0; row < labels.size(); ++row) {
    dealt[row * lists / labels.size()].add(labels[row], row);
  }
  CrowdedBucket bucket(dealt, 0, Threads(threads));
  std::size_t end = 0;
  std::uint64_t last = 0;
  std::vector<bool> is_met(labels.size(), false);
  for (const CrowdedBucket::Part& part : bucket.parts()) {
    ASSERT_EQ(part.begin, end);
    ASSERT_GT(part.end, part.begin);
    end = part.end;
    std::uint64_t most = last;
    for (std::size_t i = 0; i < part.end - part.begin; ++i) {
      const std::uint32_t row = bucket.rows(part)[i];
      const std::uint64_t key = ordered_key(labels[row]);
      ASSERT_EQ(key, part.one_key.value_or(bucket.keys(part)[i]));
      ASSERT_TRUE(part.begin == 0 || key > last);
      most = std::max(most, key);
      ASSERT_FALSE(is_met[row]);
      is_met[row] = true;
    }
    last = most;
  }
  EXPECT_EQ(end, labels.size());
}

std::vector<double> labels_of(std::size_t count, std::uint64_t distinct) {
  std::uint64_t state = 7;
  std::vector<double> labels(count);
  for (double& label : labels) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    label = static_cast<double>((state >> 33U) % distinct);
  }
  return labels;
}

TEST(CrowdedBucket, HasPartsOfAscendingKeysWithAllNumbers) {
  for (const std::size_t count : {0U, 1U, 2U, 340U, 100'000U}) {
    for (const std::uint64_t distinct : {1U, 2U, 3U, 40U, 1'000'000U}) {
      for (const std::size_t lists : {1U, 5U}) {
        check_parts(labels_of(count, distinct), lists, 1);
        check_parts(labels_of(count, distinct), lists, 4);
      }
    }
  }
}

TEST(CrowdedBucket, KnowsTheKeysThatManyNumbersHave) {
  const std::vector<double> labels = labels_of(100'000, 3);
  const BucketRule rule(1, {});
  LabelPool pool(labels.size(), 1, 1);
  std::vector<LabelList> dealt(1, LabelList(rule, pool));
  for (std::uint32_t row = 0; row < labels.size(); ++row) dealt[0].add(labels[row], row);
  const CrowdedBucket bucket(dealt, 0, Threads(2));
  ASSERT_EQ(bucket.parts().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(bucket.parts()[i].one_key, ordered_key(static_cast<double>(i)));
  }
}

}  // namespace
}  // namespace orthoball
