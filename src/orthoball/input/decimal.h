// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// One number of a text file, as the decimal it is and as the double nearest to it.
struct DecimalNumber {
  double nearest = 0.0;     ///< correctly rounded; never -0
  std::int64_t digits = 0;  ///< number = digits * 10^exponent, if `is_exact`
  int exponent = 0;         ///< digits has no trailing zeros; 0 for zero
  bool is_exact = true;     ///< false where the digits do not fit 63 bits
};

/// What is wrong with a text that should be a number.
enum class DecimalFault { none, not_a_number, not_finite, out_of_range };

struct DecimalParse {
  DecimalNumber number;
  DecimalFault fault = DecimalFault::none;
};

/// The number that the whole of `text` spells: optional sign, digits with an optional point,
/// optional exponent after e, E (Fortran's d, D too). No blanks, no hexadecimal, no locale.
/// `nan`, `inf` and their kin are DecimalFault::not_finite; values beyond the double range are
/// out_of_range; values below it round to 0. Linear in the length of the text.
[[nodiscard]] DecimalParse parse_decimal(std::string_view text);

/// Collects the numbers of one input row by row, and decides at the end whether all of them are
/// decimal fixed-point numbers (design: all or nothing per input) or all the nearest doubles.
class DecimalRows {
 public:
  DecimalRows(int dimension, WeightKind kind) : dimension_(dimension), kind_(kind) {}

  /// Adds one site.
  /// @param coordinates  `dimension` numbers.
  /// @param weight       radius or weight, ignored for WeightKind::none.
  void add(std::span<const DecimalNumber> coordinates, const DecimalNumber& weight = {});
  [[nodiscard]] std::size_t size() const { return rows_; }

  /// The points: fixed-point with the smallest `decimals` that holds every coordinate and radius
  /// (a weight needs half its decimals, rounded up) if all of them are then integers of at most
  /// 2^53 (weights 106 bits), doubles otherwise.
  [[nodiscard]] WeightedPoints points() const;

 private:
  int dimension_;
  WeightKind kind_;
  std::size_t rows_ = 0;
  std::vector<DecimalNumber> coordinates_;  // [dimension * row + axis]
  std::vector<DecimalNumber> weights_;      // [row]
};

}  // namespace orthoball
