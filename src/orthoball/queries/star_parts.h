// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/queries/star_pieces.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {

/// How a solid, a set of cells, divides the cells around every vertex into parts: all inside it or
/// all outside it, joined through facets that have the vertex. Kept while cells change sides.
///
/// The surface of the solid is a manifold at a vertex exactly where the cells around it make no
/// more than one part inside the solid and one outside it, what is beyond the convex hull counting
/// as one more cell outside. For the directions at the vertex are a sphere (D = 2: a circle) that
/// these parts divide; with one part on either side what divides them is one closed curve (two
/// points), and where it is not, or touches itself, one of the sides is in several parts. What is
/// more than one part on either side is surplus.
///
/// When cells change sides, of what that cuts into pieces all but the largest are flooded
/// (StarPieces), and of what it joins, too. Refers to the filtration. 56 bytes a cell in space. Not
/// for several threads at once.
template <int D>
class StarParts {
 public:
  /// @param solid  [cell], by number among cells: whether it is inside.
  StarParts(const Filtration<D>& filtration, std::vector<bool> solid);

  /// [cell]
  [[nodiscard]] const std::vector<bool>& solid() const { return solid_; }
  /// [cell]: of the triangulation.
  [[nodiscard]] std::span<const CellRecord<D>> records() const { return records_; }
  /// The cells around a vertex, ascending.
  [[nodiscard]] std::span<const std::uint32_t> cells(std::uint32_t vertex) const {
    return std::span(cells_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }
  /// How many parts there are around a vertex on a side.
  [[nodiscard]] std::uint32_t part_count(std::uint32_t vertex, bool is_inside) const {
    return count_[vertex][is_inside ? 1 : 0];
  }
  /// The part around a vertex that a cell is of; less than cells(vertex).size() + 1. For kOutside
  /// that of what is beyond the convex hull.
  [[nodiscard]] std::uint32_t part(std::uint32_t vertex, std::uint32_t cell) const {
    return cell == kOutside ? 0 : part_[slot(vertex, cell)];
  }
  /// Whether part 0 around a vertex has what is beyond the convex hull.
  [[nodiscard]] bool has_outside(std::uint32_t vertex) const { return has_outside_[vertex]; }
  /// Whether a cell, which may be kOutside, is inside the solid.
  [[nodiscard]] bool is_inside(std::uint32_t cell) const {
    return cell != kOutside && solid_[cell];
  }

  /// How many parts around a vertex are more than one inside and one outside.
  [[nodiscard]] std::uint32_t surplus(std::uint32_t vertex) const {
    return surplus_of(count_[vertex]);
  }
  /// How many vertices have surplus.
  [[nodiscard]] std::size_t offending_count() const { return offending_count_; }
  /// How much less the surplus of all vertices would be after cells, of one side, changed to the
  /// other. If that is less than `least`, it may be told as anything less.
  [[nodiscard]] std::int64_t gain(std::span<const std::uint32_t> cells, std::int64_t least);
  /// No less than that, found without looking further than one cell.
  [[nodiscard]] std::int64_t most_gain(std::span<const std::uint32_t> cells);
  /// They change.
  void turn(std::span<const std::uint32_t> cells);
  /// The cells that were flooded so far.
  [[nodiscard]] std::uint64_t work() const { return work_ + pieces_.work(); }

 private:
  using Count = std::array<std::uint32_t, 2>;  // of parts, outside and inside the solid
  struct Turned {
    std::uint32_t vertex, cell;
    friend auto operator<=>(const Turned&, const Turned&) = default;
  };
  // A cell beside one that turns: its part, and the place of that in Change::turned.
  struct Beside {
    std::uint32_t part, cell, turned;
    friend auto operator<=>(const Beside&, const Beside&) = default;
  };
  struct Range {
    std::size_t first, end;
    template <class Value>
    [[nodiscard]] std::span<const Value> of(const std::vector<Value>& values) const {
      return std::span(values).subspan(first, end - first);
    }
  };
  // What turns around one vertex: ranges of turned_, joined_ and seeds_.
  struct Change {
    std::uint32_t vertex;
    Range turned, joined{}, seeds{};
    Count count{};  // after it, if what cells leave stays in one piece
  };

  [[nodiscard]] static std::uint32_t surplus_of(const Count& count) {
    return (count[0] > 1 ? count[0] - 1 : 0) + (count[1] > 1 ? count[1] - 1 : 0);
  }
  [[nodiscard]] std::size_t slot(std::uint32_t vertex, std::uint32_t cell) const {
    const auto& corners = records_[cell].corners;
    std::size_t corner = 0;
    while (corners[corner] != vertex) ++corner;
    return (std::size_t{D} + 1) * cell + corner;
  }
  [[nodiscard]] std::uint32_t& size(std::uint32_t vertex, std::uint32_t part) {
    return sizes_[first_[vertex] + vertex + part];
  }
  void divide(std::uint32_t vertex);
  void flood(std::uint32_t vertex, std::uint32_t start, std::uint32_t part);
  [[nodiscard]] std::uint32_t new_part(std::uint32_t vertex);
  void look(std::span<const std::uint32_t> cells);
  void look_at(Change& change);
  [[nodiscard]] UnionFind groups(const Change& change);
  template <class Visit>
  void for_each_cut(const Change& change, const Visit& visit);
  void cut(Change& change);
  void join(const Change& change);

  std::span<const CellRecord<D>> records_;
  std::vector<bool> solid_;                   // [cell]
  std::vector<std::uint32_t> first_, cells_;  // [vertex]: where its cells begin
  std::vector<std::uint32_t> part_;           // [(D + 1) * cell + corner]: around that vertex
  std::vector<std::uint32_t> sizes_;          // [first_[vertex] + vertex + part]: in cells
  std::vector<std::uint32_t> last_part_;      // [vertex]: that was new
  std::vector<Count> count_;                  // [vertex]
  std::vector<bool> has_outside_;             // [vertex]
  std::size_t offending_count_ = 0;
  std::vector<std::uint32_t> front_;
  StarPieces<D> pieces_;
  std::uint64_t work_ = 0;

  // What was looked at last.
  std::vector<std::uint32_t> place_;  // [cell]: of one that turns, around the vertex
  std::vector<Turned> turned_;
  std::vector<Change> changes_;
  std::vector<Beside> joined_;  // of the side to which cells turn
  std::vector<Beside> seeds_;   // of the side that they leave, without them
};

extern template class StarParts<2>;  // defined in star_parts.cpp
extern template class StarParts<3>;

}  // namespace orthoball
