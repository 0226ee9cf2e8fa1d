// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The cells of a triangulation that is being built; knows no coordinates.
///
/// Every facet has two sides: the hull's facets are closed by cells that have the vertex at
/// infinity, numbered `infinity()`, as one corner. Cells are positively oriented; a cell at
/// infinity is so if a point beyond its finite facet takes the place of infinity. A dead cell keeps
/// its record, with a mark, until it is used again.
template <int A>
class CellStore {
 public:
  using Cell = CellRecord<A>;  // neighbours are 4 * cell + corner, never kOutside

  /// @param vertices  numbers of finite vertices are below.
  /// @param cells     room for so many at first; what is not used costs no memory.
  /// @throws LimitError for more than 2^29 vertices.
  CellStore(std::size_t vertices, std::size_t cells) : vertices_(checked(vertices)) {
    cells_.reserve(std::min(cells, kMostCells));
  }

  /// The number of the vertex at infinity: that of the record behind the last of Sites.
  [[nodiscard]] std::uint32_t infinity() const { return vertices_; }

  /// Dead ones included.
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  [[nodiscard]] const Cell& operator[](std::uint32_t cell) const { return cells_[cell]; }
  [[nodiscard]] Cell& operator[](std::uint32_t cell) { return cells_[cell]; }

  /// Corner at infinity, A + 1 for a finite cell.
  [[nodiscard]] std::size_t corner_at_infinity(const Cell& cell) const {
    std::size_t corner = 0;
    while (corner <= A && cell.corners[corner] != vertices_) ++corner;
    return corner;
  }
  [[nodiscard]] bool is_finite(const Cell& cell) const {
    std::uint32_t largest = 0;
    for (const std::uint32_t vertex : cell.corners) largest = std::max(largest, vertex);
    return largest < vertices_;
  }

  /// The mark of dead cells, in the first of their neighbours.
  static constexpr std::uint32_t kDead = std::uint32_t{1} << 31U;
  [[nodiscard]] static bool is_dead(const Cell& cell) { return (cell.neighbours[0] & kDead) != 0; }
  void kill(std::uint32_t cell) { cells_[cell].neighbours[0] |= kDead; }
  /// Kills a cell that is not written yet.
  void kill_unwritten(std::uint32_t cell) {
    cells_[cell] = {};
    kill(cell);
  }
  void revive(std::uint32_t cell) { cells_[cell].neighbours[0] &= ~kDead; }

  /// The first of `count` new cells, which are not written yet. May move all cells.
  /// @throws LimitError for more than 2^29 cells.
  [[nodiscard]] std::uint32_t add(std::uint32_t count) {
    const std::uint32_t first = size();
    if (count > kMostCells - first) {
      throw LimitError("more than 2^29 cells in the triangulation; about " +
                       std::string(A == 3 ? "75" : "260") + " million sites fit");
    }
    cells_.resize(cells_.size() + count);
    return first;
  }

  /// How many more cells can be added.
  [[nodiscard]] std::uint32_t most_more() const {
    return static_cast<std::uint32_t>(kMostCells - cells_.size());
  }

  /// Makes two facets each other's other side.
  void join(std::uint32_t cell_and_corner, std::uint32_t other) {
    cells_[cell_and_corner / 4].neighbours[cell_and_corner % 4] = other;
    cells_[other / 4].neighbours[other % 4] = cell_and_corner;
  }

  /// All cells; the store is then empty.
  [[nodiscard]] CellArray<A> take() { return std::move(cells_); }

 private:
  // Neighbours have 2 bits for a corner and one for the mark; vertices have more cells than they
  // are.
  static constexpr std::size_t kMostCells = std::size_t{1} << 29U;

  static std::uint32_t checked(std::size_t vertices) {
    if (vertices > kMostCells) {
      throw LimitError(std::to_string(vertices) + " sites; at most 2^29 can be triangulated");
    }
    return static_cast<std::uint32_t>(vertices);
  }
  std::uint32_t vertices_;
  CellArray<A> cells_;
};

/// Unused and dead cells of a store, for one thread to take.
template <int A>
class CellSupply {
 public:
  /// Keeps a reference to the store.
  explicit CellSupply(CellStore<A>& cells) : cells_(&cells) {}

  [[nodiscard]] std::size_t size() const { return dead_.size() + (end_ - next_); }
  /// At least `count` more new cells. May move all cells.
  void add(std::uint32_t count) {
    for (; next_ < end_; ++next_) {
      cells_->kill_unwritten(next_);
      dead_.push_back(next_);
    }
    next_ = cells_->add(count);
    end_ = next_ + count;
  }
  /// A cell of no certain content. Undefined if there is none.
  [[nodiscard]] std::uint32_t acquire() {
    if (dead_.empty()) return next_++;
    const std::uint32_t cell = dead_.back();
    dead_.pop_back();
    return cell;
  }
  /// Kills a cell, which may be given again.
  void release(std::uint32_t cell) {
    cells_->kill(cell);
    dead_.push_back(cell);
  }
  /// Kills what is left.
  void close() {
    for (; next_ < end_; ++next_) cells_->kill_unwritten(next_);
  }

 private:
  CellStore<A>* cells_;
  std::uint32_t next_ = 0;
  std::uint32_t end_ = 0;
  std::vector<std::uint32_t> dead_;
};

}  // namespace orthoball
