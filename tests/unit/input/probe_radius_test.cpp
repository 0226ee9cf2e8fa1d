// SPDX-License-Identifier: MIT
#include "orthoball/input/probe_radius.h"

#include <gtest/gtest.h>

#include "orthoball/error.h"

namespace orthoball {
namespace {

TEST(ProbeRadius, ATextIsTheDecimalItSpells) {
  const ProbeRadius probe = probe_radius("1.40");
  EXPECT_EQ(probe.nearest, 1.4);
  EXPECT_EQ(probe.digits, 14);
  EXPECT_EQ(probe.decimals, 1);
}

TEST(ProbeRadius, AWholeNumberWithTrailingZerosKeepsThem) {
  const ProbeRadius probe = probe_radius("3e2");
  EXPECT_EQ(probe.digits, 300);
  EXPECT_EQ(probe.decimals, 0);
}

TEST(ProbeRadius, WhatIsNoSuchDecimalIsTheNearestDoubleAlone) {
  for (const char* text : {"0.12345678901234567", "1e17"}) {
    EXPECT_FALSE(probe_radius(text).digits.has_value()) << text;
  }
  EXPECT_EQ(probe_radius("1e17").nearest, 1e17);
}

TEST(ProbeRadius, NothingElseIsARadius) {
  for (const char* text : {"-1", "nan", "inf", "1e999", "1.4A", ""}) {
    EXPECT_THROW((void)probe_radius(text), InputError) << text;
  }
}

}  // namespace
}  // namespace orthoball
