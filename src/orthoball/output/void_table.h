// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "orthoball/output/byte_sink.h"
#include "orthoball/queries/voids.h"

namespace orthoball {

/// Voids as CSV: `void,volume,area,atoms,atom_areas,born,dies,x,y,z,radius`, one line a void in the
/// order given, numbered from 1. `atoms` are the input rows of the lining balls, from 0, with
/// blanks between, `atom_areas` what the void has of their surfaces, likewise; `born` and `dies`
/// alpha2; the rest is the largest ball inside, left empty where none was found. In the plane there
/// is no `z`. Numbers beyond the double range are left empty.
template <int D>
void write_voids_csv(ByteSink& sink, std::span<const Void<D>> voids);

extern template void write_voids_csv<2>(ByteSink&, std::span<const Void<2>>);  // in void_table.cpp
extern template void write_voids_csv<3>(ByteSink&, std::span<const Void<3>>);

}  // namespace orthoball
