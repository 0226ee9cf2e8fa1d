// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/exact/error_free.h"

namespace orthoball {

/// An unevaluated sum of two doubles, about 106 bits: the number type of certified labels.
///
/// With u = 2^-53 every operation below errs by at most 8 u^2 times the magnitudes it is made of
/// (|a| + |b| for sums, |a b| for products, |a / b| for quotients), as long as nothing over- or
/// underflows; docs/derivations/orthoradius.md counts. `high` is the sum rounded to a double, up to
/// that error.  @cite dekker_1971  @cite joldes_2017
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;
};

/// A double that stands for a number exactly; its products are rounded only as a DoubleDouble is.
struct ExactDouble {
  double value = 0.0;
};

/// a + b where |a| >= |b| or a is 0. Exact; otherwise errs by at most u |b|.
[[nodiscard]] inline DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

[[nodiscard]] inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const Exactly sum = two_sum(a.high, b.high);
  return fast_two_sum(sum.high, sum.low + (a.low + b.low));
}
[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}
[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const Exactly product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
[[nodiscard]] inline DoubleDouble operator*(const ExactDouble& a, const ExactDouble& b) {
  const Exactly product = two_product(a.value, b.value);
  return {product.high, product.low};
}
[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const ExactDouble& b) {
  const Exactly product = two_product(a.high, b.value);
  return fast_two_sum(product.high, product.low + a.low * b.value);
}
[[nodiscard]] inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double quotient = a.high / b.high;
  const Exactly product = two_product(quotient, b.high);
  const double rest = (((a.high - product.high) - product.low) + a.low) - quotient * b.low;
  return fast_two_sum(quotient, rest / b.high);
}

}  // namespace orthoball
