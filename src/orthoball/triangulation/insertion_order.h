// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/raw_vector.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The distinct sites of an input along a space-filling curve, and the rows put aside.
struct CurveOrder {
  std::vector<SiteId> rows;           ///< lowest row of every distinct site, in curve order
  std::vector<Duplicate> duplicates;  ///< ascending by row
};

/// Orders the sites along a Hilbert curve through their bounding box, those in one of its 2^63
/// cubes (2^62 squares) lexicographically by coordinates and weight. The order depends on the set
/// of sites only, not on their rows. O(n) time.
/// @tparam D  2 or 3, points.dimension().   @cite skilling_2004
template <int D>
[[nodiscard]] CurveOrder curve_order(const WeightedPoints& points, Threads threads = Threads(1));

/// [i]: the i-th site.
using InsertionOrder = BlockVector<std::uint32_t>;

/// The order in which sites numbered along a curve are inserted: rounds along the curve, the last
/// of all sites but every eighth, the one before of these but every eighth of them, and so on. So
/// every site finds the triangulation of a sample of all, and the place of its predecessor nearby.
/// Samples that are spread evenly along the curve, and so in space, need fewer cells on the way
/// than the random ones of the paper; what it proves of these is not proved of ours.
/// @cite amenta_choi_rote_2003
[[nodiscard]] InsertionOrder insertion_order(std::size_t count);

}  // namespace orthoball
