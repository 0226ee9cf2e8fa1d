// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// Calls `visit(other)` for the cells that share a facet with `cell` and have the vertex, too; with
/// kOutside for what is beyond the convex hull.
template <int D, class Visit>
void for_each_beside(std::span<const CellRecord<D>> cells, std::uint32_t vertex, std::uint32_t cell,
                     const Visit& visit) {
  const CellRecord<D>& record = cells[cell];
  for (std::size_t corner = 0; corner <= D; ++corner) {
    if (record.corners[corner] == vertex) continue;
    const std::uint32_t beyond = record.neighbours[corner];
    visit(beyond == kOutside ? kOutside : beyond / 4);
  }
}

/// What falls apart around a vertex when cells are taken out. Refers to the cells of the
/// triangulation. Four bytes a cell.
template <int D>
class StarPieces {
 public:
  explicit StarPieces(std::span<const CellRecord<D>> cells)
      : records_(cells), mark_(cells.size(), 0) {}

  /// Cells that are out, instead of those that were.
  void take_out(std::span<const std::uint32_t> cells);
  /// Of those, whether a cell, which may be kOutside, is out.
  [[nodiscard]] bool is_out(std::uint32_t cell) const {
    return cell != kOutside && mark_[cell] == out_mark_;
  }

  /// How many pieces of what remains around the vertex, of the side of the solid that the cells
  /// have that are out, have any of the seeds. All are flooded in turn until one is left that is
  /// not done: the time is that of the smaller ones, and of finding that two are one.
  /// @param seeds  of that side, not out, one at least, all different; kOutside may be one.
  [[nodiscard]] std::size_t count(std::uint32_t vertex, const std::vector<bool>& solid,
                                  std::span<const std::uint32_t> seeds);
  /// The pieces found last, but for the one that was left; kOutside is in none of them.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> cut_off();
  /// The cells that floods came to so far.
  [[nodiscard]] std::uint64_t work() const { return work_; }

 private:
  struct Flood {
    std::vector<std::uint32_t> cells;
    std::size_t next = 0;    // of them: it goes on from there
    std::size_t joined = 0;  // to this flood, which may be itself
    std::size_t open = 0;    // floods joined to it that still go on
    bool is_done = false;    // it is a piece
  };

  [[nodiscard]] std::size_t root(std::size_t flood);
  void come(std::size_t flood, std::uint32_t cell);
  void end(std::size_t flood);
  [[nodiscard]] bool go_on(std::size_t flood, std::uint32_t vertex, const std::vector<bool>& solid);

  std::span<const CellRecord<D>> records_;
  std::vector<std::uint32_t> mark_;  // [cell]: of the flood that came there last, or out_mark_
  std::uint32_t out_mark_ = 0, first_mark_ = 0, last_mark_ = 0;
  std::vector<Flood> floods_;       // the first flood_count_
  std::vector<std::size_t> going_;  // floods that go on
  std::size_t flood_count_ = 0, left_ = 0, outside_flood_ = 0;
  std::uint64_t work_ = 0;
};

extern template class StarPieces<2>;  // defined in star_pieces.cpp
extern template class StarPieces<3>;

}  // namespace orthoball
