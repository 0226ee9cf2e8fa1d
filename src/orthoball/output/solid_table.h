// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/queries/manifold_solid.h"

namespace orthoball {

/// What a solid has and lacks, against the shape that it is near to:
/// `change,cells,volume,x,y,z,rows`, in the plane without `z`. First its changes in their order,
/// `added` or `removed`: how many cells, their volume, where, and the rows of their vertices. Then
/// the singular simplices of the shape as `dropped`, by dimension and number, with their rows.
template <int D>
void write_solid_changes(ByteSink& sink, TableFormat format, const AlphaComplex<D>& shape,
                         const ManifoldSolid<D>& solid);

extern template void write_solid_changes<2>(ByteSink&, TableFormat, const AlphaComplex<2>&,
                                            const ManifoldSolid<2>&);  // in solid_table.cpp
extern template void write_solid_changes<3>(ByteSink&, TableFormat, const AlphaComplex<3>&,
                                            const ManifoldSolid<3>&);

}  // namespace orthoball
