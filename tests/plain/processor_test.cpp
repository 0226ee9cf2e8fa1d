// SPDX-License-Identifier: MIT
#include "orthoball/exact/processor.h"

#include <gtest/gtest.h>

namespace orthoball {
namespace {

// Or the tests beside this one would test again what others do.
TEST(Processor, HasNoVectorsWhereTheyAreLeftOut) {
  EXPECT_FALSE(has_avx2());
  EXPECT_FALSE(has_avx2_fma());
}

}  // namespace
}  // namespace orthoball
