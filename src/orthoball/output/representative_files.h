// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/queries/representatives.h"

namespace orthoball {

// What makes classes of persistent homology, numbered from 1 in the order given.

/// An array of objects: `class`, `dimension`, `birth` and `death` (alpha2, null for never),
/// `alpha2` and `index` at which the class is shown, `rows` as Representative has them; of tunnels
/// and of holes in the plane `rings` and `length`; of voids `triangles` and `area`; of voids and
/// holes `cells` and `volume` (in the plane an area); `birth_simplex` and `death_simplex`, which
/// fills it. Simplices are arrays of rows.
/// @throws OutputError
template <int D>
void write_representatives_json(ByteSink& sink, const Filtration<D>& filtration,
                                std::span<const Representative> representatives);

/// A binary PLY: vertices with `row` and `class`, those of each class for itself; faces with
/// `class` and `filling`, 0 for what encloses a void and 1 for the triangle that fills a tunnel or,
/// in the plane, a hole; edges of cycles with `class`. Of a component there are vertices only.
/// @param points  what the filtration was made of.
/// @throws OutputError
template <int D>
void write_representatives_ply(ByteSink& sink, const Filtration<D>& filtration,
                               const WeightedPoints& points,
                               std::span<const Representative> representatives);

extern template void write_representatives_json<2>(
    ByteSink&, const Filtration<2>&,
    std::span<const Representative>);  // in representative_files.cpp
extern template void write_representatives_json<3>(ByteSink&, const Filtration<3>&,
                                                   std::span<const Representative>);
extern template void write_representatives_ply<2>(ByteSink&, const Filtration<2>&,
                                                  const WeightedPoints&,
                                                  std::span<const Representative>);
extern template void write_representatives_ply<3>(ByteSink&, const Filtration<3>&,
                                                  const WeightedPoints&,
                                                  std::span<const Representative>);

}  // namespace orthoball
