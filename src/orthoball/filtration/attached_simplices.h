// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "orthoball/filtration/simplex_table.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// [simplex]: whether some other site has less power than the squared orthoradius at the simplex's
/// orthocentre. Exact; linear.
///
/// @param edges_of_cells  what the table gave with it; read where the cells are tetrahedra.
template <int D>
[[nodiscard]] std::vector<bool> attached_simplices(
    const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
    const typename SimplexTable<D>::EdgesOfCells& edges_of_cells);

extern template std::vector<bool> attached_simplices<2>(const RegularTriangulation<2>&,
                                                        const SimplexTable<2>&,
                                                        const SimplexTable<2>::EdgesOfCells&);
extern template std::vector<bool> attached_simplices<3>(const RegularTriangulation<3>&,
                                                        const SimplexTable<3>&,
                                                        const SimplexTable<3>::EdgesOfCells&);

}  // namespace orthoball
