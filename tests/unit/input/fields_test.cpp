// SPDX-License-Identifier: MIT
#include "orthoball/input/fields.h"

#include <gtest/gtest.h>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

TEST(Fields, MessagesOfReadersAreSingularForOne) {
  EXPECT_EQ(error_of(read_xyz, "1\n\nC\n"), "f:3: the line has 1 column; element x y z are needed");
  EXPECT_EQ(error_of(read_xyz, "5\n\nO 0 0 0\n"),
            "f:1: the count is 5, but 1 atom follows; the number of atoms is needed");
  EXPECT_EQ(error_of(read_off, "OFF\n1 0 0\n"),
            "f:2: 1 vertex announced, 0 found; the two must agree");
}

}  // namespace
}  // namespace orthoball
