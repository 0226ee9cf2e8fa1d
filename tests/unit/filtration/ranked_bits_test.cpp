// SPDX-License-Identifier: MIT
#include "orthoball/filtration/ranked_bits.h"

#include <gtest/gtest.h>

#include <vector>

namespace orthoball {
namespace {

TEST(RankedBits, NumberTheirElements) {
  for (const std::uint32_t size : {0U, 1U, 63U, 64U, 65U, 1000U}) {
    for (const std::uint32_t step : {1U, 3U, 64U, 200U}) {
      RankedBits bits(size);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t number = 0; number < size; number += step) expected.push_back(number);
      for (const std::uint32_t number : expected) bits.add(number);
      EXPECT_EQ(bits.count_all(), expected.size());
      std::vector<std::uint32_t> visited;
      bits.for_each([&](std::uint32_t number) {
        EXPECT_EQ(bits.rank(number), visited.size());
        EXPECT_TRUE(bits.contains(number));
        visited.push_back(number);
      });
      EXPECT_EQ(visited, expected);
      EXPECT_EQ(bits.count(), expected.size());
      for (std::uint32_t number = 0; number < size; ++number) {
        ASSERT_EQ(bits.rank(number), (number + step - 1) / step);
      }
    }
  }
}

}  // namespace
}  // namespace orthoball
