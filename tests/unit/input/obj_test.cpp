// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Numbers = std::vector<double>;

TEST(ReadObj, VertexLinesAreThePoints) {
  const Reading reading = reading_of(
      read_obj, "# c\nmtllib a\nvn 9 9 9\nvt 8 8\n v 0.5 0 1 # first\nv\t2 3e-1 4\nf 1 2 3\n");
  EXPECT_EQ(coordinates_of(reading), (Numbers{0.5, 0, 1, 2, 0.3, 4}));
  EXPECT_EQ(reading.points.decimals(), 1);
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{5, 6}));
}

TEST(ReadObj, OnlyWeightOneIsAPoint) {
  EXPECT_EQ(coordinates_of(reading_of(read_obj, "v 1 2 3 1.0\n")), (Numbers{1, 2, 3}));
  EXPECT_EQ(error_of(read_obj, "v 1 2 3 0.5\n").substr(0, 4), "f:1:");
  EXPECT_EQ(reading_of(read_obj, "v 1 2 3 0.5\n", {.radius_column = "4"}).points.weight(0), 0.25);
  EXPECT_EQ(coordinates_of(reading_of(read_obj, "v 1 2 3 0 0 1\n")), (Numbers{1, 2, 3}));
}

TEST(ReadObj, EveryVertexMayHaveAWeightOrColourOfItsOwn) {
  const std::vector<std::string> vertices{"v 1 2 3\n", "v 1 2 3 1.0\n", "v 1 2 3 0 0.5 1\n",
                                          "v 1 2 3 1 0 0.5 1\n"};
  for (const std::string& first : vertices) {
    for (const std::string& second : vertices) {
      EXPECT_EQ(coordinates_of(reading_of(read_obj, first + second + first)),
                (Numbers{1, 2, 3, 1, 2, 3, 1, 2, 3}));
    }
    EXPECT_EQ(error_of(read_obj, first + "v 1 2 3 0.5\n").substr(0, 4), "f:2:");
  }
  EXPECT_EQ(error_of(read_obj, "v 1 2 3 2\nv 1 2 3\n", {.radius_column = "4"}).substr(0, 4),
            "f:2:");
  EXPECT_EQ(
      error_of(read_obj, "v 1 2 3 0 0 1\nv 1 2 3\n", {.columns = {"4", "5", "6"}}).substr(0, 4),
      "f:2:");
}

TEST(ReadObj, RefusesVerticesOfOtherCountsAmongThese) {
  for (const char* const vertex : {"v 1 2 3 4 5\n", "v 1 2 3 4 5 6 7 8\n"}) {
    EXPECT_EQ(error_of(read_obj, std::string("v 1 2 3\n") + vertex).substr(0, 4), "f:2:");
    EXPECT_EQ(error_of(read_obj, vertex + std::string("v 1 2 3\n")).substr(0, 4), "f:2:");
    EXPECT_EQ(reading_of(read_obj, vertex + std::string(vertex)).points.size(), 2U);
    EXPECT_EQ(error_of(read_obj, std::string("v 1 2 3\nv 1 2 3 1\n") + vertex).substr(0, 4),
              "f:3:");
  }
}

TEST(ReadObj, RefusesVerticesThatAreNone) {
  EXPECT_EQ(error_of(read_obj, "v 1 2\n").substr(0, 4), "f:1:");
  EXPECT_EQ(error_of(read_obj, "v 1 2 3\nv 1 2 x\n").substr(0, 4), "f:2:");
  EXPECT_EQ(reading_of(read_obj, "f 1 2 3\n").points.size(), 0U);
}

}  // namespace
}  // namespace orthoball
