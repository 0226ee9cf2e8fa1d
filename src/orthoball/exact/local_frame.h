// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "orthoball/exact/sites.h"
#include "orthoball/exact/wide_integer.h"

namespace orthoball {

/// The unit in which a few sites are integers, and how large these are.
///
/// With u = 2^unit: every coordinate is a multiple of u, every weight one of u^2. Differences of
/// coordinates are below 2^bits u in magnitude, weights and their differences below 2^(2 bits) u^2.
/// So a determinant's bits follow from the sites at hand, not from the box of all of them.
struct LocalFrame {
  int unit = 0;
  int bits = 1;
};

namespace local_frame_detail {

// number = digits * 2^exponent.
struct BinaryNumber {
  std::int64_t digits;
  int exponent;
};

inline BinaryNumber binary_number(double number) {
  const auto word = std::bit_cast<std::uint64_t>(number);
  const auto biased = static_cast<int>(word >> 52U) & 0x7FF;
  const auto fraction = static_cast<std::int64_t>(word & 0xFFFFFFFFFFFFFU);
  const std::int64_t size = biased == 0 ? fraction : fraction | (std::int64_t{1} << 52);
  return {number < 0 ? -size : size, std::max(biased, 1) - 1075};
}

// number / 2^unit modulo 2^Int::kBits, for a multiple of 2^unit: right whenever what is made of it
// fits, also where it does not fit itself.
template <class Int>
Int integer(double number, int unit) {
  if (number == 0.0) return Int();
  const BinaryNumber binary = binary_number(number);
  const int shift = binary.exponent - unit;
  if (shift < 0) return Int(binary.digits >> -shift);  // the bits shifted out are 0
  if (shift >= Int::kBits) return Int();
  return Int(binary.digits) << shift;
}

}  // namespace local_frame_detail

/// Exponent of the lowest set bit of a number other than 0. Exact.
[[nodiscard]] inline int lowest_bit(double number) {
  const auto binary = local_frame_detail::binary_number(number);
  return binary.exponent + std::countr_zero(static_cast<std::uint64_t>(binary.digits));
}

/// The frame of some sites, at least one. Exact; costs a few operations a number.
template <int D>
[[nodiscard]] LocalFrame local_frame(std::span<const ExactSite<D>> sites) {
  constexpr int kNothing = 1 << 20;
  int lowest = kNothing;
  int top = -kNothing;  // lengths' differences are below 2^top, weights below 2^(2 top)
  for (const ExactSite<D>& site : sites) {
    for (int axis = 0; axis < D; ++axis) {
      const double x = site.x[axis];
      if (x != 0.0) lowest = std::min(lowest, lowest_bit(x));
      const double from = sites[0].x[axis];
      if (x == from) continue;
      // The rounded difference is below twice a power of two above it; halved, it cannot overflow.
      // Halves that round to one number are of numbers 2^-1073 apart at most.
      const double distance = std::abs(0.5 * x - 0.5 * from);
      top = std::max(top, distance == 0.0 ? -1072 : std::ilogb(distance) + 3);
    }
    if (site.weight_high != 0.0) {
      const int low = lowest_bit(site.weight_low != 0.0 ? site.weight_low : site.weight_high) +
                      site.weight_exponent;
      lowest = std::min(lowest, low >> 1);  // rounded down
      const int high = std::ilogb(site.weight_high) + 3 + site.weight_exponent;
      top = std::max(top, (high + 1) >> 1);
    }
  }
  if (top == -kNothing) return {lowest == kNothing ? 0 : lowest, 1};
  return {lowest, std::max(top - lowest, 1)};
}

/// A site in the integers of a frame: coordinates less those of an origin, and the weight.
template <class Int, int D>
struct IntegerSite {
  Int x[std::size_t{D}];
  Int weight;
};

/// `site` relative to `origin`, both of the sites that gave `frame`. Exact if Int has at least
/// 2 bits + 1 bits.
template <class Int, int D>
[[nodiscard]] IntegerSite<Int, D> integer_site(const ExactSite<D>& site, const ExactSite<D>& origin,
                                               const LocalFrame& frame) {
  using local_frame_detail::integer;
  IntegerSite<Int, D> result;
  for (int axis = 0; axis < D; ++axis) {
    result.x[axis] =
        integer<Int>(site.x[axis], frame.unit) - integer<Int>(origin.x[axis], frame.unit);
  }
  const int weight_unit = 2 * frame.unit - site.weight_exponent;
  result.weight =
      integer<Int>(site.weight_high, weight_unit) + integer<Int>(site.weight_low, weight_unit);
  return result;
}

/// Calls `evaluate.template operator()<WideInteger<N>>()` with the smallest offered N that has more
/// than `bits` bits. 40,000 bits hold every expression of the library on any finite doubles.
template <class Evaluate>
auto with_width(int bits, const Evaluate& evaluate) {
  if (bits < 127) return evaluate.template operator()<WideInteger<2>>();
  if (bits < 255) return evaluate.template operator()<WideInteger<4>>();
  if (bits < 511) return evaluate.template operator()<WideInteger<8>>();
  if (bits < 1023) return evaluate.template operator()<WideInteger<16>>();
  if (bits < 4095) return evaluate.template operator()<WideInteger<64>>();
  return evaluate.template operator()<WideInteger<640>>();
}

/// Calls `evaluate.template operator()<N>()` with the smallest offered number of limbs that holds
/// integers of `bits` bits and a sign, with two bits to spare for sums. The largest holds the
/// differences of any finite doubles.
template <class Evaluate>
auto with_limbs(int bits, const Evaluate& evaluate) {
  constexpr int kSpare = 3;
  if (bits <= 64 - kSpare) return evaluate.template operator()<1>();
  if (bits <= 128 - kSpare) return evaluate.template operator()<2>();
  if (bits <= 256 - kSpare) return evaluate.template operator()<4>();
  if (bits <= 512 - kSpare) return evaluate.template operator()<8>();
  return evaluate.template operator()<36>();
}

}  // namespace orthoball
