// SPDX-License-Identifier: MIT
#include "orthoball/output/alpha_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace orthoball {
namespace {

TEST(AlphaText, NamesAlpha2AndIndexOrTheEmptyComplex) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(alpha_text(2.5, 7), "alpha2 2.5, index 7");
  EXPECT_EQ(alpha_text(-5.0, 0), "alpha2 -5, index 0");
  EXPECT_EQ(alpha_text(-kInfinity, 0), "index 0, the empty complex");
  EXPECT_EQ(alpha_text(-kInfinity, 1), "alpha2 beyond double range, index 1");
  EXPECT_EQ(alpha_text(kInfinity, 3), "alpha2 beyond double range, index 3");
}

}  // namespace
}  // namespace orthoball
