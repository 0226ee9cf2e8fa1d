// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filter_steps.h"
#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// [k]: components, tunnels[, voids] of a complex, over any field: subcomplexes of a triangulated
/// ball have no torsion.
template <int D>
using BettiNumbers = std::array<std::uint32_t, static_cast<std::size_t>(D)>;

/// What every simplex does when it joins the complex in filter order: a k-simplex either closes a
/// k-cycle, and betti k grows by one, or fills a (k-1)-cycle, and betti k-1 shrinks by one. Exact.
///
/// One bit a simplex; nearly linear time.  @cite delfinado_edelsbrunner_1995
template <int D>
class CycleMarks {
 public:
  explicit CycleMarks(const Filtration<D>& filtration);

  /// Whether the simplex at a position of the filter, from 0, closes a cycle.
  [[nodiscard]] bool closes(std::size_t position) const {
    return (bits_[position / 64] >> position % 64 & 1U) != 0;
  }
  /// How many of the positions [begin, end) close one.
  [[nodiscard]] std::uint32_t count(std::size_t begin, std::size_t end) const;

 private:
  void mark(std::size_t position) { bits_[position / 64] |= std::uint64_t{1} << position % 64; }
  void mark_vertices_and_edges(const Filtration<D>& filtration);
  void mark_triangles(const Filtration<D>& filtration);

  std::vector<std::uint64_t> bits_;
};

/// The Betti numbers of the alpha complexes of a filtration, one after the other.
template <int D>
class BettiScan {
 public:
  /// Begins with the empty complex.
  explicit BettiScan(const Filtration<D>& filtration) : marks_(filtration) {}

  /// Adds the next simplices of the filter: all that enter at the next index.
  void advance(const ByDimension<D>& entering);

  /// Of all simplices added.
  [[nodiscard]] const BettiNumbers<D>& betti() const { return betti_; }

 private:
  CycleMarks<D> marks_;
  std::size_t position_ = 0;
  BettiNumbers<D> betti_{};
};

/// The Betti numbers of the complex at one index, 0..s. Takes as long as those of all.
/// @throws InputError for an index beyond s.
template <int D>
[[nodiscard]] BettiNumbers<D> betti_numbers(const Filtration<D>& filtration, std::uint32_t index);

extern template class CycleMarks<2>;  // defined in betti.cpp
extern template class CycleMarks<3>;
extern template class BettiScan<2>;
extern template class BettiScan<3>;

}  // namespace orthoball
