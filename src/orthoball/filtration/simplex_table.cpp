// SPDX-License-Identifier: MIT
//
// Every simplex once. A facet is met at its smaller cell, an edge in space at the smallest cell
// around it (edge_numbers.h). Who owns what is a set of bits, whose ranks are the numbers.
#include "orthoball/filtration/simplex_table.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/edge_numbers.h"
#include "orthoball/filtration/edge_ring.h"

namespace orthoball {
namespace {

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
                              EdgesOfCells& edges_of_cells, Threads threads) {
  edges_of_cells.clear();
  std::array<std::size_t, std::size_t{D} + 1> counts{};
  counts[0] = triangulation.vertex_count();
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      const auto cells = triangulation.template cells<A>();
      counts[A] = cells.size();
      add_facets<A>(cells, threads);
      counts[A - 1] = facet_owners_.size();
      if constexpr (A == 3) {
        add_edges(cells, edges_of_cells, threads);
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
void SimplexTable<D>::add_facets(std::span<const CellRecord<A>> cells, Threads threads) {
  constexpr std::size_t kCells = 16;  // of a word of bits
  constexpr std::size_t kLeastWords = std::size_t{1} << 12U;
  std::vector<std::uint64_t> owned(cells.size() / kCells + 1, 0);
  const std::size_t parts = owned.size() / kLeastWords + 1;
  parallel_parts(threads, owned.size(), parts,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t word = begin; word < end; ++word) {
                     const std::size_t first = kCells * word;
                     const std::size_t size = std::min(kCells, cells.size() - first);
                     for (std::size_t i = 0; i < size; ++i) {
                       for (std::size_t corner = 0; corner <= A; ++corner) {
                         // kOutside is larger than any cell, too.
                         const bool is_owned = cells[first + i].neighbours[corner] / 4 > first + i;
                         owned[word] |= std::uint64_t{is_owned} << (4 * i + corner);
                       }
                     }
                   }
                 });
  owned_facets_ = RankedBits(std::move(owned));
  require_numbers(owned_facets_.count() + cells.size());
  facet_owners_.resize(owned_facets_.count());
  if constexpr (A == 1) {  // facets are vertices, which have their numbers
    owned_facets_.for_each([&](std::uint32_t owner) {
      facet_owners_[cells[owner / 4].corners[1 - owner % 4]] = owner;
    });
  } else {
    parallel_parts(threads, owned_facets_.word_count(), parts,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     std::uint32_t facet =
                         owned_facets_.rank(static_cast<std::uint32_t>(64 * begin));
                     owned_facets_.for_each(
                         begin, end, [&](std::uint32_t owner) { facet_owners_[facet++] = owner; });
                   });
  }
}

template <int D>
void SimplexTable<D>::add_edges(std::span<const CellRecord<3>> cells, EdgesOfCells& edges_of_cells,
                                Threads threads) {
  if (cells.size() >= 0xFFFFFFFFU / 6) {
    throw LimitError("the triangulation has " + std::to_string(cells.size()) +
                     " tetrahedra; at most 715827881 can be handled");
  }
  EdgeNumbers edges = edge_numbers(cells, threads);
  edges_of_cells = std::move(edges.of_cells);
  edge_owners_ = std::move(edges.owners);
  // Owners ascend, so each word of bits is written at once, or twice where two parts share it.
  constexpr std::size_t kLeastEdges = std::size_t{1} << 16U;
  std::vector<std::uint64_t> owned(6 * cells.size() / 64 + 1, 0);
  const std::size_t parts = edge_owners_.size() / kLeastEdges + 1;
  parallel_parts(threads, edge_owners_.size(), parts,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t edge = begin; edge < end;) {
                     const std::uint32_t word = edge_owners_[edge] / 64;
                     std::uint64_t bits = 0;
                     for (; edge < end && edge_owners_[edge] / 64 == word; ++edge) {
                       bits |= std::uint64_t{1} << edge_owners_[edge] % 64;
                     }
                     std::atomic_ref(owned[word]).fetch_or(bits, std::memory_order_relaxed);
                   }
                 });
  owned_edges_ = RankedBits(std::move(owned));
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
  return owned_edges_.rank(6 * owner + slot_there);
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
