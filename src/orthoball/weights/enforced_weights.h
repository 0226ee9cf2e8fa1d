// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/weights/simplex_presence.h"

namespace orthoball {

/// Points with weights that hold given simplices, or why there are none.
struct EnforcedWeights {
  WeightedPoints points;                ///< rows as given, new weights where they had to change
  std::vector<SiteId> changed{};        ///< the rows with another weight, ascending
  std::vector<SiteId> hidden{};         ///< the rows that are hidden now and were not, ascending
  double total_change = 0.0;            ///< sum of |changes|, length^2 in input units
  std::vector<std::size_t> conflict{};  ///< numbers of simplices that no weights hold together,
                                        ///< though all but any one of them can be held; ascending,
                                        ///< empty where there are weights
};

/// Weights with which every given simplex is in the alpha complex at `alpha2`, be it as a face of a
/// larger one, changed as little as possible: the total change, the sum of |new - old| over all
/// sites, is the least, to about 1e-4 of it and 1e-5 of the squared diameters of the simplices.
/// Where all simplices are there already nothing changes, and few weights change otherwise.
///
/// That the simplices are there is verified exactly, on the new weights as they are. Numbers that
/// do not change are exactly what they were; new weights are in decimal fixed point as long as
/// coordinates are, with more decimals (see reweighted()), else doubles. Rows that are equal stay
/// so. A site whose weight falls may become hidden: one that lies inside a given simplex must.
///
/// The same for any order of rows and simplices, but for the numbering. Time is that of some exact
/// filtrations, and of linear programs with as many unknowns as simplices and sites near them; each
/// of their rounds looks at all sites for each simplex.
/// @param alpha2  length^2 in input units; a label as Filtration::index() takes it.
/// @param added   so many rows, the last ones, have no weight of their own yet
/// (with_added_sites()):
///                any does, and none counts as changed.
/// @throws InputError unless every simplex has 2 to D + 1 rows of `points` that are affinely
///         independent: wrong_argument, with the number of the simplex as row().
/// @throws LimitError where the library has no linear solver (has_linear_solver()), or numbers are
///         beyond what it or fixed point can hold.
/// @cite akkiraju_1995_alpha
[[nodiscard]] EnforcedWeights enforced_weights(const WeightedPoints& points,
                                               std::span<const SimplexRows> simplices,
                                               double alpha2, Threads threads = {},
                                               std::size_t added = 0);

}  // namespace orthoball
