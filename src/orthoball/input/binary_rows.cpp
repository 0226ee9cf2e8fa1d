// SPDX-License-Identifier: MIT
#include "orthoball/input/binary_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "orthoball/error.h"

namespace orthoball {
namespace {

template <class Bits>
Bits swapped(Bits bits) {
  if constexpr (sizeof(Bits) == 2) bits = __builtin_bswap16(bits);
  if constexpr (sizeof(Bits) == 4) bits = __builtin_bswap32(bits);
  if constexpr (sizeof(Bits) == 8) bits = __builtin_bswap64(bits);
  return bits;
}

template <class Integer>
double exact_double(Integer integer) {
  constexpr std::int64_t kLargest = std::int64_t{1} << 53;
  const auto within = [](auto x) {
    return std::cmp_less_equal(x, kLargest) && std::cmp_greater_equal(x, -kLargest);
  };
  return within(integer) ? static_cast<double>(integer) : std::numeric_limits<double>::quiet_NaN();
}

// The bytes of one number as a double, see number_from_bytes.
template <class Bits, class Number>
double double_from_bytes(const char* bytes, bool is_big_endian) {
  Bits bits;
  std::memcpy(&bits, bytes, sizeof bits);
  if (is_big_endian != (std::endian::native == std::endian::big)) bits = swapped(bits);
  if constexpr (std::is_floating_point_v<Number>) {
    return static_cast<double>(std::bit_cast<Number>(bits));
  } else if constexpr (sizeof(Number) < 8) {
    return static_cast<double>(static_cast<Number>(bits));
  } else {
    return exact_double(static_cast<Number>(bits));
  }
}

// Calls `use` with the types of a number's bits and of the number.
template <class Use>
auto with_types(NumberType type, const Use& use) {
  switch (type) {
    case NumberType::int8:
      return use.template operator()<std::uint8_t, std::int8_t>();
    case NumberType::uint8:
      return use.template operator()<std::uint8_t, std::uint8_t>();
    case NumberType::int16:
      return use.template operator()<std::uint16_t, std::int16_t>();
    case NumberType::uint16:
      return use.template operator()<std::uint16_t, std::uint16_t>();
    case NumberType::int32:
      return use.template operator()<std::uint32_t, std::int32_t>();
    case NumberType::uint32:
      return use.template operator()<std::uint32_t, std::uint32_t>();
    case NumberType::int64:
      return use.template operator()<std::uint64_t, std::int64_t>();
    case NumberType::uint64:
      return use.template operator()<std::uint64_t, std::uint64_t>();
    case NumberType::float32:
      return use.template operator()<std::uint32_t, float>();
    default:
      return use.template operator()<std::uint64_t, double>();
  }
}

// Copies numbers to every `step`-th place of `to`; false if one of them is not finite.
bool copy_numbers(const char* bytes, const BinaryColumn& from, bool is_big_endian,
                  std::size_t count, double* to, std::size_t step) {
  return with_types(from.type, [&]<class Bits, class Number>() {
    constexpr std::uint64_t kExponent = 0x7FF0000000000000U;  // all ones: not finite
    bool is_finite = true;
    for (std::size_t i = 0; i < count; ++i) {
      const double number =
          double_from_bytes<Bits, Number>(bytes + i * from.stride, is_big_endian) + 0.0;
      is_finite &= (std::bit_cast<std::uint64_t>(number) & kExponent) != kExponent;
      to[i * step] = number;
    }
    return is_finite;
  });
}

}  // namespace

std::size_t size_in_bytes(NumberType type) {
  switch (type) {
    case NumberType::int8:
    case NumberType::uint8:
      return 1;
    case NumberType::int16:
    case NumberType::uint16:
      return 2;
    case NumberType::int32:
    case NumberType::uint32:
    case NumberType::float32:
      return 4;
    default:
      return 8;
  }
}

double number_from_bytes(const char* bytes, NumberType type, bool is_big_endian) {
  return with_types(type, [&]<class Bits, class Number>() {
    return double_from_bytes<Bits, Number>(bytes, is_big_endian);
  });
}

std::uint64_t unsigned_from_bytes(const char* bytes, std::size_t size) {
  std::uint64_t bits = 0;
  while (size-- > 0) bits = bits << 8U | static_cast<unsigned char>(bytes[size]);
  return bits;
}

void BinaryRows::add(std::span<const double> row, std::size_t offset) {
  for (const std::size_t column : columns_.coordinates) {
    coordinates_.push_back(checked(row[column], offset, column));
  }
  if (columns_.weight_kind == WeightKind::none) return;
  weights_.push_back(checked(row[columns_.weight], offset, columns_.weight));
}

double BinaryRows::checked(double number, std::size_t offset, std::size_t column) const {
  if (std::isfinite(number)) return number + 0.0;  // -0 reads as 0
  throw ParseError(source_.name, 0,
                   "byte " + std::to_string(offset) + ": column " + std::to_string(column + 1) +
                       " is not finite, or an integer above 2^53 in size; numbers that a double "
                       "holds exactly are needed");
}

void BinaryRows::add_columns(std::size_t rows, bool is_big_endian,
                             const std::function<BinaryColumn(std::size_t column)>& column_at) {
  const std::size_t axes = columns_.coordinates.size();
  const bool has_weights = columns_.weight_kind != WeightKind::none;
  const std::size_t before = coordinates_.size() / axes;
  coordinates_.resize(coordinates_.size() + rows * axes);
  if (has_weights) weights_.resize(weights_.size() + rows);
  // Columns in turn, for as many rows as the nearest cache holds.
  constexpr std::size_t kRows = 512;
  for (std::size_t row = 0; row < rows; row += kRows) {
    const std::size_t count = std::min(kRows, rows - row);
    bool is_finite = true;
    const auto copy = [&](std::size_t column, double* to, std::size_t step) {
      const BinaryColumn from = column_at(column);
      const char* const bytes = source_.bytes.data() + from.first + row * from.stride;
      is_finite &= copy_numbers(bytes, from, is_big_endian, count, to, step);
    };
    for (std::size_t axis = 0; axis < axes; ++axis) {
      copy(columns_.coordinates[axis], &coordinates_[(before + row) * axes + axis], axes);
    }
    if (has_weights) copy(columns_.weight, &weights_[before + row], 1);
    for (std::size_t i = row; !is_finite && i < row + count; ++i) {
      const auto check = [&](double number, std::size_t column) {
        const BinaryColumn from = column_at(column);
        static_cast<void>(checked(number, from.first + i * from.stride, column));
      };
      for (std::size_t axis = 0; axis < axes; ++axis) {
        check(coordinates_[(before + i) * axes + axis], columns_.coordinates[axis]);
      }
      if (has_weights) check(weights_[before + i], columns_.weight);
    }
  }
}

Reading BinaryRows::reading() && {
  Reading reading{.points = {columns_.dimension, std::move(coordinates_), columns_.weight_kind,
                             std::move(weights_)},
                  .radii = columns_.radii};
  if (!columns_.note.empty()) reading.notes.push_back(columns_.note);
  return reading;
}

}  // namespace orthoball
