// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "orthoball/exact/sign.h"

namespace orthoball {

/// A signed integer of 64 N bits on the stack: the number type of every exact stage.
///
/// Two's complement, little-endian limbs, arithmetic modulo 2^(64 N). It is exact as long as the
/// caller has chosen N so that every result fits, which the bit counts of local_frame.h tell;
/// nothing checks it here. Products cost N (N + 1) / 2 multiplications of words.
template <int N>
class WideInteger {
 public:
  static constexpr int kBits = 64 * N;

  constexpr WideInteger() = default;           // zero
  constexpr WideInteger(std::int64_t value) {  // NOLINT(google-explicit-constructor): a number
    limbs_[0] = static_cast<std::uint64_t>(value);
    for (std::size_t i = 1; i < kLimbs; ++i) limbs_[i] = value < 0 ? ~std::uint64_t{0} : 0;
  }

  [[nodiscard]] constexpr Sign sign() const {
    if (static_cast<std::int64_t>(limbs_[kLimbs - 1]) < 0) return Sign::negative;
    for (const std::uint64_t limb : limbs_) {
      if (limb != 0) return Sign::positive;
    }
    return Sign::zero;
  }

  /// Number of bits of the magnitude; 0 for zero.
  [[nodiscard]] constexpr int bit_length() const {
    const WideInteger magnitude = sign() == Sign::negative ? -*this : *this;
    for (std::size_t i = kLimbs; i-- > 0;) {
      if (magnitude.limbs_[i] != 0) {
        return static_cast<int>(64 * i) + static_cast<int>(std::bit_width(magnitude.limbs_[i]));
      }
    }
    return 0;
  }

  /// The same number with more limbs, or with fewer where it fits those.
  template <int M>
  [[nodiscard]] constexpr WideInteger<M> resized() const {
    WideInteger<M> result(sign() == Sign::negative ? -1 : 0);
    for (std::size_t i = 0; i < kLimbs && i < std::size_t{M}; ++i) result.limbs_[i] = limbs_[i];
    return result;
  }

  /// The lowest limb.
  [[nodiscard]] constexpr std::uint64_t lowest_limb() const { return limbs_[0]; }
  /// The limbs, lowest first.
  [[nodiscard]] constexpr const std::array<std::uint64_t, static_cast<std::size_t>(N)>& limbs()
      const {
    return limbs_;
  }

  friend constexpr WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    WideInteger sum;
    unsigned carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      const Word total = Word{a.limbs_[i]} + b.limbs_[i] + carry;
      sum.limbs_[i] = static_cast<std::uint64_t>(total);
      carry = static_cast<unsigned>(total >> 64U);
    }
    return sum;
  }
  friend constexpr WideInteger operator-(const WideInteger& a, const WideInteger& b) {
    WideInteger difference;
    unsigned borrow = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      const Word total = Word{a.limbs_[i]} - b.limbs_[i] - borrow;
      difference.limbs_[i] = static_cast<std::uint64_t>(total);
      borrow = static_cast<unsigned>(total >> 64U) & 1U;
    }
    return difference;
  }
  friend constexpr WideInteger operator-(const WideInteger& a) { return WideInteger() - a; }
  friend constexpr WideInteger operator*(const WideInteger& a, const WideInteger& b) {
    if constexpr (!kIsLong) return low_product(a, b);
    // Magnitudes have zeros to leave out where negative numbers have ones.
    const bool a_is_negative = a.sign() == Sign::negative;
    const bool b_is_negative = b.sign() == Sign::negative;
    const WideInteger product = low_product(a_is_negative ? -a : a, b_is_negative ? -b : b);
    return a_is_negative != b_is_negative ? -product : product;
  }
  /// a * b, which always fits N + M limbs.
  template <int M>
  friend constexpr WideInteger<N + M> product(const WideInteger& a, const WideInteger<M>& b) {
    return a.times(b);
  }
  friend constexpr WideInteger operator<<(const WideInteger& a, int bits) {
    const auto whole = static_cast<std::size_t>(bits / 64);
    const auto part = static_cast<unsigned>(bits % 64);
    WideInteger shifted;
    for (std::size_t i = kLimbs; i-- > whole;) {
      shifted.limbs_[i] = a.limbs_[i - whole] << part;
      if (part != 0 && i > whole) shifted.limbs_[i] |= a.limbs_[i - whole - 1] >> (64U - part);
    }
    return shifted;
  }

  constexpr WideInteger& operator+=(const WideInteger& b) { return *this = *this + b; }
  constexpr WideInteger& operator-=(const WideInteger& b) { return *this = *this - b; }
  constexpr WideInteger& operator*=(const WideInteger& b) { return *this = *this * b; }

  friend constexpr bool operator==(const WideInteger&, const WideInteger&) = default;
  friend constexpr std::strong_ordering operator<=>(const WideInteger& a, const WideInteger& b) {
    const auto top_a = static_cast<std::int64_t>(a.limbs_[kLimbs - 1]);
    const auto top_b = static_cast<std::int64_t>(b.limbs_[kLimbs - 1]);
    if (top_a != top_b) return top_a <=> top_b;
    for (std::size_t i = kLimbs - 1; i-- > 0;) {
      if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] <=> b.limbs_[i];
    }
    return std::strong_ordering::equal;
  }

 private:
  template <int M>
  friend class WideInteger;

  static constexpr auto kLimbs = static_cast<std::size_t>(N);
  __extension__ using Word = unsigned __int128;

  // Of mixed scales most numbers are short for the width.
  static constexpr bool kIsLong = N > 16;

  // The low N limbs of the product of the words, signed or not.
  [[nodiscard]] static constexpr WideInteger low_product(const WideInteger& a,
                                                         const WideInteger& b) {
    std::size_t begin = 0, end = kLimbs;  // of the limbs of b that count
    if constexpr (kIsLong) {
      while (end > 0 && b.limbs_[end - 1] == 0) --end;
      while (begin < end && b.limbs_[begin] == 0) ++begin;
    }
    WideInteger product;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      if (a.limbs_[i] == 0) continue;
      std::uint64_t carry = 0;
      std::size_t j = begin;
      for (; j < end && i + j < kLimbs; ++j) {
        const Word total = Word{a.limbs_[i]} * b.limbs_[j] + product.limbs_[i + j] + carry;
        product.limbs_[i + j] = static_cast<std::uint64_t>(total);
        carry = static_cast<std::uint64_t>(total >> 64U);
      }
      if (i + j < kLimbs) product.limbs_[i + j] = carry;  // still 0: rows before end below
    }
    return product;
  }

  // The product of the words as unsigned numbers, less 2^(64 N) b where a < 0, and the reverse.
  template <int M>
  [[nodiscard]] constexpr WideInteger<N + M> times(const WideInteger<M>& b) const {
    constexpr auto kOther = static_cast<std::size_t>(M);
    WideInteger<N + M> product;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      if (limbs_[i] == 0) continue;
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < kOther; ++j) {
        const Word total = Word{limbs_[i]} * b.limbs_[j] + product.limbs_[i + j] + carry;
        product.limbs_[i + j] = static_cast<std::uint64_t>(total);
        carry = static_cast<std::uint64_t>(total >> 64U);
      }
      product.limbs_[i + kOther] = carry;
    }
    if (sign() == Sign::negative) product.subtract_above(kLimbs, b);
    if (b.sign() == Sign::negative) product.subtract_above(kOther, *this);
    return product;
  }

  // Subtracts b 2^(64 from), modulo 2^(64 N).
  template <int M>
  constexpr void subtract_above(std::size_t from, const WideInteger<M>& b) {
    unsigned borrow = 0;
    for (std::size_t i = from; i < kLimbs; ++i) {
      const Word total = Word{limbs_[i]} - b.limbs_[i - from] - borrow;
      limbs_[i] = static_cast<std::uint64_t>(total);
      borrow = static_cast<unsigned>(total >> 64U) & 1U;
    }
  }

  std::array<std::uint64_t, kLimbs> limbs_{};
};

}  // namespace orthoball
