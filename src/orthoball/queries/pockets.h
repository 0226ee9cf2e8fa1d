// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/queries/free_space.h"

namespace orthoball {

/// Where a pocket opens to the outside: facets joined through faces outside the complex.
struct Mouth {
  double area = 0.0;              ///< outside the balls; length^(D-1)
  std::vector<SiteId> rim;        ///< the balls at its corners, ascending rows
  std::vector<SimplexId> facets;  ///< ascending
};

/// A part of the space outside a union of balls that widens before it comes to the outside: by the
/// number of its mouths a void (none), a pocket (one) or a channel (two or more). In input units.
struct Pocket {
  double volume = 0.0;             ///< length^D, as FreeSpace says
  double area = 0.0;               ///< length^(D-1)
  std::vector<LiningBall> lining;  ///< by row
  std::vector<SimplexId> cells;    ///< of the triangulation, outside the complex; ascending
  std::vector<Mouth> mouths;       ///< the largest first
  /// The largest squared orthoradius inside less the largest alpha2 at which a facet of a mouth
  /// enters, length^2: how much balls must grow to fill the pocket after its mouths have closed.
  std::optional<double> depth;  ///< none without mouths
};

/// Pockets by the flow of cells (Edelsbrunner, Facello, Liang 1998). A cell outside the complex
/// flows through a facet, to the cell beyond or to infinity, if its orthocentre lies strictly
/// beyond that facet. Cells with a path to infinity are outside; the others, joined through facets
/// outside the complex, are the pockets.
///
/// Which cells and mouths are whose is exact. Volumes and areas of pockets with mouths include
/// parts of balls that reach through a mouth: usually below 3 %, but much of a pocket whose depth
/// is near 0; then volume and area, and areas of single balls in any pocket, may be below 0.
/// Largest volume first; equal ones by the lowest row. Time grows little faster than the number of
/// simplices.
/// @param alpha2  length^2, as for union_of_balls.
/// @throws InputError for an index beyond the spectrum's size.
/// @cite edelsbrunner_facello_liang_1998
template <int D>
[[nodiscard]] std::vector<Pocket> pockets(const Filtration<D>& filtration, std::uint32_t index,
                                          double alpha2, Threads threads = {});

extern template std::vector<Pocket> pockets<2>(const Filtration<2>&, std::uint32_t, double,
                                               Threads);  // in pockets.cpp
extern template std::vector<Pocket> pockets<3>(const Filtration<3>&, std::uint32_t, double,
                                               Threads);

}  // namespace orthoball
