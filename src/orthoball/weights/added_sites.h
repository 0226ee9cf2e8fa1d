// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "orthoball/points/weighted_points.h"
#include "orthoball/weights/simplex_presence.h"

namespace orthoball {

/// Points with sites added on simplices that exclude each other, and the parts that these make of
/// them.
struct AddedSites {
  WeightedPoints points;                 ///< the added sites behind the given ones, of weight 0
  std::size_t added = 0;                 ///< how many
  std::vector<SimplexRows> simplices{};  ///< the parts: together the given simplices
  std::vector<std::size_t> part_of{};    ///< [part]: the number of the given simplex
};

/// Adds sites until weights can hold the simplices, each cut into parts by the sites on it: for
/// enforced_weights(), which then finds the balls that protect them. A simplex that excludes none
/// stays whole, unless it is nearer than 10^-7 of the shortest edge to a corner of another or to a
/// point where two meet: what is so near is taken to be on it.
///
/// Few: as long as some simplices exclude each other, one site is added where an edge of one meets
/// another, none where a corner of one lies on another or a site is there (they are cut there), and
/// in the middle of their longest edge if no two of them meet. So two edges that cross take one
/// site. Triangles of the plane that exclude others are filled by those of one regular
/// triangulation, which has sites only where edges meet.
///
/// Of rows at one position with several weights the heaviest stands for all. Sites are where
/// doubles and then rounding put them: to 10^-8 of the smallest simplex, in decimal fixed point as
/// 2^53 allows. The parts have these sites as corners, exactly.
/// @param simplices  as enforced_weights() takes them.
/// @throws LimitError as enforced_weights() does, and where 12 sites a simplex are not enough, or
///         what is left excludes each other nearer to a site than sites can be put: triangles in
///         one plane of space that overlap, and tetrahedra, may take any number.
/// @cite cheng_2012_delaunay
[[nodiscard]] AddedSites with_added_sites(const WeightedPoints& points,
                                          std::span<const SimplexRows> simplices);

}  // namespace orthoball
