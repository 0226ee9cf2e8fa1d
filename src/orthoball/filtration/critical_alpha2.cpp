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
#include <array>
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
    result_.roles.assign(table_.first(kFillsSpace ? A - 1 : A),
                         {.regular = never_, .interior = kFillsSpace ? 0 : never_});
    std::uint32_t next_facet = table_.first(A - 1);
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      const FacetIndices facets = pass_facets(cell, next_facet);
      pass_cell(cell, facets);
    }
    if constexpr (A == 3) pass_edges();
    for (std::uint32_t vertex = 0; vertex < table_.count(0); ++vertex) enter_if_attached(vertex);
  }

 private:
  static constexpr bool kFillsSpace = A == D;
  // [corner]: when the facet opposite enters; never where another cell owns it.
  using FacetIndices = std::array<std::uint32_t, std::size_t{A} + 1>;

  [[nodiscard]] std::uint32_t enters_of_cell(std::uint32_t cell) const {
    return result_.enters[table_.first(A) + cell];
  }
  void begin_with(std::uint32_t face, std::uint32_t index) {
    result_.roles[face].regular = std::min(result_.roles[face].regular, index);
  }
  void end_with(std::uint32_t face, std::uint32_t index) {
    result_.roles[face].interior = std::max(result_.roles[face].interior, index);
  }
  void enter_if_attached(std::uint32_t simplex) {
    if (result_.is_attached[simplex]) result_.enters[simplex] = result_.roles[simplex].regular;
  }

  // From cells to the facets that `cell` owns, the first of which is `next`. Which these are is
  // hard to foretell, so the others go through the same steps without effect.
  FacetIndices pass_facets(std::uint32_t cell, std::uint32_t& next) {
    FacetIndices result;
    for (unsigned corner = 0; corner <= A; ++corner) {
      const std::uint32_t beyond = cells_[cell].neighbours[corner];
      const bool is_hull = beyond == kOutside;
      const bool is_owned = beyond / 4 > cell;
      const std::uint32_t facet = A == 1 ? cells_[cell].corners[A - corner] : next;
      const std::uint32_t other = enters_of_cell(is_hull ? cell : beyond / 4);
      const std::uint32_t regular = std::min(enters_of_cell(cell), other);
      if (!kFillsSpace && is_owned) result_.roles[facet].regular = regular;
      std::uint32_t& enters = result_.enters[facet];
      enters = is_owned && result_.is_attached[facet] ? regular : enters;
      result[corner] = is_owned ? enters : never_;
      next += is_owned ? 1 : 0;
      if (kFillsSpace && is_hull) end_at_hull(cell, corner);
    }
    return result;
  }

  // From a cell and its facets to what is kept of their faces.
  void pass_cell(std::uint32_t cell, const FacetIndices& facets) {
    const std::uint32_t index = kFillsSpace ? enters_of_cell(cell) : never_;
    for (unsigned corner = 0; corner <= A; ++corner) {
      const std::uint32_t vertex = cells_[cell].corners[corner];
      if constexpr (kFillsSpace) end_with(vertex, index);
      if constexpr (A == 2) {
        begin_with(vertex, std::min(facets[(corner + 1) % 3], facets[(corner + 2) % 3]));
      }
    }
    if constexpr (A == 3) {
      for (unsigned slot = 0; slot < 6; ++slot) {
        const std::uint32_t edge = table_.first(1) + edges_of_cells_[cell][slot];
        const auto [i, j] = kEdgeCorners[5 - slot];
        begin_with(edge, std::min(facets[i], facets[j]));
        end_with(edge, index);
      }
    }
  }

  void end_at_hull(std::uint32_t cell, unsigned corner) {
    for (unsigned other = 0; other <= A; ++other) {
      if (other == corner) continue;
      end_with(cells_[cell].corners[other], never_);
      if constexpr (A == 3) {
        end_with(table_.first(1) + edges_of_cells_[cell][5U - kEdgeSlot[corner][other]], never_);
      }
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
