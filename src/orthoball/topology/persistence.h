// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// A class of cycles of dimension k: a component, a tunnel, a void. The k-simplex that closes its
/// first cycle, and the (k+1)-simplex that fills it; none where nothing ever does.
///
/// It lives from enters(birth), at which it is there, to enters(death), at which it is not.
struct PersistencePair {
  SimplexId birth, death;
};

/// Which pairs are wanted.
enum class WantedPairs {
  lasting,  ///< those that live at one index at least
  all,      ///< also those that are born and die at the same
};

/// [k]: the pairs of dimension k, 0 <= k < D, by (enters, number) of their birth.
template <int D>
using PersistencePairs = std::array<std::vector<PersistencePair>, std::size_t{D}>;

/// The persistent homology of a filtration over Z/2: how its simplices pair in filter order, by
/// (enters, dimension, number). Exact, and the same for any order of the input's rows up to the
/// pairs of equal births.
///
/// Components by union-find along the edges, voids (in the plane: holes) backwards along the cells,
/// and what remains, tunnels, by reduction of the triangles that fill any. Nearly linear time but
/// for the last, which is so in practice; at most 20 bytes a simplex, 400 a site in space.
/// @cite edelsbrunner_letscher_zomorodian_2002  @cite bauer_2021
template <int D>
[[nodiscard]] PersistencePairs<D> persistence_pairs(const Filtration<D>& filtration,
                                                    WantedPairs wanted = WantedPairs::lasting,
                                                    Threads threads = {});

/// Those of them that live for `least` or longer, by the labels of their ends; those that never die
/// do.
/// @param least  length^2, 0 or more.
template <int D>
[[nodiscard]] PersistencePairs<D> pairs_of_length(const Filtration<D>& filtration,
                                                  PersistencePairs<D> pairs, double least);

extern template PersistencePairs<2> persistence_pairs<2>(const Filtration<2>&, WantedPairs,
                                                         Threads);  // in persistence.cpp
extern template PersistencePairs<3> persistence_pairs<3>(const Filtration<3>&, WantedPairs,
                                                         Threads);
extern template PersistencePairs<2> pairs_of_length<2>(const Filtration<2>&, PersistencePairs<2>,
                                                       double);
extern template PersistencePairs<3> pairs_of_length<3>(const Filtration<3>&, PersistencePairs<3>,
                                                       double);

}  // namespace orthoball
