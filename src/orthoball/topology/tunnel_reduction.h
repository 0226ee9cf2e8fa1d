// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/raw_vector.h"
#include "orthoball/topology/keyed_simplices.h"

namespace orthoball {

/// The edges of the triangles of sites that span space, all by number within their dimension.
/// Refers to the filtration; 24 bytes a tetrahedron.
class TriangleBoundaries {
 public:
  explicit TriangleBoundaries(const Filtration<3>& filtration);

  [[nodiscard]] std::array<std::uint32_t, 3> edges(std::uint32_t triangle) const {
    // The slots of a facet's edges, by the corner left out.
    constexpr std::array<std::array<std::uint8_t, 3>, 4> kSlots{
        {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}}};
    const std::uint32_t owner = owners_[triangle];
    const auto& edges = edges_of_cells_[owner / 4];
    const auto& slots = kSlots[owner % 4];
    return {edges[slots[0]], edges[slots[1]], edges[slots[2]]};
  }

 private:
  std::span<const std::uint32_t> owners_;
  SimplexTable<3>::EdgesOfCells edges_of_cells_;
};

/// The boundaries of the triangles of sites that span space, reduced over Z/2: for every edge that
/// closes a loop the triangle that fills it, and a chain of edges with this as its last, in filter
/// order, that the triangles up to that one bound.
///
/// Of the chains only edges that close loops are kept: others, which join two components, lie in
/// no loop without them. Exact. Refers to the filtration.
class TunnelReduction {
 public:
  /// @param joins  [edge] those that join two components; must outlive this.
  /// @param cuts   [triangle] those that close off a void; they fill nothing.
  TunnelReduction(const Filtration<3>& filtration, const std::vector<bool>& joins,
                  const std::vector<bool>& cuts);

  [[nodiscard]] const TriangleBoundaries& boundaries() const { return boundaries_; }
  /// The triangle that fills the loop which an edge closes; kNone for an edge that joins.
  [[nodiscard]] std::uint32_t filled_by(std::uint32_t edge) const {
    const std::uint32_t filling = filling_[edge];
    return filling == kNone || filling < kStored ? filling : triangles_[filling - kStored];
  }
  /// Calls `visit(other)` for the other edges of the chain of which a filled edge is the last.
  template <class Visit>
  void for_each_before(std::uint32_t edge, const Visit& visit) const {
    const std::uint32_t filling = filling_[edge];
    if (filling < kStored) {
      for (const std::uint32_t other : boundaries_.edges(filling)) {
        if (other != edge && !joins_[other]) visit(other);
      }
    } else {
      const std::size_t number = filling - kStored;
      for (std::size_t i = begins_[number]; i < begins_[number + 1]; ++i) {
        visit(static_cast<std::uint32_t>(stored_[i]));
      }
    }
  }

  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

 private:
  static constexpr std::uint32_t kStored = std::uint32_t{1} << 31U;

  [[nodiscard]] std::vector<std::uint64_t> find_apparent(const std::vector<bool>& cuts);

  KeyedSimplices edges_, triangles_of_;
  TriangleBoundaries boundaries_;
  const std::vector<bool>& joins_;
  RawVector<std::uint32_t> filling_;    // [edge]: a triangle, or kStored and the number of a column
  std::vector<std::uint64_t> stored_;   // keys of all columns, without their last edges
  std::vector<std::size_t> begins_{0};  // [column]: where its edges begin
  std::vector<std::uint32_t> triangles_;  // [column]: whose it is
};

}  // namespace orthoball
