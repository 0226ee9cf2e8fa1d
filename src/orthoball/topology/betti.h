// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filter_steps.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/index_counts.h"
#include "orthoball/ids.h"

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
  /// Calls `visit` for all edges that join two components, ascending.
  template <class Visit>
  void for_each_joining(const Visit& visit) const {
    for_each_in_forest(first_edge_, first_triangle_, visit);
  }
  /// Calls `visit` for all triangles that cut a void, or the outside, in two, ascending.
  template <class Visit>
  void for_each_cutting(const Visit& visit) const {
    for_each_in_forest(first_triangle_, size_, visit);
  }

 private:
  void mark(std::uint32_t row) { forests_[row / 64] |= std::uint64_t{1} << row % 64; }
  template <class Visit>
  void for_each_in_forest(std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
    for (std::uint32_t word = begin / 64; std::uint64_t{word} * 64 < end; ++word) {
      for (std::uint64_t bits = forests_[word]; bits != 0; bits &= bits - 1) {
        const std::uint32_t row = 64 * word + static_cast<std::uint32_t>(std::countr_zero(bits));
        if (row >= begin && row < end) visit(SimplexId(row));
      }
    }
  }

  std::uint32_t first_edge_, first_triangle_, size_;
  std::vector<std::uint64_t> forests_;  // bit per simplex: a joining edge or a cutting triangle
};

/// The Betti numbers of the alpha complexes of a filtration, one after the other. Two bytes for
/// every edge that joins components and every triangle that cuts a void: 16 a site in space.
template <int D>
class BettiScan {
 public:
  /// Begins with the empty complex.
  explicit BettiScan(const Filtration<D>& filtration);

  /// Goes on to the next index, at which `entering` simplices join.
  void advance(const ByDimension<D>& entering);

  /// Of all simplices added.
  [[nodiscard]] const BettiNumbers<D>& betti() const { return betti_; }

 private:
  IndexCounts joining_, cutting_;  // edges and triangles, see CycleMarks
  std::uint32_t index_ = 0;
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
