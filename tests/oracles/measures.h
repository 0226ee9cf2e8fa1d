// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "oracles/brute_force.h"
#include "oracles/exact_points.h"

namespace orthoball::oracles {

/// A sum of lengths, areas or volumes, and what its error is measured against: the magnitudes of
/// its terms, of triangles the products of their edges.
struct Measure {
  double value = 0.0;
  double magnitude = 0.0;
};

/// The measures of the complex at one index, term by term from its simplices and their roles.
/// Lengths are in 2^exponent input units, so that nothing over- or underflows.
struct Measures {
  int exponent = 0;
  Measure volume;         ///< of the cells in the complex
  Measure area_singular;  ///< of facets by role, one side each
  Measure area_regular;
  Measure area;    ///< two sides of singular facets, one of regular ones
  Measure length;  ///< D = 3: edge length times complementary angle, by the rule for open edges:
                   ///< 2 pi l for an edge, - pi l for each triangle, + l (pi - angle) for each cell
};

[[nodiscard]] Measures measures(const ExactPoints& points, const BruteForce& filtration,
                                std::uint32_t index);

}  // namespace orthoball::oracles
