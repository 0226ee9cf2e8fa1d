// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "orthoball/parallel.h"
#include "orthoball/triangulation/cell_store.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The finite cells of a finished triangulation, in the one order and numbering that depends on the
/// triangulation alone: vertices less the hidden ones, cells ascending by their ascending corners,
/// corners as CellRecord says. Neighbours in space become neighbours in memory. O(n) time unless
/// cells crowd at one vertex; in place, with 5 bytes a cell and, at first, 4 a vertex and thread
/// beside. The same on any number of threads.
/// @param cells        used up.
/// @param is_hidden    [site] whether a site has no cell.
/// @param is_oriented  whether cells keep their orientation by a change of the last two corners;
///                     segments have none.
template <int A>
[[nodiscard]] CellArray<A> canonical_cells(CellStore<A> cells, const std::vector<bool>& is_hidden,
                                           bool is_oriented, Threads threads);

extern template CellArray<1> canonical_cells<1>(CellStore<1>, const std::vector<bool>&, bool,
                                                Threads);
extern template CellArray<2> canonical_cells<2>(CellStore<2>, const std::vector<bool>&, bool,
                                                Threads);
extern template CellArray<3> canonical_cells<3>(CellStore<3>, const std::vector<bool>&, bool,
                                                Threads);

}  // namespace orthoball
