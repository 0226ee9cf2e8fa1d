// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "orthoball/weights/witness_program.h"

namespace orthoball {

/// Simplices that exclude each other.
struct Conflict {
  std::vector<std::size_t> simplices{};  ///< their numbers, ascending; empty: none do
  bool is_proved = false;  ///< in exact numbers; else they leave each other so little room that
                           ///< doubles show none
};

/// Simplices that are in no regular triangulation together, whatever the weights, though all but
/// any one of them are; none where there is one that has all. Two edges that cross are such; larger
/// sets are those in which each must stand before the next in a ring.
///
/// Which of several such sets is found does not depend on the order of rows or simplices. That all
/// but any one can be held is decided by linear programs in doubles. Sites that are no corners do
/// not matter: they can be hidden.
/// @throws LimitError where the solver gives up.
/// @cite chinneck_dravnieks_1991
template <int D>
[[nodiscard]] Conflict conflicting_simplices(const DistinctSites<D>& sites,
                                             std::span<const SiteTuple> simplices);

extern template Conflict conflicting_simplices<2>(const DistinctSites<2>&,
                                                  std::span<const SiteTuple>);
extern template Conflict conflicting_simplices<3>(const DistinctSites<3>&,
                                                  std::span<const SiteTuple>);

}  // namespace orthoball
