// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Numbers = std::vector<double>;

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment c\n" + elements + "end_header\n";
}

std::string float_bytes(float number) {
  return little_endian(std::bit_cast<std::uint32_t>(number), 4);
}
std::string double_bytes(double number) {
  return little_endian(std::bit_cast<std::uint64_t>(number), 8);
}

constexpr const char* kXyz =
    "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";

TEST(ReadPly, AsciiNumbersAreExactDecimals) {
  const Reading reading = reading_of(read_ply, header("ascii", kXyz) + "0.1 0 0\n\n1 -2.5 3\n");
  EXPECT_EQ(coordinates_of(reading), (Numbers{0.1, 0, 0, 1, -2.5, 3}));
  EXPECT_EQ(reading.points.decimals(), 1);
  EXPECT_EQ(reading.labels.line, (std::vector<std::uint32_t>{9, 11}));
}

TEST(ReadPly, ListsAndOtherElementsAreSteppedOver) {
  const std::string elements =
      "element camera 1\nproperty list uchar int k\nproperty float f\n"
      "element vertex 2\nproperty list uchar float w\nproperty double x\nproperty uchar red\n"
      "property double y\nelement face 1\nproperty list uchar int vertex_indices\n";
  EXPECT_EQ(coordinates_of(reading_of(read_ply, header("ascii", elements) +
                                                    "2 7 7 1\n1 9 1 255 2\n0 3 255 4\n3 0 1 2\n")),
            (Numbers{1, 2, 3, 4}));
  const std::string binary =
      std::string(1, '\2') + little_endian(7, 4) + little_endian(7, 4) + float_bytes(1) +   //
      std::string(1, '\1') + float_bytes(9) + double_bytes(1) + "\xff" + double_bytes(2) +  //
      std::string(1, '\0') + double_bytes(3) + "\xff" + double_bytes(4);
  const Reading reading = reading_of(read_ply, header("binary_little_endian", elements) + binary);
  EXPECT_EQ(coordinates_of(reading), (Numbers{1, 2, 3, 4}));
  EXPECT_FALSE(reading.points.decimals());
}

TEST(ReadPly, EveryNumberTypeIsReadInBothByteOrders) {
  const std::string elements =
      "element vertex 1\nproperty char x\nproperty ushort y\nproperty int z\nproperty short r\n";
  const std::string little = std::string("\xff") + little_endian(513, 2) +
                             little_endian(0xfffffffe, 4) + little_endian(3, 2);
  const std::string big = std::string("\xff\x02\x01\xff\xff\xff\xfe\x00\x03", 9);
  for (const auto& [format, bytes] :
       {std::pair{"binary_little_endian", little}, std::pair{"binary_big_endian", big}}) {
    const Reading reading =
        reading_of(read_ply, header(format, elements) + bytes, {.radius_column = "r"});
    EXPECT_EQ(coordinates_of(reading), (Numbers{-1, 513, -2}));
    EXPECT_EQ(reading.points.weight(0), 9.0);
  }
}

TEST(ReadPly, TheHeaderMayEndItsLinesAsItLikes) {
  std::string text = header("binary_little_endian", kXyz);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  for (const float number : {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}) text += float_bytes(number);
  EXPECT_EQ(coordinates_of(reading_of(read_ply, text)), (Numbers{1, 2, 3, 4, 5, 6}));
}

TEST(ReadPly, OtherPropertiesCanBeTheCoordinates) {
  const std::string text =
      header("ascii", "element vertex 1\nproperty float u\nproperty float v\n") + "1 2\n";
  EXPECT_NE(error_of(read_ply, text).find("no properties x, y"), std::string::npos);
  EXPECT_EQ(coordinates_of(reading_of(read_ply, text, {.columns = {"v", "u"}})), (Numbers{2, 1}));
}

TEST(ReadPly, CountsMustBeTrue) {
  const std::string many = "element vertex 4000000000\nproperty float x\nproperty float y\n";
  EXPECT_NE(error_of(read_ply, header("ascii", many) + "1 2\n").find("announced, 1 found"),
            std::string::npos);
  EXPECT_NE(error_of(read_ply, header("binary_little_endian", many) + "abcd").find("4 present"),
            std::string::npos);
  const std::string lists =
      "element face 4000000000\nproperty list uint uchar i\n" + std::string(kXyz);
  EXPECT_NE(error_of(read_ply, header("binary_big_endian", lists) + "\xff\xff\xff\xff"), "");
  EXPECT_NE(error_of(read_ply, header("ascii", lists)), "");
}

TEST(ReadPly, RefusesWhatItCannotRead) {
  for (const std::string& text :
       {std::string(), std::string("plyy\n"), std::string("ply\nformat ascii 1.0\n"),
        header("binary_middle_endian", kXyz), header("ascii", "element face 0\n"),
        header("ascii", "property float x\n"), std::string("ply\nend_header\n"),
        header("ascii", "element vertex 1\nproperty quad x\n"),
        header("ascii", "element vertex -1\nproperty float x\n"),
        header("ascii", kXyz) + "1 2\n1 2 3\n", header("ascii", kXyz) + "1 2 3 4\n1 2 3\n",
        header("ascii", kXyz) + "1 2 x\n1 2 3\n",
        header(
            "binary_little_endian",
            "element vertex 1\nproperty list float int k\nproperty uchar x\nproperty uchar y\n") +
            float_bytes(-1.0F) + "ab",
        header("binary_little_endian", "element vertex 1\nproperty float x\nproperty float y\n") +
            little_endian(0x7fc00000, 4) + float_bytes(1.0F)}) {
    EXPECT_NE(error_of(read_ply, text), "") << text;
  }
}

}  // namespace
}  // namespace orthoball
