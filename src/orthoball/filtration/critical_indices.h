// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "orthoball/filtration/simplex_table.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The indices from which a simplex is regular, with its first proper coface, and interior, with
/// the last cell around it.
struct RoleIndices {
  std::uint32_t regular;
  std::uint32_t interior;
};

/// The indices at which the simplices of a triangulation change their role, 1 to the number of
/// ranks, with one more for never.
struct CriticalIndices {
  RawVector<std::uint32_t> enters;  ///< [simplex]
  RawVector<RoleIndices> roles;     ///< [simplex]; not of all, see below
};

/// Writes the ranks of the unattached simplices, 1 to the number of ranks, by simplex.
using DealRanks = std::function<void(std::span<std::uint32_t>)>;

/// The unattached simplices have their ranks; from these follow all the others' indices.
///
/// `roles` end before the facets of the cells where these are of full dimension:
/// the two cells beside a facet tell them. They end before the cells otherwise.
///
/// @param edges_of_cells  what the table gave with it; read where the cells are tetrahedra.
/// @param is_attached     a bit for every simplex, 64 to a word.
/// @param ranks           how many there are.
/// Linear.
template <int D>
[[nodiscard]] CriticalIndices critical_indices(
    const RegularTriangulation<D>& triangulation, const SimplexTable<D>& table,
    const typename SimplexTable<D>::EdgesOfCells& edges_of_cells,
    std::span<const std::uint64_t> is_attached, std::uint32_t ranks, const DealRanks& deal,
    Threads threads);

extern template CriticalIndices critical_indices<2>(const RegularTriangulation<2>&,
                                                    const SimplexTable<2>&,
                                                    const SimplexTable<2>::EdgesOfCells&,
                                                    std::span<const std::uint64_t>, std::uint32_t,
                                                    const DealRanks&, Threads);
extern template CriticalIndices critical_indices<3>(const RegularTriangulation<3>&,
                                                    const SimplexTable<3>&,
                                                    const SimplexTable<3>::EdgesOfCells&,
                                                    std::span<const std::uint64_t>, std::uint32_t,
                                                    const DealRanks&, Threads);

}  // namespace orthoball
