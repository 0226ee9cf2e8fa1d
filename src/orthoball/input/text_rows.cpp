// SPDX-License-Identifier: MIT
#include "orthoball/input/text_rows.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"

namespace orthoball {
namespace {

// The product of two decimals, exact where both are short.
DecimalNumber product(const DecimalNumber& a, const DecimalNumber& b) {
  const auto is_short = [](const DecimalNumber& number) {
    constexpr auto kLimit = Int128{1} << 63;
    return number.is_exact && number.digits < kLimit && number.digits > -kLimit;
  };
  const double nearest = a.nearest * b.nearest;
  if (is_short(a) && is_short(b) && std::isfinite(nearest)) {
    return decimal_number(a.digits * b.digits, a.exponent + b.exponent);
  }
  return {nearest + 0.0, 0, false, 0};
}

// The double nearest to the number at `at`, in the grammar of parse_decimal but for Fortran's d.
const char* parse_nearest(const char* at, const char* end, double& number) {
  const bool is_positive = at != end && *at == '+';
  if (is_positive) ++at;
  // fast_float would skip line ends, too.
  if (at == end || *at <= ' ' || (is_positive && *at == '-')) return nullptr;
  const auto [after, error] = fast_float::from_chars(at, end, number);
  if (error != std::errc() || !std::isfinite(number)) return nullptr;
  number += 0.0;  // -0 reads as 0
  return after;
}

}  // namespace

void TextRows::name_columns(std::size_t line, std::vector<std::string> names) {
  names_ = std::move(names);
  names_line_ = line;
}

void TextRows::scale_by(const DecimalNumber& scale) {
  scale_ = scale;
  is_scaled_ = true;
}

void TextRows::choose(std::size_t line, std::span<const std::string_view> fields) {
  first_line_ = names_.empty() ? line : names_line_;
  count_ = names_.empty() ? fields.size() : names_.size();
  if (count_ != fields.size()) return;
  const auto is_number = [](std::string_view field) {
    return parse_decimal(field).fault != DecimalFault::not_a_number;
  };
  const auto numbers = std::count_if(fields.begin(), fields.end(), is_number);
  columns_ = chosen_columns(source_.name, options_,
                            {names_, count_, static_cast<std::size_t>(numbers), line});
  rows_ = DecimalRows(columns_.dimension, columns_.weight_kind);
  numbers_.resize(columns_.coordinates.size());
  slots_ = slots();

  std::size_t length = fields.size();
  for (const std::string_view field : fields) length += field.size();
  const std::size_t rows = source_.bytes.size() / length;  // if all are as long as this one
  rows_.reserve(rows);
  lines_.reserve(rows);
}

DecimalNumber TextRows::number(std::size_t line, std::span<const std::string_view> fields,
                               std::size_t column) const {
  const DecimalParse parse = parse_decimal(fields[column]);
  if (parse.fault == DecimalFault::none) return parse.number;
  const bool has_name = column < names_.size() && !names_[column].empty();
  return number_at(source_, line, fields[column],
                   "column " + std::to_string(column + 1) +
                       (has_name ? " (" + quoted(names_[column]) + ")" : ""));
}

void TextRows::add(std::size_t line, std::span<const std::string_view> fields) {
  if (lines_.empty()) choose(line, fields);
  if (fields.size() != count_) {
    throw ParseError(source_.name, line,
                     counted(fields.size(), "column") + ", expected " + std::to_string(count_) +
                         " as on line " + std::to_string(first_line_));
  }
  DecimalNumber weight;
  for (std::size_t axis = 0; axis < numbers_.size(); ++axis) {
    numbers_[axis] = number(line, fields, columns_.coordinates[axis]);
  }
  if (columns_.weight_kind != WeightKind::none) weight = number(line, fields, columns_.weight);
  for (const DecimalNumber& number : numbers_) decimals_ = std::max(decimals_, -number.exponent);
  if (columns_.weight_kind == WeightKind::radius) {
    decimals_ = std::max(decimals_, -weight.exponent);
  }
  if (is_scaled_) {
    for (DecimalNumber& number : numbers_) number = product(number, scale_);
    weight = product(weight, scale_);
    if (columns_.weight_kind == WeightKind::weight) weight = product(weight, scale_);
    const auto is_large = [](const DecimalNumber& number) {
      return !std::isfinite(number.nearest);
    };
    if (is_large(weight) || std::any_of(numbers_.begin(), numbers_.end(), is_large)) {
      throw ParseError(source_.name, line,
                       "a number times the scale is out of range; numbers must be below 1.8e308");
    }
  }
  rows_.add(numbers_, weight);
  add_line(line);
}

void TextRows::add_line(std::size_t line) {
  lines_.push_back(static_cast<std::uint32_t>(
      std::min<std::size_t>(line, std::numeric_limits<std::uint32_t>::max())));
}

std::vector<std::uint8_t> TextRows::slots() const {
  std::vector<std::uint8_t> slots(count_, kUnusedColumn);
  std::vector<std::size_t> used = columns_.coordinates;
  if (columns_.weight_kind != WeightKind::none) used.push_back(columns_.weight);
  for (std::size_t slot = 0; slot < used.size(); ++slot) {
    if (slots[used[slot]] != kUnusedColumn) return {};
    slots[used[slot]] = static_cast<std::uint8_t>(slot);
  }
  return slots;
}

std::size_t TextRows::add_plain(Lines& lines, const PlainRows& plain) {
  if (lines_.empty() || is_scaled_ || slots_.empty()) return 0;
  const std::string_view rest = lines.rest();
  const char* at = rest.data();
  const char* const end = at + rest.size();
  const std::size_t axes = numbers_.size();
  const std::size_t width = axes + (columns_.weight_kind == WeightKind::none ? 0 : 1);
  std::array<ShortDecimal, 4> decimals;
  std::array<double, 4> nearest;
  std::size_t rows = 0;
  for (; rows < plain.most && at != end; ++rows) {
    const char* next = nullptr;
    if (rows_.is_fixed()) {
      next = read_plain_row(at, end, plain, slots_, decimals.data(), parse_short_decimal);
      if (next == nullptr) break;
      if (!rows_.add_short({decimals.data(), width})) {
        const auto number = [&](std::size_t slot) {
          return decimal_number(decimals[slot].digits, -decimals[slot].decimals);
        };
        for (std::size_t axis = 0; axis < axes; ++axis) numbers_[axis] = number(axis);
        rows_.add(numbers_, width == axes ? DecimalNumber{} : number(axes));
      }
    } else {
      next = read_plain_row(at, end, plain, slots_, nearest.data(), parse_nearest);
      if (next == nullptr) break;
      rows_.add_nearest({nearest.data(), width});
    }
    at = next;
    add_line(lines.number() + rows + 1);
  }
  lines.skip(rows, {at, static_cast<std::size_t>(end - at)});
  return rows;
}

Reading TextRows::reading() && {
  if (lines_.empty()) {
    rows_ = DecimalRows(dimension_without_rows(options_, names_), WeightKind::none);
    columns_.radii = "none";
  }
  Reading reading{.points = std::move(rows_).points(), .radii = columns_.radii};
  reading.labels.line = std::move(lines_);
  if (!columns_.note.empty()) reading.notes.push_back(columns_.note);
  return reading;
}

}  // namespace orthoball
