// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "orthoball/filtration/simplex_table.h"
#include "orthoball/parallel.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// Whether some other site has less power than the squared orthoradius at the simplex's
/// orthocentre: a bit for every simplex, 64 to a word, the lowest first. Exact; linear.
///
/// @param edges_of_cells  what the table gave with it; read where the cells are tetrahedra.
template <int D>
[[nodiscard]] std::vector<std::uint64_t> attached_simplices(
    const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
    const typename SimplexTable<D>::EdgesOfCells& edges_of_cells, Threads threads);

extern template std::vector<std::uint64_t> attached_simplices<2>(
    const RegularTriangulation<2>&, const SimplexTable<2>&, const SimplexTable<2>::EdgesOfCells&,
    Threads);
extern template std::vector<std::uint64_t> attached_simplices<3>(
    const RegularTriangulation<3>&, const SimplexTable<3>&, const SimplexTable<3>::EdgesOfCells&,
    Threads);

}  // namespace orthoball
