// SPDX-License-Identifier: MIT
//
// LAS point clouds, versions 1.0 to 1.4, not compressed. A coordinate is an integer times the
// file's scale plus its offset. Scale and offset are stored as doubles; the shortest decimals that
// round to them ("0.01") are what their writer meant, so the coordinate is read as that decimal.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/binary_rows.h"
#include "orthoball/input/decimal.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"

namespace orthoball {
namespace {

using namespace std::string_view_literals;

// Bytes of a point record by its format, and of the header by the minor version.
constexpr std::array<std::size_t, 11> kRecordSizes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr std::array<std::size_t, 5> kHeaderSizes = {227, 227, 227, 235, 375};

// One axis: integer * scale + offset, exactly where both fit.
struct Axis {
  double scale = 1.0, offset = 0.0;
  bool is_exact = false;
  int exponent = 0;  // of the integers below
  Int128 scale_digits = 1, offset_digits = 0;

  [[nodiscard]] DecimalNumber coordinate(std::int32_t integer) const {
    if (is_exact) return decimal_number(integer * scale_digits + offset_digits, exponent);
    DecimalNumber number;
    number.nearest = integer * scale + offset + 0.0;
    number.is_exact = false;
    return number;
  }
};

Axis axis_of(double scale, double offset) {
  const DecimalNumber s = parse_decimal(fmt::format("{}", scale)).number;
  const DecimalNumber o = parse_decimal(fmt::format("{}", offset)).number;
  Axis axis{.scale = scale, .offset = offset};
  axis.exponent = o.digits == 0 ? s.exponent : std::min(s.exponent, o.exponent);
  // With at most 17 digits each, the product with 32 bits and the sum stay below 2^121.
  constexpr int kMostScaleZeros = 9, kMostOffsetZeros = 19;
  if (s.exponent - axis.exponent > kMostScaleZeros ||
      o.exponent - axis.exponent > kMostOffsetZeros) {
    return axis;
  }
  const auto with_zeros = [](Int128 digits, int zeros) {
    while (zeros-- > 0) digits *= 10;
    return digits;
  };
  axis.scale_digits = with_zeros(s.digits, s.exponent - axis.exponent);
  axis.offset_digits = with_zeros(o.digits, o.exponent - axis.exponent);
  axis.is_exact = true;
  return axis;
}

struct Header {
  std::size_t data = 0;    // offset of the first record
  std::size_t record = 0;  // bytes of one
  std::size_t points = 0;
  std::array<Axis, 3> axes;
};

Header header_of(const Source& source) {
  const std::string_view bytes = source.bytes;
  const auto fail = [&](std::size_t offset, const std::string& message) {
    throw ParseError(source.name, 0, "byte " + std::to_string(offset) + ": " + message);
  };
  const auto number = [&](std::size_t offset, std::size_t size) {
    return static_cast<std::size_t>(unsigned_from_bytes(bytes.data() + offset, size));
  };
  if (bytes.substr(0, 4) != "LASF"sv) fail(0, "not a LAS file; it must begin with LASF");
  if (bytes.size() < kHeaderSizes[0]) fail(bytes.size(), "the file ends within the header");
  const std::size_t minor = number(25, 1);
  if (number(24, 1) != 1 || minor >= kHeaderSizes.size()) {
    fail(24, "version " + std::to_string(number(24, 1)) + "." + std::to_string(minor) +
                 " of LAS; 1.0 to 1.4 are read");
  }
  const std::size_t header_size = number(94, 2);
  if (header_size < kHeaderSizes[minor] || header_size > bytes.size()) {
    fail(94, "a header of " + std::to_string(header_size) + " bytes; at least " +
                 std::to_string(kHeaderSizes[minor]) + ", all of them in the file, are needed");
  }
  Header header;
  header.data = number(96, 4);
  const std::size_t format = number(104, 1);
  header.record = number(105, 2);
  header.points = minor == 4 ? number(247, 8) : number(107, 4);
  if (format >= 64) {
    fail(104, "compressed LAS (LAZ) is not read; convert it with laszip or laspy to LAS");
  }
  if (format >= kRecordSizes.size()) {
    fail(104, "point format " + std::to_string(format) + "; 0 to 10 are read");
  }
  if (header.record < kRecordSizes[format]) {
    fail(105, "the record length is " + std::to_string(header.record) + "; point format " +
                  std::to_string(format) + " needs at least " +
                  std::to_string(kRecordSizes[format]));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto real = [&](std::size_t offset) {
      return number_from_bytes(bytes.data() + offset, NumberType::float64, false);
    };
    const double scale = real(131 + 8 * axis), offset = real(155 + 8 * axis);
    if (!std::isfinite(scale) || scale == 0.0) {
      fail(131 + 8 * axis, fmt::format("the scale is {}; it must be finite and not 0", scale));
    }
    if (!std::isfinite(offset) || !std::isfinite(2147483648.0 * scale + std::abs(offset)) ||
        !std::isfinite(2147483648.0 * scale - std::abs(offset))) {
      fail(155 + 8 * axis, fmt::format("the offset is {}; coordinates must be finite", offset));
    }
    header.axes[axis] = axis_of(scale, offset);
  }
  if (header.data < header_size || header.data > bytes.size()) {
    fail(96, "point data begin at byte " + std::to_string(header.data) + " of " +
                 std::to_string(bytes.size()) + "; they must lie behind the header");
  }
  const std::size_t present = (bytes.size() - header.data) / header.record;
  if (header.points > present) {
    fail(minor == 4 ? 247 : 107, counted(header.points, "point") + " announced, " +
                                     std::to_string(present) + " found; the file is incomplete");
  }
  return header;
}

}  // namespace

Reading read_las(const Source& source, const ReadOptions& options) {
  const Header header = header_of(source);
  const std::array<std::string, 3> names = {"x", "y", "z"};
  const Columns columns =
      chosen_columns(source.name, options, {.names = names, .columns = 3, .numbers = 3, .line = 0});
  DecimalRows rows(columns.dimension, columns.weight_kind);
  rows.reserve(header.points);
  const auto coordinate = [&](std::size_t point, std::size_t axis) {
    const char* at = source.bytes.data() + header.data + point * header.record + 4 * axis;
    return header.axes[axis].coordinate(static_cast<std::int32_t>(unsigned_from_bytes(at, 4)));
  };
  std::vector<DecimalNumber> row(columns.coordinates.size());
  for (std::size_t point = 0; point < header.points; ++point) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = coordinate(point, columns.coordinates[i]);
    rows.add(row, columns.weight_kind == WeightKind::none ? DecimalNumber{}
                                                          : coordinate(point, columns.weight));
  }
  Reading reading{.points = std::move(rows).points(), .radii = columns.radii};
  if (!columns.note.empty()) reading.notes.push_back(columns.note);
  return reading;
}

}  // namespace orthoball
