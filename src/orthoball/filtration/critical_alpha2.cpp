// SPDX-License-Identifier: MIT
//
// When every simplex enters, becomes regular and becomes interior, as ranks.
//
// The unattached simplices have ranks by their own values (value_ranks.h). These go down the
// dimensions: an attached simplex enters with the first of its cofaces; the first proper coface
// makes a simplex regular, the last cell around it makes it interior.
//
// Edelsbrunner, Muecke. Three-dimensional alpha shapes. ACM Transactions on Graphics 13 (1994).
#include "orthoball/filtration/critical_alpha2.h"

#include <algorithm>
#include <span>
#include <utility>

#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/attached_simplices.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/filtration/value_ranks.h"

namespace orthoball {
namespace {

// One pass over the cells, which takes facets in the order of their numbers, then one over the
// edges in space. A >= 1.
template <int D, int A>
class HandDown {
 public:
  HandDown(std::span<const CellRecord<A>> cells, const SimplexTable<D>& table,
           const typename SimplexTable<D>::EdgesOfCells& edges_of_cells, CriticalAlpha2& result)
      : cells_(cells),
        table_(table),
        edges_of_cells_(edges_of_cells),
        result_(result),
        never_(static_cast<std::uint32_t>(result.spectrum.size()) + 1) {}

  void run() {
    const std::uint32_t kept = table_.first(kFillsSpace ? A - 1 : A);
    result_.regular.assign(kept, never_);
    result_.interior.assign(kept, kFillsSpace ? 0 : never_);
    std::uint32_t facet = table_.first(A - 1);
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      for (unsigned corner = 0; corner <= A; ++corner) {
        const std::uint32_t beyond = cells_[cell].neighbours[corner];
        if (beyond / 4 > cell)
          pass_facet(cell, corner, A == 1 ? vertex_opposite(cell, corner) : facet++);
        if (kFillsSpace && beyond == kOutside) end_at_hull(cell, corner);
      }
      if constexpr (kFillsSpace) end_in_cell(cell);
    }
    if constexpr (A == 3) pass_edges();
    for (std::uint32_t vertex = 0; vertex < table_.count(0); ++vertex) enter_if_attached(vertex);
  }

 private:
  static constexpr bool kFillsSpace = A == D;

  [[nodiscard]] std::uint32_t vertex_opposite(std::uint32_t cell, unsigned corner) const {
    return cells_[cell].corners[1 - corner];
  }
  [[nodiscard]] std::uint32_t edge_beside(std::uint32_t cell, unsigned i, unsigned j) const {
    return table_.first(1) + edges_of_cells_[cell][5U - kEdgeSlot[i][j]];
  }
  [[nodiscard]] std::uint32_t enters_of_cell(std::uint32_t cell) const {
    return result_.enters[table_.first(A) + cell];
  }
  void begin_with(std::uint32_t face, std::uint32_t index) {
    result_.regular[face] = std::min(result_.regular[face], index);
  }
  void end_with(std::uint32_t face, std::uint32_t index) {
    result_.interior[face] = std::max(result_.interior[face], index);
  }
  void enter_if_attached(std::uint32_t simplex) {
    if (result_.is_attached[simplex]) result_.enters[simplex] = result_.regular[simplex];
  }

  // Calls `visit(face)` for what is kept of the facets of a cell's facet.
  template <class Visit>
  void for_each_face(std::uint32_t cell, unsigned corner, const Visit& visit) const {
    for (unsigned other = 0; other <= A; ++other) {
      if (other == corner) continue;
      if constexpr (A == 2) visit(cells_[cell].corners[other]);
      if constexpr (A == 3) visit(edge_beside(cell, corner, other));
    }
  }

  // From the cells beside a facet to the facet, and from there to its own facets.
  void pass_facet(std::uint32_t cell, unsigned corner, std::uint32_t facet) {
    const std::uint32_t beyond = cells_[cell].neighbours[corner];
    const std::uint32_t other = beyond == kOutside ? never_ : enters_of_cell(beyond / 4);
    const std::uint32_t regular = std::min(enters_of_cell(cell), other);
    if constexpr (!kFillsSpace) result_.regular[facet] = regular;
    if (result_.is_attached[facet]) result_.enters[facet] = regular;
    const std::uint32_t index = result_.enters[facet];
    for_each_face(cell, corner, [&](std::uint32_t face) { begin_with(face, index); });
  }

  void end_in_cell(std::uint32_t cell) {
    const std::uint32_t index = enters_of_cell(cell);
    for (const std::uint32_t vertex : cells_[cell].corners) end_with(vertex, index);
    if constexpr (A == 3) {
      for (const std::uint32_t edge : edges_of_cells_[cell])
        end_with(table_.first(1) + edge, index);
    }
  }

  void end_at_hull(std::uint32_t cell, unsigned corner) {
    for (unsigned other = 0; other <= A; ++other) {
      if (other != corner) end_with(cells_[cell].corners[other], never_);
    }
    if constexpr (A == 3) {
      for_each_face(cell, corner, [&](std::uint32_t edge) { end_with(edge, never_); });
    }
  }

  void pass_edges() {
    for (std::uint32_t edge = 0; edge < table_.count(1); ++edge) {
      const std::uint32_t simplex = table_.first(1) + edge;
      enter_if_attached(simplex);
      const std::uint32_t owner = table_.edge_owners()[edge];
      for (const unsigned corner : kEdgeCorners[owner % 6]) {
        begin_with(cells_[owner / 6].corners[corner], result_.enters[simplex]);
      }
    }
  }

  std::span<const CellRecord<A>> cells_;
  const SimplexTable<D>& table_;
  const typename SimplexTable<D>::EdgesOfCells& edges_of_cells_;
  CriticalAlpha2& result_;
  std::uint32_t never_;
};

}  // namespace

template <int D>
CriticalAlpha2 critical_alpha2(const RegularTriangulation<D>& triangulation,
                               const SimplexTable<D>& table,
                               const typename SimplexTable<D>::EdgesOfCells& edges_of_cells) {
  CriticalAlpha2 result;
  result.is_attached = attached_simplices(triangulation, table, edges_of_cells);
  ValueRanks ranks = value_ranks(triangulation, table, result.is_attached);
  result.spectrum = std::move(ranks.spectrum);
  result.enters = std::move(ranks.enters);
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      HandDown<D, A>(triangulation.template cells<A>(), table, edges_of_cells, result).run();
    }
  });
  return result;
}

template CriticalAlpha2 critical_alpha2<2>(const RegularTriangulation<2>&, const SimplexTable<2>&,
                                           const SimplexTable<2>::EdgesOfCells&);
template CriticalAlpha2 critical_alpha2<3>(const RegularTriangulation<3>&, const SimplexTable<3>&,
                                           const SimplexTable<3>::EdgesOfCells&);

}  // namespace orthoball
