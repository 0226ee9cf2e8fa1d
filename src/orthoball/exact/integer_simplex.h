// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/exact/local_frame.h"
#include "orthoball/exact/orthocentre_formulas.h"
#include "orthoball/exact/sites.h"
#include "orthoball/exact/wide_integer.h"

namespace orthoball {

/// Bits of the exact expressions for a simplex in a frame of `bits` bits (local_frame.h), by its
/// number of corners 1..4; derived in docs/derivations/orthoradius.md. Every value is below 2 to
/// that many bits in magnitude.
struct OrthoradiusBits {
  std::array<int, 2> numerator;    ///< {per frame bit, constant}
  std::array<int, 2> denominator;  ///< likewise
  std::array<int, 2> coordinate;   ///< of orthocentre_coordinates
};
/// [number of corners - 1]
inline constexpr std::array<OrthoradiusBits, 4> kOrthoradiusBits{{
    {{2, 0}, {0, 1}, {0, 0}},
    {{4, 6}, {2, 4}, {2, 4}},
    {{6, 9}, {4, 6}, {4, 8}},
    {{8, 13}, {6, 9}, {6, 12}},
}};
/// What a rule of OrthoradiusBits gives in a frame.
[[nodiscard]] constexpr int bits_of(const std::array<int, 2>& rule, const LocalFrame& frame) {
  return rule[0] * frame.bits + rule[1];
}

/// Calls `evaluate` like with_width, with one word where that is enough.
template <class Evaluate>
auto with_least_width(int bits, const Evaluate& evaluate) {
  if (bits < 63) return evaluate.template operator()<WideInteger<1>>();
  return with_width(bits, evaluate);
}

/// A simplex in the integers of its frame, and the weight of its first corner.
template <class Int, int D, std::size_t Corners>
struct IntegerSimplex {
  CornerDifferences<Int, Int, D, Corners> differences;
  Int weight;
};

/// What the exact stages read of a simplex: its sites and the unit in which they are integers.
template <int D, std::size_t Corners>
class FramedSimplex {
 public:
  FramedSimplex(const Sites<D>& sites, const std::uint32_t* corners) {
    if (sites.is_integral()) {
      is_small_ = frame_small(sites, corners);
      if (is_small_) return;
    }
    for (std::size_t i = 0; i < Corners; ++i) exact_[i] = sites.exact(corners[i]);
    frame_ = local_frame<D>(exact_);
  }

  [[nodiscard]] const LocalFrame& frame() const { return frame_; }

  /// Exact if Int has the bits of kOrthoradiusBits for what is made of it.
  template <class Int>
  [[nodiscard]] IntegerSimplex<Int, D, Corners> integers() const {
    IntegerSimplex<Int, D, Corners> result;
    std::array<IntegerSite<Int, D>, Corners> sites;
    for (std::size_t i = 0; i < Corners; ++i) {
      if (is_small_) {
        for (std::size_t axis = 0; axis < D; ++axis) sites[i].x[axis] = Int(small_[i].x[axis]);
        sites[i].weight = Int(small_[i].weight);
      } else {
        sites[i] = integer_site<Int, D>(exact_[i], exact_[0], frame_);
      }
    }
    result.weight = sites[0].weight;
    for (std::size_t i = 1; i < Corners; ++i) {
      auto& edge = result.differences.edges[i - 1];
      for (std::size_t axis = 0; axis < D; ++axis) edge[axis] = sites[i].x[axis];
      result.differences.powers[i - 1] =
          dot_product(edge, edge) + (sites[0].weight - sites[i].weight);
    }
    return result;
  }

 private:
  // Sites that hold integers: coordinates less the first corner's, and weights, where both fit one
  // word. Saves most of what the exact stage costs where that is small, as on a lattice.
  bool frame_small(const Sites<D>& sites, const std::uint32_t* corners) {
    constexpr double kLargestWeight = 0x1p+62;
    const Site<D>& origin = sites[corners[0]];
    std::uint64_t lengths = 1;
    std::uint64_t weights = 0;
    for (std::size_t i = 0; i < Corners; ++i) {
      const Site<D>& site = sites[corners[i]];
      if (std::abs(site.weight) >= kLargestWeight) return false;
      for (std::size_t axis = 0; axis < D; ++axis) {
        small_[i].x[axis] =
            static_cast<std::int64_t>(site.x[axis]) - static_cast<std::int64_t>(origin.x[axis]);
        lengths |= static_cast<std::uint64_t>(std::abs(small_[i].x[axis]));
      }
      small_[i].weight = static_cast<std::int64_t>(site.weight);
      weights |= static_cast<std::uint64_t>(std::abs(small_[i].weight));
    }
    // Weights' differences have one bit more than weights.
    const int weight_bits = weights == 0 ? 0 : static_cast<int>(std::bit_width(weights)) + 1;
    frame_ = {0, std::max(static_cast<int>(std::bit_width(lengths)), (weight_bits + 1) / 2)};
    return true;
  }

  LocalFrame frame_;
  bool is_small_ = false;
  std::array<IntegerSite<std::int64_t, D>, Corners> small_;
  std::array<ExactSite<D>, Corners> exact_;
};

/// A squared orthoradius in the square of a frame's unit; the denominator is positive.
template <class Int>
struct OrthoradiusFraction {
  Int numerator;
  Int denominator;
};

/// Exact where `Int` has the bits that kOrthoradiusBits asks for.
template <class Int, int D, std::size_t Corners>
[[nodiscard]] OrthoradiusFraction<Int> orthoradius_fraction(
    const FramedSimplex<D, Corners>& simplex) {
  const auto integers = simplex.template integers<Int>();
  if constexpr (Corners == 1) {
    return {-integers.weight, Int(1)};
  } else {
    const auto squares = orthocentre_squares(integers.differences);
    const Int denominator = squares.y << 2;
    return {squares.x - integers.weight * denominator, denominator};
  }
}

}  // namespace orthoball
