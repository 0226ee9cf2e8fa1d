// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// The radius of a probe, a length of 0 or more: as a double, and where it is such a number as the
/// decimal that was meant, so that "1.4" is seven fifths.
struct ProbeRadius {
  double nearest = 0.0;                ///< the double nearest to it
  std::optional<std::int64_t> digits;  ///< it is digits * 10^-decimals, digits at most 2^53
  int decimals = 0;                    ///< 0 to 400
};

/// The balls whose surface the centre of a probe reaches that rolls on the balls of `points`: every
/// radius r becomes r + R, and the weight its square. Unlike alpha2 this changes the power diagram.
/// Without weights every radius becomes R; a weight w stands for the radius sqrt(w).
///
/// Decimal fixed point stays so, exactly, where R is decimal, weights are radii or none, and every
/// number is an integer of at most 2^53 in units of the decimals that all need; otherwise
/// everything becomes doubles, radii the sum of two. A probe of 0 changes nothing.
/// @throws InputError for a probe below 0 or not finite; for an imaginary ball (weight below 0)
///         and a radius that becomes infinite, naming the row.
[[nodiscard]] WeightedPoints with_probe(const WeightedPoints& points, const ProbeRadius& probe);

}  // namespace orthoball
