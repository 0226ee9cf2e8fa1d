// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The cells of a triangulation that is being built; knows no coordinates.
///
/// Every facet has two sides: the hull's facets are closed by cells that have the vertex at
/// infinity, numbered `infinity()`, as one corner. Cells are positively oriented; a cell at
/// infinity is so if a point beyond its finite facet takes the place of infinity. Dead cells stay
/// until reused.
template <int A>
class CellStore {
 public:
  using Cell = CellRecord<A>;  // neighbours are 4 * cell + corner, never kOutside

  /// @param vertices  numbers of finite vertices are below.
  /// @throws LimitError for more than 2^30.
  explicit CellStore(std::size_t vertices) : infinity_(infinity_above(vertices)) {}

  /// A power of two, not below the number of vertices: a bit that no vertex has.
  [[nodiscard]] std::uint32_t infinity() const { return infinity_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }  // dead ones included
  [[nodiscard]] const Cell& operator[](std::uint32_t cell) const { return cells_[cell]; }
  [[nodiscard]] Cell& operator[](std::uint32_t cell) { return cells_[cell]; }

  /// Corner at infinity, A + 1 for a finite cell.
  [[nodiscard]] std::size_t corner_at_infinity(const Cell& cell) const {
    std::size_t corner = 0;
    while (corner <= A && cell.corners[corner] != infinity_) ++corner;
    return corner;
  }
  [[nodiscard]] bool is_finite(const Cell& cell) const {
    std::uint32_t bits = 0;
    for (const std::uint32_t vertex : cell.corners) bits |= vertex;
    return (bits & infinity_) == 0;
  }

  void reserve(std::size_t cells) {
    cells_.reserve(cells);
    is_dead_.reserve(cells);
  }
  /// A new cell, or a released one.
  /// @throws LimitError for more than 2^30 cells.
  [[nodiscard]] std::uint32_t acquire() {
    if (released_.empty()) return added();
    const std::uint32_t cell = released_.back();
    released_.pop_back();
    return cell;
  }
  /// These dead cells may be given again.
  void release(std::span<const std::uint32_t> dead) {
    released_.insert(released_.end(), dead.begin(), dead.end());
  }

  /// A dead cell keeps its corners and neighbours, until it is made alive with others.
  [[nodiscard]] bool is_dead(std::uint32_t cell) const { return is_dead_[cell] != 0; }
  void set_dead(std::uint32_t cell, bool is_dead) { is_dead_[cell] = is_dead ? 1 : 0; }

  /// Makes two facets each other's other side.
  void join(std::uint32_t cell_and_corner, std::uint32_t other) {
    cells_[cell_and_corner / 4].neighbours[cell_and_corner % 4] = other;
    cells_[other / 4].neighbours[other % 4] = cell_and_corner;
  }

 private:
  // Neighbours keep 2 bits for a corner; vertices have more cells than they are.
  static constexpr std::size_t kMostCells = std::size_t{1} << 30U;

  static std::uint32_t infinity_above(std::size_t vertices) {
    if (vertices > kMostCells) {
      throw LimitError(std::to_string(vertices) + " sites; at most 2^30 can be triangulated");
    }
    return std::bit_ceil(static_cast<std::uint32_t>(vertices));
  }
  std::uint32_t added() {
    if (cells_.size() == kMostCells) {
      throw LimitError("more than 2^30 cells in the triangulation; at most 150 million sites fit");
    }
    cells_.emplace_back();
    is_dead_.push_back(0);
    return static_cast<std::uint32_t>(cells_.size() - 1);
  }

  std::uint32_t infinity_;
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> is_dead_;  // bytes, for speed
  std::vector<std::uint32_t> released_;
};

}  // namespace orthoball
