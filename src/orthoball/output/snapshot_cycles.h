// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/parallel.h"
#include "orthoball/topology/persistence.h"

namespace orthoball {

/// Of filtrations with more simplices a snapshot has no cycles: they would take as long as the
/// rest.
inline constexpr std::size_t kMostSimplicesForCycles = 5'000'000;

/// Cycles of tunnels as a snapshot has them, one after the other.
struct SnapshotCycles {
  std::vector<std::uint32_t> pairs;  ///< [cycle]: whose, by number among the pairs; ascending
  std::vector<std::uint32_t> ends;   ///< [cycle]: where its edges end
  std::vector<std::uint32_t> edges;  ///< by number among edges, ascending in each cycle
};

/// Of those tunnels in space that live longest in alpha2, at most a hundred and some ten thousand
/// edges, each as it is half way through its life. None in the plane, where cells tell of holes.
/// @param tunnels  by the numbers of their births; those that last.
template <int D>
[[nodiscard]] SnapshotCycles snapshot_cycles(const Filtration<D>& filtration,
                                             const std::vector<PersistencePair>& tunnels,
                                             Threads threads = {});

extern template SnapshotCycles snapshot_cycles<2>(const Filtration<2>&,
                                                  const std::vector<PersistencePair>&,
                                                  Threads);  // in snapshot_cycles.cpp
extern template SnapshotCycles snapshot_cycles<3>(const Filtration<3>&,
                                                  const std::vector<PersistencePair>&, Threads);

}  // namespace orthoball
