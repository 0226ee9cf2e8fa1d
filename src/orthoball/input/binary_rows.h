// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "orthoball/input/columns.h"
#include "orthoball/input/source.h"

namespace orthoball {

/// The kinds of numbers in binary files.
enum class NumberType {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
};

/// 1, 2, 4 or 8.
[[nodiscard]] std::size_t size_in_bytes(NumberType type);

/// The number whose size_in_bytes(type) bytes begin at `bytes`, as a double. NaN for an integer
/// above 2^53 in size, which a double might not hold.
[[nodiscard]] double number_from_bytes(const char* bytes, NumberType type, bool is_big_endian);

/// An unsigned little-endian number of `size` <= 8 bytes.
[[nodiscard]] std::uint64_t unsigned_from_bytes(const char* bytes, std::size_t size);

/// Numbers of one type at equal distances.
struct BinaryColumn {
  std::size_t first = 0;   ///< offset of the first one from the begin of the file, in bytes
  std::size_t stride = 0;  ///< from each to the next, in bytes
  NumberType type = NumberType::float64;
};

/// Collects the rows of a binary file as the doubles they are.
class BinaryRows {
 public:
  /// `source` must live as long as this does.
  BinaryRows(const Source& source, Columns columns)
      : source_(source), columns_(std::move(columns)) {}

  /// @param row     all columns.
  /// @param offset  in bytes from the begin of the file, for messages.
  /// @throws ParseError for a number that is not finite.
  void add(std::span<const double> row, std::size_t offset);

  /// Adds many rows at once, of which the file must hold all bytes.
  /// @param column_at  where a column is, by its 0-based number.
  /// @throws ParseError for a number that is not finite, the first such row by row.
  void add_columns(std::size_t rows, bool is_big_endian,
                   const std::function<BinaryColumn(std::size_t column)>& column_at);

  /// All but `file` and `format`. Takes the rows with it.
  [[nodiscard]] Reading reading() &&;

 private:
  [[nodiscard]] double checked(double number, std::size_t offset, std::size_t column) const;

  const Source& source_;
  Columns columns_;
  std::vector<double> coordinates_;  // [dimension * row + axis]
  std::vector<double> weights_;      // [row]
};

}  // namespace orthoball
