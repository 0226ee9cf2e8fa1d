// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "oracles/exact_points.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball::oracles {

/// One simplex of the regular triangulation with the three spectrum indices of its roles.
struct BruteSimplex {
  std::vector<std::uint32_t> rows;  ///< ascending
  bool is_attached = false;
  std::uint32_t enters = 0, regular = 0, interior = 0;  ///< 1-based; spectrum size + 1 for never

  [[nodiscard]] int dimension() const { return static_cast<int>(rows.size()) - 1; }
  friend bool operator==(const BruteSimplex&, const BruteSimplex&) = default;
};

/// The regular triangulation and the filtration of a few weighted points, straight from their
/// definitions and in exact rational arithmetic: the first oracle of every other test.
///
/// Nothing is shared with the library but WeightedPoints. Cells are found among all subsets of
/// sites, values among all subsets of sites, hull simplices among all planes, Betti numbers by
/// ranks of boundary matrices.
///
/// Needs at most 64 distinct sites; about n^5 operations: milliseconds for 12 sites, a second for
/// 40.
struct BruteForce {
  int affine_dimension = -1;
  std::vector<std::uint32_t> hidden;                                ///< rows, ascending
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates;  ///< row, representative
  std::vector<BruteSimplex> simplices;  ///< by (value, dimension, rows): the filter order
  std::vector<Rational> spectrum;       ///< [index - 1], input units squared, exact
  /// [index][dimension], index 0 included
  std::vector<std::array<std::uint32_t, 3>> betti;

  [[nodiscard]] std::uint32_t never() const {
    return static_cast<std::uint32_t>(spectrum.size()) + 1;
  }
};

[[nodiscard]] BruteForce brute_force(const WeightedPoints& points);

/// The distinct sites whose unperturbed power cell is empty, as ascending rows: those that lie
/// strictly above the lower hull of the lifted sites, by Caratheodory's theorem. A definition of
/// "hidden" that knows nothing of perturbations.
[[nodiscard]] std::vector<std::uint32_t> sites_without_power_cell(const WeightedPoints& points);

/// The maximal simplices of the triangulation, found with weights lowered by actual numbers small
/// enough to act like the infinitesimals of the definition. Slow; a check of `brute_force`.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> cells_by_lowered_weights(
    const WeightedPoints& points);

}  // namespace orthoball::oracles
