// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/points/weighted_points.h"

namespace orthoball::generators {

/// Kinds of weighted points that tests and benchmarks are run on. All but the first five are
/// degenerate or extreme in some way.
enum class PointFamily {
  uniform,        ///< in the unit box, no weights
  uniform_balls,  ///< in the unit box, radii about the distance of neighbours
  gaussian,       ///< normal coordinates, weights of both signs
  protein_like,   ///< a compact chain of atoms, three decimals, radii of elements
  scan_like,      ///< near a curved surface, no weights
  grid,           ///< the first points of a full integer grid, row by row, no weights
  lattice,        ///< random small integers, small integer weights or radii or none
  cospherical,    ///< integers on a few common spheres, one weight for each sphere
  coplanar,       ///< an integer lattice in a tilted plane (in the plane: two lines)
  collinear,      ///< on one line of integer direction, small integer weights or none
  duplicated,     ///< few sites, each many times
  nested_balls,   ///< balls inside balls that touch them from inside or nearly
  same_centres,   ///< few centres, each with many radii
  hidden_heavy,   ///< large balls that hide most of many small ones
  near_sphere,    ///< on the unit sphere as nearly as doubles can be, no weights
  one_ulp,        ///< coordinates and weights that differ in their last bits
  huge,           ///< near the largest doubles
  tiny,           ///< the smallest doubles, subnormal ones among them
  mixed_scales,   ///< magnitudes from 1e-150 to 1e150 side by side
};

[[nodiscard]] std::span<const PointFamily> point_families();
[[nodiscard]] const char* name(PointFamily family);
/// Whether the numbers need far more bits than a double has: huge, tiny and mixed scales.
[[nodiscard]] bool is_extreme(PointFamily family);

/// `count` sites of a family in dimension 2 or 3. The same arguments give the same sites on every
/// machine. The seed also chooses among the variants that a family has.
[[nodiscard]] WeightedPoints points_of(PointFamily family, int dimension, std::size_t count,
                                       std::uint64_t seed);

/// Row i of the result is row `rows[i]` of `points`.
[[nodiscard]] WeightedPoints with_rows(const WeightedPoints& points,
                                       std::span<const std::uint32_t> rows);

/// Lengths times 2^exponent; every number stays exact or this throws std::invalid_argument. Not for
/// decimals.
[[nodiscard]] WeightedPoints scaled_by_power_of_two(const WeightedPoints& points, int exponent);

/// 0..count-1 in random order.
[[nodiscard]] std::vector<std::uint32_t> random_permutation(std::size_t count, std::uint64_t seed);

}  // namespace orthoball::generators
