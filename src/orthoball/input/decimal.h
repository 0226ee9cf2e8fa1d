// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "orthoball/input/short_decimal.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// Holds every decimal of up to 38 digits.
__extension__ using Int128 = __int128;

/// One number of a text file, as the decimal it is and as the double nearest to it.
struct DecimalNumber {
  double nearest = 0.0;  ///< correctly rounded; never -0
  int exponent = 0;      ///< number = digits * 10^exponent, if `is_exact`
  bool is_exact = true;  ///< false where there are more than 38 digits
  Int128 digits = 0;     ///< has no trailing zeros; 0 with exponent 0 for zero
};

/// What is wrong with a text that should be a number.
enum class DecimalFault { none, not_a_number, not_finite, out_of_range };

/// A number, or why there is none (then `number` is 0).
struct DecimalParse {
  DecimalNumber number;
  DecimalFault fault = DecimalFault::none;
};

/// The number that the whole of `text` spells: optional sign, digits with an optional point,
/// optional exponent after e, E (Fortran's d, D too). No blanks, no hexadecimal, no locale.
/// `nan`, `inf` and their kin are DecimalFault::not_finite; values beyond the double range are
/// out_of_range; values that round to 0 are 0. Linear in the length of the text.
[[nodiscard]] DecimalParse parse_decimal(std::string_view text);

/// The number digits * 10^exponent; it must not round to infinity.
[[nodiscard]] DecimalNumber decimal_number(Int128 digits, int exponent);

/// Collects the numbers of one input row by row, and decides whether all of them are decimal
/// fixed-point numbers (all or nothing per input) or all the nearest doubles.
///
/// Costs one double a number (two a weight) whatever is added: rows are kept as integers in units
/// of the most decimals seen so far, and turned into doubles by the first number that does not fit.
class DecimalRows {
 public:
  DecimalRows(int dimension, WeightKind kind) : dimension_(dimension), kind_(kind) {}

  /// Memory for so many rows at once; a hint.
  void reserve(std::size_t rows);

  /// Adds one site.
  /// @param coordinates  `dimension` numbers.
  /// @param weight       radius or weight, ignored for WeightKind::none.
  void add(std::span<const DecimalNumber> coordinates, const DecimalNumber& weight = {});
  /// Adds one site the fast way: where all numbers so far are integers in one unit, and so are
  /// these.
  /// @param numbers  the coordinates, then the radius if there is one.
  /// @return false, with nothing added, where the row needs `add` (always with
  ///         WeightKind::weight).
  [[nodiscard]] bool add_short(std::span<const ShortDecimal> numbers);
  /// Adds one site as the doubles nearest to its numbers; only where `is_fixed()` is false.
  /// @param numbers  the coordinates, then the radius or weight if there is one; finite, never -0.
  void add_nearest(std::span<const double> numbers);
  /// Whether the numbers are still held as integers in one unit. Never becomes true again.
  [[nodiscard]] bool is_fixed() const { return is_fixed_; }
  [[nodiscard]] std::size_t size() const { return rows_; }

  /// The points: fixed-point with the smallest `decimals` that holds every coordinate and radius
  /// (a weight needs half its decimals, rounded up) if all of them are then integers of at most
  /// 2^53 (weights 106 bits), doubles otherwise. Takes the numbers with it:
  /// `std::move(rows).points()`.
  [[nodiscard]] WeightedPoints points() &&;

 private:
  [[nodiscard]] bool fits(std::span<const DecimalNumber> coordinates, const DecimalNumber& weight);
  [[nodiscard]] bool widen(int decimals);
  void become_doubles();

  int dimension_;
  WeightKind kind_;
  std::size_t rows_ = 0;
  bool is_fixed_ = true;  // the arrays hold integers, not doubles
  int decimals_ = 0;
  double largest_ = 0.0;             // of the integers among coordinates and radii
  Int128 largest_weight_ = 0;        // of the integers among weights
  std::vector<double> coordinates_;  // [dimension * row + axis]
  std::vector<double> weights_;      // [row]
  std::vector<double> weights_low_;  // [row], only for integers of WeightKind::weight
};

}  // namespace orthoball
