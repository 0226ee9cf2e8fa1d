// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/exact/error_free.h"

namespace orthoball {

/// Error-free products by splitting the factors: on any machine. @cite dekker_1971
struct SplitProducts {
  [[gnu::always_inline]] static Exactly two_product(double a, double b) {
    return orthoball::two_product(a, b);
  }
};

/// The same numbers by one fused multiply-add, where the machine has it.
struct FusedProducts {
  [[gnu::always_inline]] static Exactly two_product(double a, double b) {
    const double product = a * b;
    return {product, __builtin_fma(a, b, -product)};
  }
};

/// An unevaluated sum of two doubles, about 106 bits: the number type of certified labels.
///
/// With u = 2^-53 every sum and product below errs by at most 8 u^2 times the magnitudes it is made
/// of (|a| + |b|, |a b|), a quotient by 16 u^2 |a / b|, as long as nothing over- or underflows;
/// docs/derivations/orthoradius.md counts. `high` is the sum rounded to a double, up to
/// that error. Without branches, so that loops over many numbers become vector instructions.
/// @cite dekker_1971  @cite joldes_2017
template <class Products>
struct DoubleDoubleOf {
  double high = 0.0;
  double low = 0.0;
};

/// A double that stands for a number exactly; its products are rounded only as a DoubleDouble is.
template <class Products>
struct ExactDoubleOf {
  double value = 0.0;
};

/// Both for any machine.
using DoubleDouble = DoubleDoubleOf<SplitProducts>;
using ExactDouble = ExactDoubleOf<SplitProducts>;

/// a + b where |a| >= |b| or a is 0. Exact; otherwise errs by at most 2 u |b|.
template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> operator-(
    const DoubleDoubleOf<Products>& a) {
  return {-a.high, -a.low};
}
template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> operator+(
    const DoubleDoubleOf<Products>& a, const DoubleDoubleOf<Products>& b) {
  const Exactly sum = two_sum(a.high, b.high);
  return fast_two_sum<Products>(sum.high, sum.low + (a.low + b.low));
}
template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> operator-(
    const DoubleDoubleOf<Products>& a, const DoubleDoubleOf<Products>& b) {
  return a + -b;
}
template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> operator*(
    const DoubleDoubleOf<Products>& a, const DoubleDoubleOf<Products>& b) {
  const Exactly product = Products::two_product(a.high, b.high);
  return fast_two_sum<Products>(product.high, product.low + (a.high * b.low + a.low * b.high));
}
template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> operator*(
    const ExactDoubleOf<Products>& a, const ExactDoubleOf<Products>& b) {
  const Exactly product = Products::two_product(a.value, b.value);
  return {product.high, product.low};
}
template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> operator*(
    const DoubleDoubleOf<Products>& a, const ExactDoubleOf<Products>& b) {
  const Exactly product = Products::two_product(a.high, b.value);
  return fast_two_sum<Products>(product.high, product.low + a.low * b.value);
}
template <class Products>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Products> operator/(
    const DoubleDoubleOf<Products>& a, const DoubleDoubleOf<Products>& b) {
  const double quotient = a.high / b.high;
  const Exactly product = Products::two_product(quotient, b.high);
  const double rest = (((a.high - product.high) - product.low) + a.low) - quotient * b.low;
  return fast_two_sum<Products>(quotient, rest / b.high);
}

}  // namespace orthoball
