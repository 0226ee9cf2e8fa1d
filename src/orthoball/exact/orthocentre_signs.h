// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "orthoball/exact/floating_point.h"
#include "orthoball/exact/magnitudes.h"
#include "orthoball/exact/orthocentre_formulas.h"
#include "orthoball/exact/sites.h"
#include "orthoball/exact/unrolled.h"

namespace orthoball {

/// On which side of each facet of a simplex its orthocentre lies, as far as doubles can tell.
struct OrthocentreSigns {
  std::int64_t beyond;  ///< bit i: strictly beyond the facet opposite corner i
  double certainty;     ///< positive where that is known of every corner
};

/// What the double stage has to know of all sites.
struct SignTolerance {
  double weights;      ///< Magnitudes' weight_magnitude
  double exact_below;  ///< expressions whose magnitudes are less are not rounded
};

/// Of some sites.
template <int D>
[[nodiscard]] SignTolerance sign_tolerance(const Sites<D>& sites) {
  return {2 * sites.weight_error() / kRounding, sites.is_integral() ? 0x1p+53 : 0.0};
}

// Roundings on the longest path to one of orthocentre_coordinates, and a few for the bound itself.
inline constexpr double kCoordinateError = 40 * kRounding;

/// Bound on the magnitude of each of orthocentre_coordinates (docs/derivations/orthoradius.md).
template <int D, std::size_t Corners>
[[nodiscard, gnu::always_inline]] inline double coordinate_magnitude(
    const Magnitudes<D, Corners>& size) {
  if constexpr (Corners == 2) return size.powers[0] + 6 * size.edges[0] * size.edges[0];
  if constexpr (Corners == 3) {
    const double edges = size.edges[0] * size.edges[1];
    return 3 * size.x() * (size.edges[0] + size.edges[1]) + 36 * edges * edges;
  }
  if constexpr (Corners == 4) {
    const double cross = size.edges[1] * size.edges[2] + size.edges[2] * size.edges[0] +
                         size.edges[0] * size.edges[1];
    return 6 * size.x() * cross + 2 * size.y() * size.y();
  }
}

/// The signs for 2 to D + 1 corners in doubles with a forward error bound. Without branches, so
/// that loops over many simplices become vector instructions.
///
/// @param x        [corner][axis], as Sites scales them
/// @param weights  [corner]
template <int D, std::size_t Corners>
[[nodiscard, gnu::always_inline]] inline OrthocentreSigns orthocentre_signs(
    const std::array<std::array<double, std::size_t{D}>, Corners>& x,
    const std::array<double, Corners>& weights, SignTolerance tolerance) {
  CornerDifferences<double, double, D, Corners> differences;
  std::array<double, Corners - 1> weight_differences;
  unrolled<Corners - 1>([&](std::size_t i) __attribute__((always_inline)) {
    auto& edge = differences.edges[i];
    unrolled<std::size_t{D}>([&](std::size_t axis) __attribute__((always_inline)) {
      edge[axis] = x[i + 1][axis] - x[0][axis];
    });
    weight_differences[i] = weights[0] - weights[i + 1];
    differences.powers[i] = dot_product(edge, edge) + weight_differences[i];
  });
  const Magnitudes<D, Corners> size(differences.edges, weight_differences, tolerance.weights);
  const auto coordinates = orthocentre_coordinates(differences);
  const double magnitude = coordinate_magnitude(size);
  const double error = magnitude < tolerance.exact_below ? -1.0 : kCoordinateError * magnitude;
  OrthocentreSigns signs{0, size.margin};
  unrolled<Corners>([&](std::size_t i) __attribute__((always_inline)) {
    signs.beyond |= coordinates[i] < 0 ? std::int64_t{1} << i : 0;
    signs.certainty = std::min(signs.certainty, std::abs(coordinates[i]) - error);
  });
  return signs;
}

}  // namespace orthoball
