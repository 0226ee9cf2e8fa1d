// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "orthoball/exact/unrolled.h"

namespace orthoball {

/// Edges whose largest coordinate is within, with weights as Sites bounds them, let no product in
/// the double stages of orthoradius.cpp over- or underflow harmfully.
inline constexpr double kShortestEdge = 0x1p-80;
inline constexpr double kLongestEdge = 0x1p+80;

/// Largest magnitudes of what a simplex is made of, from which its error bounds follow.
template <int D, std::size_t Corners>
struct Magnitudes {
  std::array<double, Corners - 1> edges;   ///< largest coordinate
  std::array<double, Corners - 1> powers;  ///< |edge|^2 + |w_0 - w_i|, or more
  double margin;                           ///< positive where the edges are in range

  /// @param weight_magnitude  what the error of a weights' difference is a few roundings of, in
  ///                          addition to the difference itself
  [[gnu::always_inline]] Magnitudes(
      const std::array<std::array<double, std::size_t{D}>, Corners - 1>& differences,
      const std::array<double, Corners - 1>& weight_differences, double weight_magnitude) {
    double shortest = kLongestEdge;
    double longest = kShortestEdge;
    unrolled<Corners - 1>([&](std::size_t i) __attribute__((always_inline)) {
      double largest = std::max(std::abs(differences[i][0]), std::abs(differences[i][1]));
      if constexpr (D == 3) largest = std::max(largest, std::abs(differences[i][2]));
      edges[i] = largest;
      powers[i] = D * largest * largest + std::abs(weight_differences[i]) + weight_magnitude;
      shortest = std::min(shortest, largest);
      longest = std::max(longest, largest);
    });
    margin = std::min(shortest - kShortestEdge, kLongestEdge - longest);
  }

  /// Of a component of the vector x of orthocentre_formulas.h.
  [[nodiscard, gnu::always_inline]] double x() const {
    if constexpr (Corners == 2) return powers[0];
    if constexpr (Corners == 3) return powers[0] * edges[1] + powers[1] * edges[0];
    if constexpr (Corners == 4) {
      return 2 * (powers[0] * edges[1] * edges[2] + powers[1] * edges[2] * edges[0] +
                  powers[2] * edges[0] * edges[1]);
    }
  }
  /// Of a component of the vector y.
  [[nodiscard, gnu::always_inline]] double y() const {
    if constexpr (Corners == 2) return edges[0];
    if constexpr (Corners == 3) return 2 * edges[0] * edges[1];
    if constexpr (Corners == 4) return 6 * edges[0] * edges[1] * edges[2];
  }
};

}  // namespace orthoball
