// SPDX-License-Identifier: MIT
#include "orthoball/counted.h"

#include <gtest/gtest.h>

namespace orthoball {
namespace {

TEST(Counted, IsSingularForOne) {
  EXPECT_EQ(counted(0, "column"), "0 columns");
  EXPECT_EQ(counted(1, "column"), "1 column");
  EXPECT_EQ(counted(2, "singular vertex"), "2 singular vertices");
  EXPECT_EQ(counted(1, "vertex"), "1 vertex");
  EXPECT_EQ(counted(3, "tetrahedron"), "3 tetrahedra");
  EXPECT_EQ(noun_of(2, "row"), "rows");
}

}  // namespace
}  // namespace orthoball
