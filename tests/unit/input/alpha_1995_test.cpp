// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

constexpr const char* kFile =
    "#title: two balls\n"
    "# made by hand\n"
    "#fix: 7.3\n"
    "\n"
    "1.5 0 -2.125 1.2\n"
    "# between\n"
    "0.25 1 0 -0.5\n";

TEST(ReadAlpha1995, IsRecognisedByItsFixedPointCommand) {
  EXPECT_TRUE(is_alpha_1995(kFile));
  EXPECT_TRUE(is_alpha_1995("# fix: 12.6 \n1 2 3\n"));
  EXPECT_FALSE(is_alpha_1995("#title: a\n1 2 3\n#fix: 7.3\n"));
  EXPECT_FALSE(is_alpha_1995("#fix: the bug\n1 2 3\n"));
  EXPECT_FALSE(is_alpha_1995("#fix 7.3\n"));
  EXPECT_FALSE(is_alpha_1995(""));
}

TEST(ReadAlpha1995, TheNumberAfterTheCoordinatesIsTheSignedRadius) {
  const Reading reading = reading_of(read_alpha_1995, kFile);
  EXPECT_EQ(coordinates_of(reading), (std::vector<double>{1.5, 0, -2.125, 0.25, 1, 0}));
  EXPECT_EQ(reading.points.weight_kind(), WeightKind::radius);
  EXPECT_EQ(reading.points.weight(1), -0.25);
  EXPECT_EQ(reading.points.decimals(), 3);
  EXPECT_EQ(reading.radii, "the file's own");
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{5, 7}));
  EXPECT_EQ(reading.notes, std::vector<std::string>{"title: \"two balls\""});
}

TEST(ReadAlpha1995, ThreeNumbersAreAPointInSpaceUnlessThePlaneIsAskedFor) {
  EXPECT_EQ(reading_of(read_alpha_1995, "1 2 3\n").points.weight_kind(), WeightKind::none);
  const Reading plane = reading_of(read_alpha_1995, "1 2 3\n", {.dimension = 2});
  EXPECT_EQ(plane.points.dimension(), 2);
  EXPECT_EQ(plane.points.weight(0), 9.0);
  EXPECT_EQ(reading_of(read_alpha_1995, "1 2\n").points.dimension(), 2);
  EXPECT_EQ(reading_of(read_alpha_1995, "1 2 3 4\n", {.weight_column = "4"}).points.weight(0), 4.0);
}

TEST(ReadAlpha1995, TheScaleMultipliesAllLengthsExactly) {
  const Reading reading = reading_of(read_alpha_1995, "#scale: 1e-3\n#fix: 4.0\n100 7 -30 20\n");
  EXPECT_EQ(coordinates_of(reading), (std::vector<double>{0.1, 0.007, -0.03}));
  EXPECT_EQ(reading.points.decimals(), 3);
  EXPECT_EQ(reading.points.weight(0), 0.0004);
}

TEST(ReadAlpha1995, MoreDecimalsThanAnnouncedAreAWarning) {
  EXPECT_EQ(reading_of(read_alpha_1995, "#fix: 7.1\n1.25 0 0\n").warnings.size(), 1U);
  EXPECT_TRUE(reading_of(read_alpha_1995, "#fix: 7.2\n1.25 0 0\n").warnings.empty());
}

TEST(ReadAlpha1995, RefusesCommandsItCannotFollow) {
  EXPECT_EQ(error_of(read_alpha_1995, "#fix: 7\n1 2 3\n").substr(0, 4), "f:1:");
  EXPECT_EQ(error_of(read_alpha_1995, "#scale: -1\n1 2 3\n").substr(0, 4), "f:1:");
  EXPECT_EQ(error_of(read_alpha_1995, "1 2 3\n#scale: 2\n1 2 3\n").substr(0, 4), "f:2:");
  EXPECT_EQ(error_of(read_alpha_1995, "#scale: 1e300\n1e200 2 3\n").substr(0, 4), "f:2:");
  EXPECT_EQ(error_of(read_alpha_1995, "1 2 3\n1 2\n").substr(0, 4), "f:2:");
}

}  // namespace
}  // namespace orthoball
