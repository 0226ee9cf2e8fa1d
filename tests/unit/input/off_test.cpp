// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Numbers = std::vector<double>;

TEST(ReadOff, TheVerticesAreThePoints) {
  const Reading reading =
      reading_of(read_off, "OFF\n# c\n2 1 0\n\n0.5 0 0 # first\n1 0 -1\n2 0 1\n");
  EXPECT_EQ(coordinates_of(reading), (Numbers{0.5, 0, 0, 1, 0, -1}));
  EXPECT_EQ(reading.points.decimals(), 1);
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{5, 6}));
  EXPECT_TRUE(reading.warnings.empty());
}

TEST(ReadOff, HeadersComeInManyForms) {
  const Numbers expected = {1, 2, 3};
  EXPECT_EQ(coordinates_of(reading_of(read_off, "1 0 0\n1 2 3\n")), expected);
  EXPECT_EQ(coordinates_of(reading_of(read_off, "OFF 1 0 0\n1 2 3\n")), expected);
  EXPECT_EQ(coordinates_of(reading_of(read_off, "COFF\r\n1 0 0\r\n1 2 3 255 0 0 255\r\n")),
            expected);
  EXPECT_EQ(coordinates_of(reading_of(read_off, "nOFF\n3\n1 0 0\n1 2 3\n")), expected);
  EXPECT_EQ(coordinates_of(reading_of(read_off, "nOFF 2\n1 0 0\n1 2\n")), (Numbers{1, 2}));
  EXPECT_EQ(coordinates_of(reading_of(read_off, "OFF\n1\n1 2 3\n")), expected);
}

TEST(ReadOff, ColumnOptionsCountTheNumbersOfAVertex) {
  const std::string text = "COFF\n1 0 0\n1 2 3 0.5\n";
  EXPECT_EQ(reading_of(read_off, text, {.radius_column = "4"}).points.weight(0), 0.25);
  EXPECT_EQ(coordinates_of(reading_of(read_off, text, {.dimension = 2})), (Numbers{1, 2}));
}

TEST(ReadOff, CountsMustBeTrue) {
  EXPECT_EQ(error_of(read_off, "OFF\n1000000000 0 0\n0 0 0\n1 0 0\n"),
            "f:4: 1000000000 vertices announced, 2 found; the two must agree");
  EXPECT_EQ(error_of(read_off, "OFF\n-1 0 0\n").substr(0, 4), "f:2:");
  EXPECT_EQ(error_of(read_off, "OFF\n99999999999999999999 0 0\n").substr(0, 4), "f:2:");
}

TEST(ReadOff, FaultsOfFacesAreWarnings) {
  const auto warning = [](const char* faces) {
    const Reading reading =
        reading_of(read_off, std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n") + faces);
    EXPECT_EQ(reading.points.size(), 3U);
    return reading.warnings.empty() ? std::string() : reading.warnings[0];
  };
  EXPECT_EQ(warning("3 0 1 2\n"), "");
  EXPECT_EQ(warning("3 0 1 7\n"), "line 6: there is no vertex \"7\"; faces are not used");
  EXPECT_EQ(warning("3 0 1 -1\n"), "line 6: there is no vertex \"-1\"; faces are not used");
  EXPECT_EQ(warning("9 0 1 2\n"), "line 6: not a face; faces are not used");
  EXPECT_EQ(warning(""), "1 faces announced, 0 found; faces are not used");
}

TEST(ReadOff, RefusesWhatItIsNot) {
  for (const char* text : {"", "OFF\n", "PLY\n1 0 0\n", "4OFF\n1 0 0\n1 2 3 4\n", "OFF BINARY\n",
                           "nOFF\n4\n1 0 0\n1 2 3 4\n", "OFF\n1 0 0\n1 2\n", "OFFSET 1 0 0\n",
                           "OFF\n2 0 0\n1 2 3\n1 2 3 4\n", "OFF\n1 0 0\n1 2 x\n"}) {
    EXPECT_NE(error_of(read_off, text), "") << text;
  }
}

}  // namespace
}  // namespace orthoball
