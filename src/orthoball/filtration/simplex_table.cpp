// SPDX-License-Identifier: MIT
//
// Every simplex once. Facets are met at their smaller cell, edges in space at the smallest cell of
// their ring: cells are taken in ascending order, and whichever of a cell's six edges has no number
// yet is numbered by walking its ring once, which writes the number into every cell around it.
// When an edge is met at a cell, all other cells of its ring are larger, for a smaller one would
// have numbered it; so owning needs no comparison. Each ring is walked once: linear time.
#include "orthoball/filtration/simplex_table.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/edge_ring.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kUnnumbered = 0xFFFFFFFFU;

void require_numbers(std::size_t simplices) {
  if (simplices >= 0xFFFFFFFFU) {
    throw LimitError("the triangulation has " + std::to_string(simplices) +
                     " simplices or more; at most 4294967294 can be numbered");
  }
}

template <int D, int A>
void push_sorted_corners(const CellRecord<A>& record, unsigned left_out,
                         FewOf<VertexId, D>& vertices) {
  for (unsigned corner = 0; corner <= A; ++corner) {
    if ((left_out >> corner & 1U) == 0) vertices.push_back(VertexId(record.corners[corner]));
  }
  // Corners ascend but for the last two.
  const std::size_t n = vertices.size();
  if (n >= 2 && vertices[n - 1] < vertices[n - 2]) std::swap(vertices[n - 1], vertices[n - 2]);
}

// The corners in the order of their vertices.
template <int A>
std::array<unsigned, std::size_t{A} + 1> ascending_corners(const CellRecord<A>& record) {
  std::array<unsigned, std::size_t{A} + 1> order{};
  for (unsigned corner = 0; corner <= A; ++corner) order[corner] = corner;
  if (record.corners[A] < record.corners[A - 1]) std::swap(order[A], order[A - 1]);
  return order;
}

}  // namespace

template <int D>
SimplexTable<D>::SimplexTable(const RegularTriangulation<D>& triangulation) {
  EdgesOfCells edges_of_cells;
  *this = SimplexTable(triangulation, edges_of_cells);
}

template <int D>
SimplexTable<D>::SimplexTable(const RegularTriangulation<D>& triangulation,
                              EdgesOfCells& edges_of_cells) {
  edges_of_cells.clear();
  std::array<std::size_t, std::size_t{D} + 1> counts{};
  counts[0] = triangulation.vertex_count();
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      const auto cells = triangulation.template cells<A>();
      counts[A] = cells.size();
      add_facets<A>(cells);
      counts[A - 1] = facet_owners_.size();
      if constexpr (A == 3) {
        add_edges(cells, edges_of_cells);
        counts[1] = edge_owners_.size();
      }
    }
  });
  std::size_t total = 0;
  for (std::size_t dimension = 0; dimension <= D; ++dimension) {
    first_[dimension] = static_cast<std::uint32_t>(total);
    total += counts[dimension];
    require_numbers(total);
  }
  first_.back() = static_cast<std::uint32_t>(total);
}

template <int D>
template <int A>
void SimplexTable<D>::add_facets(std::span<const CellRecord<A>> cells) {
  // A hull facet has one cell, every other two.
  std::size_t facets = 0;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    facets += count_of_four(owned_facets(cells[cell], cell));
  }
  require_numbers(facets + cells.size());
  facet_owners_.resize(facets);
  if constexpr (A == 1) {  // facets are vertices, which have their numbers
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
      const unsigned owned = owned_facets(cells[cell], cell);
      for (unsigned corner = 0; corner < 2; ++corner) {
        if ((owned >> corner & 1U) == 0) continue;
        facet_owners_[cells[cell].corners[1 - corner]] = 4 * cell + corner;
      }
    }
    return;
  }
  first_facet_.resize(cells.size());
  std::uint32_t next = 0;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    first_facet_[cell] = next;
    const unsigned owned = owned_facets(cells[cell], cell);
    for (unsigned corner = 0; corner <= A; ++corner) {
      if ((owned >> corner & 1U) != 0) facet_owners_[next++] = 4 * cell + corner;
    }
  }
}

template <int D>
void SimplexTable<D>::add_edges(std::span<const CellRecord<3>> cells,
                                EdgesOfCells& edges_of_cells) {
  if (cells.size() >= 0xFFFFFFFFU / 6) {
    throw LimitError("the triangulation has " + std::to_string(cells.size()) +
                     " tetrahedra; at most 715827881 can be handled");
  }
  std::array<std::uint32_t, 6> unnumbered{};
  unnumbered.fill(kUnnumbered);
  edges_of_cells.assign(cells.size(), unnumbered);
  first_edge_.resize(cells.size());
  owned_edges_.resize(cells.size());
  edge_owners_.reserve(cells.size() + cells.size() / 5);  // vertices + tetrahedra, about
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    first_edge_[cell] = static_cast<std::uint32_t>(edge_owners_.size());
    unsigned owned = 0;
    for (unsigned slot = 0; slot < 6; ++slot) {
      if (edges_of_cells[cell][slot] != kUnnumbered) continue;
      const auto edge = static_cast<std::uint32_t>(edge_owners_.size());
      owned |= 1U << slot;
      edge_owners_.push_back(6 * cell + slot);
      for_each_around_edge(cells, cell, slot, [&](std::uint32_t around, unsigned slot_there) {
        edges_of_cells[around][slot_there] = edge;
      });
    }
    owned_edges_[cell] = static_cast<std::uint8_t>(owned);
  }
  edge_owners_.shrink_to_fit();
}

template <int D>
FewOf<VertexId, D> SimplexTable<D>::vertices(const RegularTriangulation<D>& triangulation,
                                             SimplexId simplex) const {
  FewOf<VertexId, D> result;
  const int k = dimension(simplex);
  if (k == 0) {
    result.push_back(VertexId(simplex.row()));
    return result;
  }
  const std::uint32_t number = simplex.row() - first(k);
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      const auto cells = triangulation.template cells<A>();
      if (k == A) {
        push_sorted_corners<D, A>(cells[number], 0, result);
      } else if (k == A - 1) {
        const std::uint32_t owner = facet_owners_[number];
        push_sorted_corners<D, A>(cells[owner / 4], 1U << owner % 4, result);
      } else if constexpr (A == 3) {
        const std::uint32_t owner = edge_owners_[number];
        const auto [i, j] = kEdgeCorners[owner % 6];
        push_sorted_corners<D, A>(cells[owner / 6], 15U & ~(1U << i | 1U << j), result);
      }
    }
  });
  return result;
}

template <int D>
std::uint32_t SimplexTable<D>::edge_of_cell(std::span<const CellRecord<3>> cells,
                                            std::uint32_t cell, unsigned slot) const {
  std::uint32_t owner = cell;
  unsigned slot_there = slot;
  for_each_around_edge(cells, cell, slot, [&](std::uint32_t around, unsigned around_slot) {
    if (around >= owner) return;
    owner = around;
    slot_there = around_slot;
  });
  const unsigned before = owned_edges_[owner] & ((1U << slot_there) - 1U);
  return first_edge_[owner] + static_cast<std::uint32_t>(std::popcount(before));
}

template <int D>
FewOf<SimplexId, D> SimplexTable<D>::facets(const RegularTriangulation<D>& triangulation,
                                            SimplexId simplex) const {
  FewOf<SimplexId, D> result;
  const int k = dimension(simplex);
  if (k == 1) {
    const auto ends = vertices(triangulation, simplex);
    result.push_back(SimplexId(ends[1].row()));
    result.push_back(SimplexId(ends[0].row()));
    return result;
  }
  if (k == 0) return result;
  const std::uint32_t number = simplex.row() - first(k);
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 2) {
      const auto cells = triangulation.template cells<A>();
      if (k == A) {
        for (const unsigned corner : ascending_corners<A>(cells[number])) {
          result.push_back(SimplexId(first(A - 1) + facet_of_cell<A>(cells, number, corner)));
        }
      } else if constexpr (A == 3) {  // a triangle: each edge leaves out one of its three corners
        const std::uint32_t owner = facet_owners_[number];
        for (const unsigned corner : ascending_corners<A>(cells[owner / 4])) {
          if (corner == owner % 4) continue;
          const unsigned slot = 5U - kEdgeSlot[corner][owner % 4];
          result.push_back(SimplexId(first(1) + edge_of_cell(cells, owner / 4, slot)));
        }
      }
    }
  });
  return result;
}

template <int D>
FewOf<SimplexId, D> SimplexTable<D>::cells_beside(const RegularTriangulation<D>& triangulation,
                                                  SimplexId facet) const {
  FewOf<SimplexId, D> result;
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      const auto cells = triangulation.template cells<A>();
      const std::uint32_t owner = facet_owners_[facet.row() - first(A - 1)];
      result.push_back(SimplexId(first(A) + owner / 4));
      const std::uint32_t beyond = cells[owner / 4].neighbours[owner % 4];
      if (beyond != kOutside) result.push_back(SimplexId(first(A) + beyond / 4));
    }
  });
  return result;
}

template class SimplexTable<2>;
template class SimplexTable<3>;

}  // namespace orthoball
