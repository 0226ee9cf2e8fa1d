// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "orthoball/input/site_labels.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/queries/pockets.h"
#include "orthoball/queries/voids.h"

namespace orthoball {

// Voids and pockets as tables, one line each in the order given, numbered from 1. The balls around
// are three lists of one order: `atoms`, input rows from 0, `atom_names`, such as "A/ALA 12/CB",
// empty where labels name none, and `atom_areas`, what the void or pocket has of their surfaces.
// Numbers beyond the double range are left out.

/// `void,volume,area,atoms,atom_names,atom_areas,born,dies,x,y,z,radius`. `born` and `dies` are
/// alpha2; the rest is the largest ball inside, left out where none was found. In the plane there
/// is no `z`. Voids of a shape have no `atom_areas`.
template <int D>
void write_voids(ByteSink& sink, TableFormat format, std::span<const Void<D>> voids, VoidsOf of,
                 const SiteLabels& labels);

/// What a pocket is by the number of its mouths: "void" (none), "pocket" (one) or "channel".
[[nodiscard]] std::string_view pocket_kind(const Pocket& pocket);

/// `pocket,kind,volume,area,depth,atoms,atom_names,atom_areas,mouths,mouth_areas`. `mouths` is
/// their number, `mouth_areas` a list; a void has no depth.
void write_pockets(ByteSink& sink, TableFormat format, std::span<const Pocket> pockets,
                   const SiteLabels& labels);

extern template void write_voids<2>(ByteSink&, TableFormat, std::span<const Void<2>>, VoidsOf,
                                    const SiteLabels&);  // in region_tables.cpp
extern template void write_voids<3>(ByteSink&, TableFormat, std::span<const Void<3>>, VoidsOf,
                                    const SiteLabels&);

}  // namespace orthoball
