// SPDX-License-Identifier: MIT
#include "orthoball/input/binary_rows.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "orthoball/error.h"

namespace orthoball {
namespace {

std::uint64_t bits_from_bytes(const char* bytes, std::size_t size, bool is_big_endian) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[is_big_endian ? i : size - 1 - i]);
    bits = bits << 8U | byte;
  }
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
  const std::uint64_t bits = bits_from_bytes(bytes, size_in_bytes(type), is_big_endian);
  switch (type) {
    case NumberType::int8:
      return static_cast<std::int8_t>(bits);
    case NumberType::int16:
      return static_cast<std::int16_t>(bits);
    case NumberType::int32:
      return static_cast<std::int32_t>(bits);
    case NumberType::int64:
      return exact_double(static_cast<std::int64_t>(bits));
    case NumberType::float32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case NumberType::float64:
      return std::bit_cast<double>(bits);
    default:
      return exact_double(bits);
  }
}

std::uint64_t unsigned_from_bytes(const char* bytes, std::size_t size) {
  return bits_from_bytes(bytes, size, false);
}

void BinaryRows::add(std::span<const double> row, std::size_t offset) {
  const auto checked = [&](std::size_t column) {
    const double number = row[column] + 0.0;  // -0 reads as 0
    if (std::isfinite(number)) return number;
    throw ParseError(source_.name, 0,
                     "byte " + std::to_string(offset) + ": column " + std::to_string(column + 1) +
                         " holds no finite number that a double can hold; it must");
  };
  for (const std::size_t column : columns_.coordinates) coordinates_.push_back(checked(column));
  if (columns_.weight_kind != WeightKind::none) weights_.push_back(checked(columns_.weight));
}

Reading BinaryRows::reading() && {
  Reading reading{.points = {columns_.dimension, std::move(coordinates_), columns_.weight_kind,
                             std::move(weights_)},
                  .radii = columns_.radii};
  if (!columns_.note.empty()) reading.notes.push_back(columns_.note);
  return reading;
}

}  // namespace orthoball
