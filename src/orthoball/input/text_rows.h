// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/input/columns.h"
#include "orthoball/input/decimal.h"
#include "orthoball/input/plain_row.h"
#include "orthoball/input/source.h"

namespace orthoball {

/// Turns the rows of a text file, given as fields, into a reading: picks the columns at the first
/// row, holds every row to the same number of fields, keeps the lines.
class TextRows {
 public:
  /// Both must live as long as this does.
  TextRows(const Source& source, const ReadOptions& options)
      : source_(source), options_(options), rows_(3, WeightKind::none) {}

  /// Names the columns, from line `line`; before the first row.
  void name_columns(std::size_t line, std::vector<std::string> names);
  /// Multiplies every length by `scale`, which is positive.
  void scale_by(const DecimalNumber& scale);

  /// @throws ParseError at `line` for a wrong number of fields or a field that is no number.
  /// @throws InputError for options that do not fit the columns.
  void add(std::size_t line, std::span<const std::string_view> fields);
  /// Adds the rows that follow in `lines`, and takes them from there, as long as they are plain.
  /// Others are left for `add`, which says what is wrong or knows better; so are the first row and
  /// scaled ones. The result is the same, at many times the speed.
  /// @return how many rows were added.
  std::size_t add_plain(Lines& lines, const PlainRows& plain);
  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  /// The most decimals any coordinate or radius given to `add` had before it was scaled.
  [[nodiscard]] int decimals() const { return decimals_; }

  /// All but `file` and `format`. Takes the rows with it.
  [[nodiscard]] Reading reading() &&;

 private:
  void choose(std::size_t line, std::span<const std::string_view> fields);
  void add_line(std::size_t line);
  [[nodiscard]] std::vector<std::uint8_t> slots() const;
  [[nodiscard]] DecimalNumber number(std::size_t line, std::span<const std::string_view> fields,
                                     std::size_t column) const;

  const Source& source_;
  const ReadOptions& options_;
  std::vector<std::string> names_;
  std::size_t names_line_ = 0;
  std::size_t first_line_ = 0;  // of the names or else the first row: it sets the count
  std::size_t count_ = 0;       // fields in every row
  DecimalNumber scale_;
  bool is_scaled_ = false;
  int decimals_ = 0;
  Columns columns_;
  std::vector<DecimalNumber> numbers_;  // of one row
  std::vector<std::uint8_t> slots_;     // [column] as read_plain_row wants; empty if one
                                        // column has two uses
  DecimalRows rows_;
  std::vector<std::uint32_t> lines_;  // [row]
};

}  // namespace orthoball
