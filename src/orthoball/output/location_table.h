// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/queries/locate.h"

namespace orthoball {

/// Locations as a table, one line each, numbered from 0 by the row of the point:
/// `row,inside,region,distance,x,y,z,nearest,simplex`. `inside` is 1 or 0, `region` a number from
/// 1, left out outside; `distance` and `x`, `y`, `z` that of the nearest point of the boundary and
/// where it is, `nearest` the rows of the simplex it is on, left out without boundary; `simplex`
/// the rows of the simplex of the triangulation that holds the point, left out outside the convex
/// hull. In the plane there is no `z`.
template <int D>
void write_locations(ByteSink& sink, TableFormat format, const Filtration<D>& filtration,
                     std::span<const Location<D>> locations);

extern template void write_locations<2>(ByteSink&, TableFormat, const Filtration<2>&,
                                        std::span<const Location<2>>);  // in location_table.cpp
extern template void write_locations<3>(ByteSink&, TableFormat, const Filtration<3>&,
                                        std::span<const Location<3>>);

}  // namespace orthoball
