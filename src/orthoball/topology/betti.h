// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/index_counts.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/topology/facet_roles.h"

namespace orthoball {

/// [k]: components, tunnels[, voids] of a complex, over any field: subcomplexes of a triangulated
/// ball have no torsion.
template <int D>
using BettiNumbers = std::array<std::uint32_t, static_cast<std::size_t>(D)>;

/// What every simplex does when it joins the complex in filter order: a k-simplex either closes a
/// k-cycle, and betti k grows by one, or fills a (k-1)-cycle, and betti k-1 shrinks by one. Exact.
///
/// One bit a simplex; while they are made, about 120 bytes a site in space. Nearly linear time.
///  @cite delfinado_edelsbrunner_1995
template <int D>
class CycleMarks {
 public:
  explicit CycleMarks(const Filtration<D>& filtration);

  [[nodiscard]] bool closes(SimplexId simplex) const {
    const std::uint32_t row = simplex.row();
    if (row < first_edge_) return true;
    const bool is_in_forest = (forests_[row / 64] >> row % 64 & 1U) != 0;
    return row < first_triangle_ ? !is_in_forest : is_in_forest;
  }

 private:
  std::uint32_t first_edge_, first_triangle_;
  std::vector<std::uint64_t> forests_;  // bit per simplex: a joining edge or a cutting triangle
};

/// How many edges join two components at each index.
template <int D>
[[nodiscard]] IndexCounts joining_counts(const Filtration<D>& filtration, Threads threads);

/// How many voids open and close at each index, but for those that are filled at the index at which
/// they open. Two bytes for each: about 6 a site. None in the plane.
struct VoidCounts {
  IndexCounts opening, closing;
};
/// Those of a filtration. Most of what Betti numbers cost.
template <int D>
[[nodiscard]] VoidCounts void_counts(const Filtration<D>& filtration, const FacetRoles<D>& roles,
                                     Threads threads);

/// The Betti numbers of a complex with `entered` simplices, of which so many edges have joined
/// components, and with so many voids.
template <int D>
[[nodiscard]] BettiNumbers<D> betti_numbers(const ByDimension<D>& entered, std::uint32_t joined,
                                            std::uint32_t voids) {
  BettiNumbers<D> betti{};
  betti[0] = entered[0] - joined;
  if constexpr (D == 3) betti[2] = voids;
  // Vertices - edges + triangles - tetrahedra = betti 0 - betti 1 + betti 2.
  betti[1] = (entered[1] - joined) - entered[2];
  if constexpr (D == 3) betti[1] += entered[3] + voids;
  return betti;
}

/// The Betti numbers of the alpha complexes of a filtration, one after the other, and how many
/// simplices join each. Refers to nothing once made; about 70 bytes a site in space. Nearly linear
/// time.
template <int D>
class BettiScan {
 public:
  /// Begins at index 0, the empty complex.
  explicit BettiScan(const Filtration<D>& filtration, Threads threads = Threads(1));

  /// Goes on to the next index; false, and nothing happens, at the last.
  bool next();

  [[nodiscard]] std::uint32_t index() const { return index_; }
  /// Simplices that join at index().
  [[nodiscard]] const ByDimension<D>& entering() const { return entering_; }
  /// Of the complex at index().
  [[nodiscard]] BettiNumbers<D> betti() const {
    return betti_numbers<D>(entered_, joined_, voids_);
  }

 private:
  IndexCounts joining_;
  VoidCounts void_counts_;
  std::array<IndexCounts, std::size_t{D} + 1> enter_;  // [dimension]
  std::uint32_t last_;                                 // index
  std::uint32_t index_ = 0;
  ByDimension<D> entering_{}, entered_{};
  std::uint32_t joined_ = 0, voids_ = 0;
};

/// The Betti numbers of the complex at one index, 0..s. Nearly linear; a third of the time that
/// those of all take.
/// @throws InputError for an index beyond s.
template <int D>
[[nodiscard]] BettiNumbers<D> betti_numbers(const Filtration<D>& filtration, std::uint32_t index,
                                            Threads threads = {});

extern template class CycleMarks<2>;  // defined in betti.cpp
extern template class CycleMarks<3>;
extern template IndexCounts joining_counts<2>(const Filtration<2>&, Threads);
extern template IndexCounts joining_counts<3>(const Filtration<3>&, Threads);
extern template VoidCounts void_counts<2>(const Filtration<2>&, const FacetRoles<2>&, Threads);
extern template VoidCounts void_counts<3>(const Filtration<3>&, const FacetRoles<3>&, Threads);
extern template class BettiScan<2>;
extern template class BettiScan<3>;

}  // namespace orthoball
