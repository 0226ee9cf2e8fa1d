// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/queries/manifold_solid.h"

namespace orthoball {

/// What a solid has and lacks, against the alpha shape at `index`:
/// `change,cells,volume,x,y,z,rows`, in the plane without `z`. First its changes in their order,
/// `added` or `removed`: how many cells, their volume, where, and the rows of their vertices. Then
/// the singular simplices of the shape as `dropped`, by dimension and number, with their rows.
template <int D>
void write_solid_changes(ByteSink& sink, TableFormat format, const Filtration<D>& filtration,
                         std::uint32_t index, const ManifoldSolid<D>& solid);

extern template void write_solid_changes<2>(ByteSink&, TableFormat, const Filtration<2>&,
                                            std::uint32_t,
                                            const ManifoldSolid<2>&);  // in solid_table.cpp
extern template void write_solid_changes<3>(ByteSink&, TableFormat, const Filtration<3>&,
                                            std::uint32_t, const ManifoldSolid<3>&);

}  // namespace orthoball
