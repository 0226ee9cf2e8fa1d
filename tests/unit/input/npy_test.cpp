// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Numbers = std::vector<double>;

std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                const std::string& data, int version = 1) {
  const std::string dictionary =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
  return "\x93NUMPY" + little_endian(static_cast<unsigned>(version), 1) + std::string(1, '\0') +
         little_endian(dictionary.size(), version == 1 ? 2 : 4) + dictionary + data;
}

std::string doubles(const Numbers& numbers) {
  std::string bytes;
  for (const double number : numbers) {
    bytes += little_endian(std::bit_cast<std::uint64_t>(number), 8);
  }
  return bytes;
}

std::string integers(const std::vector<long long>& numbers, std::size_t size) {
  std::string bytes;
  for (const long long number : numbers) {
    bytes += little_endian(static_cast<unsigned long long>(number), size);
  }
  return bytes;
}

TEST(ReadNpy, RowsArePointsInEveryVersion) {
  for (const int version : {1, 2, 3}) {
    const Reading reading = reading_of(
        read_npy, npy("<f8", "False", "(2, 3)", doubles({0.1, 2, 3, 4, 5, -0.0}), version));
    EXPECT_EQ(coordinates_of(reading), (Numbers{0.1, 2, 3, 4, 5, 0}));
    EXPECT_FALSE(reading.points.decimals());
  }
}

TEST(ReadNpy, FortranOrderIsColumnByColumn) {
  EXPECT_EQ(coordinates_of(
                reading_of(read_npy, npy("<f8", "True", "(2, 3)", doubles({1, 4, 2, 5, 3, 6})))),
            (Numbers{1, 2, 3, 4, 5, 6}));
}

TEST(ReadNpy, NumbersMayBeFloatsAndIntegers) {
  const Numbers expected = {1, -2};
  EXPECT_EQ(
      coordinates_of(reading_of(read_npy, npy("<i8", "False", "(1,2)", integers({1, -2}, 8)))),
      expected);
  EXPECT_EQ(
      coordinates_of(reading_of(read_npy, npy("<i4", "False", "(1,2,)", integers({1, -2}, 4)))),
      expected);
  EXPECT_EQ(
      coordinates_of(reading_of(read_npy, npy("|i1", "False", "(1, 2)", integers({1, -2}, 1)))),
      expected);
  EXPECT_EQ(coordinates_of(
                reading_of(read_npy, npy(">u2", "False", "(1, 2)", std::string("\0\1\1\0", 4)))),
            (Numbers{1, 256}));
  EXPECT_EQ(coordinates_of(reading_of(
                read_npy, npy("<f4", "False", "(1, 2)", integers({0x3f800000, 0xc0000000}, 4)))),
            expected);
}

TEST(ReadNpy, ColumnOptionsCountTheColumns) {
  const std::string bytes = npy("<f8", "False", "(1, 4)", doubles({1, 2, 3, -0.5}));
  EXPECT_EQ(reading_of(read_npy, bytes, {.radius_column = "4"}).points.weight(0), -0.25);
  EXPECT_EQ(reading_of(read_npy, bytes, {.weight_column = "4"}).points.weight(0), -0.5);
  EXPECT_EQ(coordinates_of(reading_of(read_npy, bytes, {.columns = {"3", "2"}})), (Numbers{3, 2}));
  EXPECT_EQ(reading_of(read_npy, npy("<f8", "False", "(1, 2)", doubles({1, 2}))).points.dimension(),
            2);
  EXPECT_NE(error_of(read_npy, bytes, {.radius_column = "r"}), "");
}

TEST(ReadNpy, NoRowsAreNoPoints) {
  EXPECT_EQ(reading_of(read_npy, npy("<f8", "False", "(0, 3)", "")).points.size(), 0U);
}

TEST(ReadNpy, ReadsManyRowsAndNamesTheFirstNumberThatIsNone) {
  std::vector<double> numbers(3 * 1500);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = 0.5 * static_cast<double>(i);
  const std::string head = npy("<f8", "False", "(1500, 3)", "");
  EXPECT_EQ(coordinates_of(reading_of(read_npy, head + doubles(numbers))), numbers);
  numbers[3 * 1300 + 2] = numbers[3 * 1301] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of(read_npy, head + doubles(numbers)),
            "f: byte " + std::to_string(head.size() + 8 * (3 * 1300 + 2)) +
                ": column 3 is not finite, or an integer above 2^53 in size; numbers that a double "
                "holds exactly are needed");
  std::vector<double> columns(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) columns[i % 3 * 1500 + i / 3] = numbers[i];
  const std::string turned = npy("<f8", "True", "(1500, 3)", "");
  EXPECT_EQ(error_of(read_npy, turned + doubles(columns)),
            "f: byte " + std::to_string(turned.size() + 8 * (2 * 1500 + 1300)) +
                ": column 3 is not finite, or an integer above 2^53 in size; numbers that a double "
                "holds exactly are needed");
}

TEST(ReadNpy, NamesTypesAndShapesAsTheyAreWritten) {
  EXPECT_EQ(error_of(read_npy, npy("<f2", "False", "(1, 2)", "abcd")),
            "f: byte 10: elements of type '<f2'; save the array as float64, float32 or integers");
  EXPECT_EQ(error_of(read_npy, npy("|O' ", "False", "(1, 2)", "")),
            "f: byte 10: elements of type '|O'; save the array as float64, float32 or integers");
  EXPECT_EQ(error_of(read_npy, npy("<f8", "False", "(5,)", "")),
            "f: byte 10: an array of shape (5,); points by columns, such as (1000, 3), are read");
  EXPECT_EQ(
      error_of(read_npy, npy("<f8", "False", "(5, 1, 2)", "")),
      "f: byte 10: an array of shape (5, 1, 2); points by columns, such as (1000, 3), are read");
  std::string records = npy("<f8", "False", "(5, 3)", "");
  records.replace(records.find("'<f8'"), 5, "[('x', '<f8')]")
      .replace(8, 2, little_endian(records.size() - 10, 2));
  EXPECT_EQ(error_of(read_npy, records),
            "f: byte 10: elements of type [('x', '<f8')]; save the array as float64, float32 or "
            "integers");
}

TEST(ReadNpy, MessagesAreShortAndPrintableWhateverTheFileSays) {
  const std::string wild = "\x1b[2J\x07" + std::string(60000, 'x');
  for (const std::string& bytes : {npy("<f8" + wild, "False", "(1, 2)", "", 2),
                                   npy("<f8", "False", "(1, " + wild + ", 2)", "", 2)}) {
    const std::string message = error_of(read_npy, bytes);
    EXPECT_LT(message.size(), 200U);
    EXPECT_NE(message.find("\\x1b[2J\\x07xxx"), std::string::npos) << quoted(message);
  }
}

TEST(ReadNpy, RefusesWhatItCannotRead) {
  const std::string good = npy("<f8", "False", "(1, 2)", doubles({1, 2}));
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_NE(error_of(read_npy, good.substr(0, length)), "") << length;
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& bytes :
       {npy("<f8", "False", "(4611686018427387904, 4)", doubles({1, 2})),
        npy("<f8", "False", "(0, 9223372036854775807)", ""),
        npy("<f8", "False", "(2,)", doubles({1, 2})),
        npy("<f8", "False", "(1, 1, 2)", doubles({1, 2})), npy("<f8", "False", "()", doubles({1})),
        npy("<f8", "False", "(9, 0)", ""), npy("<f8", "False", "(2, 1)", doubles({1, 2})),
        npy("<c16", "False", "(1, 2)", doubles({1, 2, 3, 4})), npy("|O", "False", "(1, 2)", ""),
        npy("<f2", "False", "(1, 2)", "abcd"), npy("<f8", "False", "(1, 2)", doubles({1, nan})),
        npy("<i8", "False", "(1, 2)", integers({1, (1LL << 53) + 1}, 8)),
        npy("<f8", "False", "(1, 2)", doubles({1, 2}), 4)}) {
    EXPECT_NE(error_of(read_npy, bytes), "") << quoted(bytes.substr(10));
  }
}

}  // namespace
}  // namespace orthoball
