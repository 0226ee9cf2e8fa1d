// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "orthoball/weights/witness_program.h"

namespace orthoball {

/// Numbers of simplices that are in no regular triangulation together, whatever the weights, though
/// all but any one of them are; ascending, empty where there is one that has all. Two edges that
/// cross are such; larger sets are those in which each must stand before the next in a ring.
///
/// Which of several such sets is found does not depend on the order of rows or simplices. Decided
/// by linear programs in doubles. Sites that are no corners do not matter: they can be hidden.
/// @cite chinneck_dravnieks_1991
template <int D>
[[nodiscard]] std::vector<std::size_t> conflicting_simplices(const DistinctSites<D>& sites,
                                                             std::span<const SiteTuple> simplices);

extern template std::vector<std::size_t> conflicting_simplices<2>(const DistinctSites<2>&,
                                                                  std::span<const SiteTuple>);
extern template std::vector<std::size_t> conflicting_simplices<3>(const DistinctSites<3>&,
                                                                  std::span<const SiteTuple>);

}  // namespace orthoball
