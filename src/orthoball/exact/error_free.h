// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/exact/floating_point.h"

namespace orthoball {

/// A sum or product of two doubles without rounding: `high` is the rounded result, `low` what
/// rounding lost. @cite dekker_1971  @cite knuth_1997
struct Exactly {
  double high;
  double low;
};

/// a + b. Exact unless it overflows.
[[nodiscard, gnu::always_inline]] inline Exactly two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// a * b. Exact where |a|, |b| < 2^995 and the product is 0 or at least 2^-968 in magnitude.
[[nodiscard, gnu::always_inline]] inline Exactly two_product(double a, double b) {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1 cuts 53 bits into 26 and 27
  const double product = a * b;
  const double a_wide = kSplitter * a;
  const double a_high = a_wide - (a_wide - a);
  const double a_low = a - a_high;
  const double b_wide = kSplitter * b;
  const double b_high = b_wide - (b_wide - b);
  const double b_low = b - b_high;
  const double low =
      ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
  return {product, low};
}

}  // namespace orthoball
