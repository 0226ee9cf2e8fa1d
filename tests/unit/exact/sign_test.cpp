// SPDX-License-Identifier: MIT
#include "orthoball/exact/sign.h"

#include <gtest/gtest.h>

namespace orthoball {
namespace {

TEST(Sign, MultipliesLikeTheNumbersItIsOf) {
  for (const int a : {-1, 0, 1}) {
    EXPECT_EQ(-Sign(a), Sign(-a));
    for (const int b : {-1, 0, 1}) EXPECT_EQ(Sign(a) * Sign(b), Sign(a * b));
  }
}

}  // namespace
}  // namespace orthoball
