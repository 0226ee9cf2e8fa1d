// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The edges of a tetrahedral triangulation, numbered in the order of the smallest cells around
/// them and, within a cell, of their slots (kEdgeCorners).
struct EdgeNumbers {
  RawVector<std::array<std::uint32_t, 6>> of_cells;  ///< [cell][slot]: number of the edge
  RawVector<std::uint32_t> owners;  ///< [edge]: 6 * cell + slot for the smallest cell around it
};

/// Almost linear in the cells, fewer than 2^32 / 6; about 8 bytes a cell of transient memory.
[[nodiscard]] EdgeNumbers edge_numbers(std::span<const CellRecord<3>> cells, Threads threads);

/// The same in so many ranges of cells, at least one, on which the result does not depend.
[[nodiscard]] EdgeNumbers edge_numbers_in_ranges(std::span<const CellRecord<3>> cells,
                                                 std::size_t ranges, Threads threads);

}  // namespace orthoball
