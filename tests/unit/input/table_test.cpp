// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Numbers = std::vector<double>;

Numbers numbers_of(const std::string& text, const ReadOptions& options = {}) {
  return coordinates_of(reading_of(read_table, text, options));
}

bool says(const std::string& text, const std::string& message, const ReadOptions& options = {}) {
  const std::string error = error_of(read_table, text, options);
  if (error.find(message) == std::string::npos) ADD_FAILURE() << "says: " << error;
  return error.find(message) != std::string::npos;
}

TEST(ReadTable, FieldsAreSeparatedByCommasTabsOrBlanks) {
  const Numbers expected = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(numbers_of("1,2,3\n4,5,6\n"), expected);
  EXPECT_EQ(numbers_of("1\t2\t3\r\n4\t5\t6"), expected);
  EXPECT_EQ(numbers_of("  1 2   3 \n4\t 5 6\n"), expected);
  EXPECT_EQ(numbers_of(" 1 , 2 ,3\n\n4,5,\t6\n\n"), expected);
  EXPECT_EQ(coordinates_of(read_table({"a.tsv", "a b\tx\ty\n\t1\t2\n"}, {})), (Numbers{1, 2}));
}

TEST(ReadTable, LinesThatBeginWithACommentMarkAreCommentsOnly) {
  EXPECT_EQ(numbers_of("# dim=3 weighted=1\n1 2\n%c\n  # d\n// e\n3 4 # last\n"),
            (Numbers{1, 2, 3, 4}));
}

TEST(ReadTable, AHeaderHasNoNumbers) {
  EXPECT_EQ(numbers_of("a b c\n1 2 3\n"), (Numbers{1, 2, 3}));
  EXPECT_EQ(numbers_of("\"x\" \"y\" \"z\"\n6.5 7 -4\n"), (Numbers{6.5, 7, -4}));
  EXPECT_TRUE(says("id 2020 2021\n1 2 3\n", "f:1: column 1 is \"id\""));
  EXPECT_TRUE(says("nan nan nan\n", "f:1: column 1 is \"nan\""));
}

TEST(ReadTable, CoordinatesAreTheColumnsNamedSo) {
  EXPECT_EQ(numbers_of("id,Z,Y,X\n9,3,2,1\n"), (Numbers{1, 2, 3}));
  EXPECT_EQ(numbers_of("name,latitude,Longitude\na,50,8\n"), (Numbers{8, 50}));
  EXPECT_EQ(numbers_of("lat,lon,h\n50,8,7\n"), (Numbers{8, 50}));
  EXPECT_EQ(numbers_of("x,y,z\n1,2,3\n", {.dimension = 2}), (Numbers{1, 2}));
  EXPECT_EQ(numbers_of("x,y,height\n1,2,3\n"), (Numbers{1, 2}));
  EXPECT_EQ(numbers_of("x,y,height\n1,2,3\n", {.dimension = 3}), (Numbers{1, 2, 3}));
}

TEST(ReadTable, WithoutNamesTheFirstNumbersAreCoordinates) {
  EXPECT_EQ(numbers_of("1 2\n"), (Numbers{1, 2}));
  EXPECT_EQ(numbers_of("1 2 3 4 5 6\n"), (Numbers{1, 2, 3}));
  EXPECT_EQ(numbers_of("1 2 3\n", {.dimension = 2}), (Numbers{1, 2}));
  EXPECT_EQ(numbers_of("1 2 3\n", {.radius_column = "3"}), (Numbers{1, 2}));
  EXPECT_EQ(numbers_of("9 1 2 3\n", {.radius_column = "1"}), (Numbers{1, 2, 3}));
  EXPECT_EQ(numbers_of("1 2 on\n3 4 off\n"), (Numbers{1, 2, 3, 4}));
}

TEST(ReadTable, ColumnsAreChosenByNumberOrName) {
  EXPECT_EQ(numbers_of("405 20.8 13.8 0.05\n", {.columns = {"2", "3", "4"}}),
            (Numbers{20.8, 13.8, 0.05}));
  EXPECT_EQ(numbers_of("id,east,north\n1,5,6\n", {.columns = {"East", "north"}}), (Numbers{5, 6}));
  EXPECT_TRUE(says("1 2 3\n", "there is no column 4; columns count from 1 to 3",
                   {.columns = {"2", "3", "4"}}));
  EXPECT_TRUE(says("a,b\n1,2\n", "no column named \"r\"; its columns are \"a\", \"b\"",
                   {.radius_column = "r"}));
  EXPECT_TRUE(says("1 2 3\n", "its columns have numbers only", {.radius_column = "r"}));
}

TEST(ReadTable, RadiiAndWeightsAreSigned) {
  const Reading radii = reading_of(read_table, "x,y,r\n0,0,-1.5\n1,0,2\n", {.radius_column = "r"});
  EXPECT_EQ(radii.points.weight_kind(), WeightKind::radius);
  EXPECT_EQ(radii.points.weight(0), -2.25);
  EXPECT_EQ(radii.points.weight(1), 4.0);
  EXPECT_EQ(radii.radii, "column 3 (\"r\")");
  const Reading weights = reading_of(read_table, "0 0 0 -0.25\n", {.weight_column = "4"});
  EXPECT_EQ(weights.points.weight_kind(), WeightKind::weight);
  EXPECT_EQ(weights.points.weight(0), -0.25);
  EXPECT_EQ(weights.points.decimals(), 1);
  EXPECT_EQ(reading_of(read_table, "1 2 3 4\n").radii, "none");
}

TEST(ReadTable, RowsMustHaveEqualCounts) {
  EXPECT_TRUE(says("0 0 0\n1 0 0 1.5\n", "f:2: 4 columns, expected 3 as on line 1"));
  EXPECT_TRUE(says("x,y,z\n1,2,3\n4,5\n", "f:3: 2 columns, expected 3 as on line 1"));
  EXPECT_TRUE(says("x,y,z\n4,5\n", "f:2: 2 columns, expected 3 as on line 1"));
  EXPECT_TRUE(says("1,2,\n3,4\n", "f:2: 2 columns, expected 3"));
}

TEST(ReadTable, TooFewColumnsAreNamed) {
  EXPECT_TRUE(says("1 2\n", "f:1: 2 columns for 3 coordinates", {.dimension = 3}));
  EXPECT_TRUE(says("1.5\n", "f:1: 1 column for 2 coordinates"));
  EXPECT_TRUE(says("1 2\n", "and a weight", {.dimension = 2, .radius_column = "2"}));
}

TEST(ReadTable, FieldsMayBeQuoted) {
  EXPECT_EQ(numbers_of("name,x,y\n\"a, b\",1,2\n\"c \"\"q\"\"\",\"3\",4\n"), (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(numbers_of("name,x,y\n\"two\nlines\",1,2\n"), (Numbers{1, 2}));
  const Reading reading = reading_of(read_table, "name,x,y\n\"two\nlines\",1,2\nb,3,4\n");
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{2, 4}));
  EXPECT_EQ(numbers_of("\"a \"\"b\"\"\",c\n1,2\n", {.columns = {"c", "a \"b\""}}), (Numbers{2, 1}));
  EXPECT_TRUE(says("name,x,y\n\"open,1,2\n3,4,5\n", "f:2: a quote that is never closed"));
  EXPECT_TRUE(says("x,y\n\"1\"2,3\n", "f:2: text after a closing quote"));
  EXPECT_TRUE(says("\"x\"y z\n", "f:1: text after a closing quote"));
}

TEST(ReadTable, ForeignNumbersAreErrors) {
  EXPECT_TRUE(says("x,y\n=1+1,2\n", "f:2: column 1 (\"x\") is \"=1+1\", which is not a number"));
  EXPECT_TRUE(says("1 2 3\n1e400 0 0\n", "f:2: column 1 is \"1e400\", which is out of range"));
  EXPECT_TRUE(says("1 2 3\n0 inf 0\n", "f:2: column 2 is \"inf\"; a finite number"));
  EXPECT_TRUE(says("x;y;z\n1,5;2,5;3,5\n", "f:1: semicolons"));
  EXPECT_TRUE(says("1 2\n1,5 2\n", "f:2: column 1 is \"1,5\""));
}

TEST(ReadTable, TextIsReadAsExactDecimals) {
  const Reading reading = reading_of(read_table, "0.1 0.20 3e-1\n-0.0 1e-400 0\n");
  EXPECT_EQ(reading.points.decimals(), 1);
  EXPECT_EQ(reading.points.coordinates()[0], 1.0);
  EXPECT_EQ(reading.points.coordinates()[2], 3.0);
  EXPECT_EQ(reading.points.coordinates()[4], 0.0);
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{1, 2}));
}

TEST(ReadTable, ALoneCountMayComeFirst) {
  EXPECT_EQ(numbers_of("2\n1 2 3\n4 5 6\n"), (Numbers{1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(says("3\n1 2 3\n4 5 6\n", "f:1: 3 points announced, 2 found"));
  EXPECT_TRUE(says("99999999999999999999\n1 2 3\n", "out of range"));
}

TEST(ReadTable, NothingButAHeaderIsEmpty) {
  EXPECT_EQ(reading_of(read_table, "").points.size(), 0U);
  EXPECT_EQ(reading_of(read_table, "x,y\n", {.dimension = 2}).points.dimension(), 2);
}

TEST(ReadTable, SaysWhichColumnsItTook) {
  EXPECT_TRUE(reading_of(read_table, "1 2 3\n").notes.empty());
  EXPECT_EQ(reading_of(read_table, "1 2 3 4\n").notes,
            std::vector<std::string>{"coordinates are columns 1, 2, 3 of 4"});
}

}  // namespace
}  // namespace orthoball
