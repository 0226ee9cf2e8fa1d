// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "orthoball/exact/wide_integer.h"

namespace orthoball {

/// The double nearest to numerator / denominator * 2^exponent, ties to even; denominator > 0.
///
/// Correctly rounded over the whole range: subnormal, 0 and infinite where that is nearest. Int
/// must have 2 bits more than the longer of the two.
template <class Int>
[[nodiscard]] double rounded_quotient(const Int& numerator, const Int& denominator, int exponent) {
  const bool is_negative = numerator.sign() == Sign::negative;
  Int rest = is_negative ? -numerator : numerator;
  if (rest.sign() == Sign::zero) return 0.0;

  // Shift the shorter until divisor <= rest < 2 divisor; the quotient then begins with a 1.
  Int divisor = denominator;
  int shift = rest.bit_length() - divisor.bit_length();
  if (shift > 0) divisor = divisor << shift;
  if (shift < 0) rest = rest << -shift;
  if (rest < divisor) {
    rest = rest << 1;
    --shift;
  }
  // 56 bits of the quotient, and whether anything is left.
  constexpr int kBits = 56;
  std::uint64_t quotient = 1;
  rest -= divisor;
  for (int bit = 1; bit < kBits; ++bit) {
    rest = rest << 1;
    quotient <<= 1U;
    if (rest >= divisor) {
      rest -= divisor;
      quotient |= 1U;
    }
  }
  const bool has_rest = rest.sign() != Sign::zero;

  const int top = shift + exponent;  // 2^top <= value < 2^(top + 1)
  constexpr int kLeastNormal = -1022;
  const int dropped = kBits - 53 + (top < kLeastNormal ? kLeastNormal - top : 0);
  if (dropped > kBits) return is_negative ? -0.0 : 0.0;  // below half the least subnormal
  const std::uint64_t tail = quotient & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  quotient >>= static_cast<unsigned>(dropped);
  if (tail > half || (tail == half && (has_rest || (quotient & 1U) != 0))) ++quotient;
  const double value = std::ldexp(static_cast<double>(quotient), top - (kBits - 1) + dropped);
  return is_negative ? -value : value;
}

}  // namespace orthoball
