// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// A part of the cells around a vertex: all inside a solid or all outside it, joined through facets
/// that have the vertex.
struct StarPart {
  bool is_inside = false;
  bool has_outside = false;  ///< beyond the convex hull; then it is outside the solid
};

/// The cells around single vertices of a triangulation, and how a solid, a set of cells, divides
/// them.
///
/// The surface of a solid is a manifold at a vertex exactly where the cells around it make no more
/// than one part inside the solid and one outside it, what is beyond the convex hull counting as
/// one more cell outside. For the directions at the vertex are a sphere (D = 2: a circle) that
/// these parts divide; with one part on either side what divides them is one closed curve (two
/// points), and where it is not, or touches itself, one of the sides is in several parts.
///
/// Refers to the filtration. Four numbers a cell in space. Not for several threads at once.
template <int D>
class StarParts {
 public:
  explicit StarParts(const Filtration<D>& filtration);

  /// The cells around a vertex, ascending, by number among cells.
  [[nodiscard]] std::span<const std::uint32_t> cells(std::uint32_t vertex) const {
    return std::span(cells_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

  /// Looks at the cells around a vertex. What the next three return is of the last vertex.
  /// @param solid  [cell]: whether it is inside.
  void read(std::uint32_t vertex, const std::vector<bool>& solid);
  /// [part]
  [[nodiscard]] std::span<const StarPart> parts() const { return parts_; }
  /// [place of a cell in cells(vertex)]: its part.
  [[nodiscard]] std::span<const std::uint32_t> part_of() const { return part_of_; }
  /// How many parts there are beyond one inside and one outside: 0 where the surface is a manifold
  /// or does not come.
  [[nodiscard]] std::uint32_t surplus() const;

  /// Calls `visit(place)` for the places in cells(vertex) of the cells that share a facet with that
  /// at `place` and have the vertex, too; with cells(vertex).size() for the outside.
  /// Of the vertex that was read last.
  template <class Visit>
  void for_each_beside(std::size_t place, const Visit& visit) const {
    const CellRecord<D>& cell = records_[here_[place]];
    for (std::size_t corner = 0; corner <= D; ++corner) {
      if (cell.corners[corner] == vertex_) continue;
      const std::uint32_t beyond = cell.neighbours[corner];
      visit(beyond == kOutside ? here_.size() : std::size_t{place_[beyond / 4]});
    }
  }

 private:
  void flood(const std::vector<bool>& solid);

  std::span<const CellRecord<D>> records_;
  std::vector<std::uint32_t> first_, cells_;  // [vertex]: where its cells begin
  std::vector<std::uint32_t> place_;          // [cell]: in the star that was read last
  std::uint32_t vertex_ = 0;
  std::span<const std::uint32_t> here_;  // the cells of that star
  std::vector<StarPart> parts_;
  std::vector<std::uint32_t> part_of_;
  std::vector<std::size_t> front_;  // places from which a part is flooded
};

extern template class StarParts<2>;  // defined in star_parts.cpp
extern template class StarParts<3>;

}  // namespace orthoball
