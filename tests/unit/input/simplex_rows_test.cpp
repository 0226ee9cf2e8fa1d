// SPDX-License-Identifier: MIT
#include "orthoball/input/simplex_rows.h"

#include <gtest/gtest.h>

#include <string>

#include "orthoball/error.h"
#include "temporary_file.h"

namespace orthoball {
namespace {

std::string refusal(const std::string& text, int dimension = 3) {
  const TemporaryFile file("s.txt", text);
  try {
    (void)read_simplices(file.path(), dimension, 10);
  } catch (const ParseError& error) {
    return std::string(error.what()).substr(file.path().size());
  }
  return "";
}

TEST(SimplexRows, TakeBlanksCommasAndSemicolons) {
  const TemporaryFile file("s.txt", "# edges\n3 1\r\n\n 0,2 ;9 # a triangle\n1 2 3 4#");
  const SimplexList list = read_simplices(file.path(), 3, 10);
  ASSERT_EQ(list.rows.size(), 3U);
  EXPECT_EQ(list.rows[0], (std::vector<SiteId>{SiteId(1), SiteId(3)}));
  EXPECT_EQ(list.rows[1], (std::vector<SiteId>{SiteId(0), SiteId(2), SiteId(9)}));
  EXPECT_EQ(list.rows[2].size(), 4U);
  EXPECT_EQ(list.line, (std::vector<std::size_t>{2, 4, 5}));
}

TEST(SimplexRows, RefuseWhatIsNoSimplexWithItsLine) {
  EXPECT_EQ(refusal("0 1\n2\n"), ":2: 1 corner; a simplex in space has 2, 3 or 4");
  EXPECT_EQ(refusal("0 1 2 3\n", 2), ":1: 4 corners; a simplex in the plane has 2 or 3");
  EXPECT_EQ(refusal("0 10\n"), ":1: row 10 of 10; rows of the points are counted from 0");
  EXPECT_EQ(refusal("0 1\n\n4 4\n"), ":3: row 4 twice; the corners of a simplex are different");
  EXPECT_NE(refusal("0 -1\n").find(":1: a corner is \"-1\""), std::string::npos)
      << refusal("0 -1\n");
  EXPECT_NE(refusal("a b\n").find(":1: a corner is \"a\""), std::string::npos) << refusal("a b\n");
  EXPECT_EQ(refusal("# nothing\n"),
            ": there is no simplex in it; lines of rows such as \"0 5 7\" are expected");
}

}  // namespace
}  // namespace orthoball
