// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>

#include "unit/input/inline_source.h"

namespace orthoball {
namespace {

using Numbers = std::vector<double>;

struct LasFile {
  unsigned minor = 2;
  unsigned format = 0;
  std::size_t record = 20;
  std::size_t count = 2;
  double scale = 0.01;
  double offset = 500.5;
  std::vector<std::array<int, 3>> points = {{100, 200, -300}, {2147483647, 0, 5}};

  [[nodiscard]] std::string bytes() const {
    const std::size_t header_size = minor == 4 ? 375 : minor == 3 ? 235 : 227;
    std::string header(header_size, '\0');
    const auto put = [&](std::size_t at, const std::string& what) {
      header.replace(at, what.size(), what);
    };
    put(0, "LASF");
    put(24, little_endian(1, 1) + little_endian(minor, 1));
    put(94, little_endian(header_size, 2) + little_endian(header_size, 4));
    put(104, little_endian(format, 1) + little_endian(record, 2));
    put(minor == 4 ? 247 : 107, little_endian(count, minor == 4 ? 8 : 4));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(131 + 8 * axis, little_endian(std::bit_cast<std::uint64_t>(scale), 8));
      put(155 + 8 * axis, little_endian(std::bit_cast<std::uint64_t>(offset), 8));
    }
    for (const auto& point : points) {
      std::string body;
      for (const int number : point) body += little_endian(static_cast<unsigned>(number), 4);
      body.resize(record == 0 ? 20 : record);
      header += body;
    }
    return header;
  }
};

TEST(ReadLas, CoordinatesAreExactDecimals) {
  for (const unsigned minor : {2U, 3U, 4U}) {
    LasFile file;
    file.minor = minor;
    const Reading reading = reading_of(read_las, file.bytes());
    EXPECT_EQ(reading.points.decimals(), 2);
    EXPECT_EQ(coordinates_of(reading), (Numbers{501.5, 502.5, 497.5, 21475336.97, 500.5, 500.55}));
    EXPECT_EQ(reading.points.coordinates()[0], 50150.0);
  }
}

TEST(ReadLas, ScalesThatAreNoDecimalsGiveDoubles) {
  LasFile file;
  file.scale = 1.0 / 3.0;
  file.offset = 0.0;
  const Reading reading = reading_of(read_las, file.bytes());
  EXPECT_FALSE(reading.points.decimals());
  EXPECT_NEAR(reading.points.coordinate(0, 0), 100.0 / 3.0, 1e-13);
  file.scale = 1e-30;
  file.offset = 1e30;
  EXPECT_EQ(reading_of(read_las, file.bytes()).points.coordinate(0, 0), 1e30);
}

TEST(ReadLas, LongerRecordsAreSteppedOver) {
  LasFile file;
  file.format = 3;
  file.record = 50;
  EXPECT_EQ(reading_of(read_las, file.bytes()).points.coordinate(1, 2), 500.55);
}

TEST(ReadLas, DimensionTwoTakesXAndY) {
  EXPECT_EQ(coordinates_of(reading_of(read_las, LasFile{}.bytes(), {.dimension = 2})),
            (Numbers{501.5, 502.5, 21475336.97, 500.5}));
  EXPECT_NE(error_of(read_las, LasFile{}.bytes(), {.radius_column = "r"}), "");
}

TEST(ReadLas, RefusesHeadersThatLie) {
  const auto error = [](auto&& change) {
    LasFile file;
    change(file);
    return error_of(read_las, file.bytes());
  };
  EXPECT_EQ(error([](LasFile&) {}), "");
  EXPECT_NE(error([](LasFile& f) { f.count = 4294967295; }).find("byte 107: 4294967295 points"),
            std::string::npos);
  EXPECT_NE(error([](LasFile& f) { f.minor = 4, f.count = ~0ULL; }).find("byte 247"),
            std::string::npos);
  EXPECT_NE(error([](LasFile& f) { f.record = 0; }).find("record length is 0"), std::string::npos);
  EXPECT_NE(error([](LasFile& f) { f.format = 128 + 1; }).find("compressed"), std::string::npos);
  EXPECT_NE(error([](LasFile& f) { f.format = 11; }).find("point format 11"), std::string::npos);
  EXPECT_NE(error([](LasFile& f) { f.minor = 5; }).find("version 1.5"), std::string::npos);
  for (const double bad : {0.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e300}) {
    EXPECT_NE(error([&](LasFile& f) { f.scale = bad; }), "") << bad;
  }
  EXPECT_NE(error([](LasFile& f) { f.offset = std::numeric_limits<double>::quiet_NaN(); }), "");
  const std::string good = LasFile{}.bytes();
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_NE(error_of(read_las, good.substr(0, length)), "") << length;
  }
}

}  // namespace
}  // namespace orthoball
