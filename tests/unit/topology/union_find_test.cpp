// SPDX-License-Identifier: MIT
#include "orthoball/topology/union_find.h"

#include <gtest/gtest.h>

namespace orthoball {
namespace {

TEST(UnionFind, StartsWithEveryNumberApart) {
  UnionFind sets(4);
  EXPECT_EQ(sets.set_count(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(UnionFind, JoinsOnceAndNamesASetByItsSmallestNumber) {
  UnionFind sets(5);
  EXPECT_TRUE(sets.unite(4, 3));
  EXPECT_TRUE(sets.unite(3, 1));
  EXPECT_FALSE(sets.unite(1, 4));
  EXPECT_EQ(sets.find(4), 1U);
  EXPECT_EQ(sets.find(0), 0U);
  EXPECT_EQ(sets.set_count(), 3U);
}

TEST(UnionFind, LongChainsStayCorrect) {
  constexpr std::uint32_t kSize = 10000;
  UnionFind sets(kSize);
  for (std::uint32_t i = kSize; --i > 0;) EXPECT_TRUE(sets.unite(i, i - 1));
  EXPECT_EQ(sets.find(kSize - 1), 0U);
  EXPECT_EQ(sets.set_count(), 1U);
}

}  // namespace
}  // namespace orthoball
