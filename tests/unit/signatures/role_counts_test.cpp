// SPDX-License-Identifier: MIT
#include "orthoball/signatures/role_counts.h"

#include <gtest/gtest.h>

namespace orthoball {
namespace {

TEST(RoleCounts, OfNothingAreZero) {
  RoleCounts<3> none{Filtration<3>()};
  EXPECT_TRUE(none.has_all_vertices());
  EXPECT_TRUE(none.has_no_singular());
  EXPECT_EQ(none.euler(), 0);
}

}  // namespace
}  // namespace orthoball
