// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "orthoball/filtration/simplex_table.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The indices from which a simplex is regular, with its first proper coface, and interior, with
/// the last cell around it.
struct RoleIndices {
  std::uint32_t regular;
  std::uint32_t interior;
};

/// The values at which the simplices of a triangulation change their role, as exact ranks.
///
/// With s = spectrum.size(), indices are 1..s, and s + 1 stands for never. Arrays are by SimplexId.
struct CriticalAlpha2 {
  std::vector<double> spectrum;       ///< [index - 1]: correctly rounded labels, length^2 of input
  std::vector<bool> is_attached;      ///< [simplex]
  std::vector<std::uint32_t> enters;  ///< [simplex]
  std::vector<RoleIndices> roles;     ///< [simplex]; not of all, see below
};

/// Attachment, order and the three indices of every simplex. Exact; the labels only are rounded.
///
/// `roles` end before the facets of the cells where these are of full dimension:
/// the two cells beside a facet tell them. They end before the cells otherwise.
///
/// @param edges_of_cells  what the table gave with it; read where the cells are tetrahedra.
/// Costs what ValueRanks does, the rest is linear.
template <int D>
[[nodiscard]] CriticalAlpha2 critical_alpha2(
    const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
    const typename SimplexTable<D>::EdgesOfCells& edges_of_cells);

extern template CriticalAlpha2 critical_alpha2<2>(const RegularTriangulation<2>&,
                                                  const SimplexTable<2>&,
                                                  const SimplexTable<2>::EdgesOfCells&);
extern template CriticalAlpha2 critical_alpha2<3>(const RegularTriangulation<3>&,
                                                  const SimplexTable<3>&,
                                                  const SimplexTable<3>::EdgesOfCells&);

}  // namespace orthoball
