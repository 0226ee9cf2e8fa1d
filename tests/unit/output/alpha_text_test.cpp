// SPDX-License-Identifier: MIT
#include "orthoball/output/alpha_text.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/output/shapes.h"

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

TEST(ScaleText, TellsWhenTheFirstAndTheLastEnterAndWhatIsBetween) {
  EXPECT_EQ(scale_text(Shapes<2>({0, 0, 4, 0, 0, 3}).filtration),
            "the first simplex enters at alpha2 0, the last at 6.25; in one piece at 4; solid at "
            "6.25");
  EXPECT_EQ(scale_text(Shapes<3>({0, 0, 0}).filtration),
            "the first simplex enters at alpha2 0, the last at 0; in one piece at 0");
  EXPECT_EQ(scale_text(Shapes<3>({}).filtration), "there are no sites");
}

}  // namespace
}  // namespace orthoball
