// SPDX-License-Identifier: MIT
//
// The power cells of a simplex's vertices meet in a polytope whose corners are the orthocentres of
// the cells around the simplex. Orthocentres of neighbours across a facet are equal if and only if
// the far corner has power 0 to the orthosphere. So all is told by the facets at which the
// orthocentre changes, here called steps:
//
// - two power cells have a common facet, in a span of dimension 3, if three or more triangles
//   around their edge are steps (the hull counts as one): with two the polygon is a segment. On the
//   hull, two are enough unless both are triangles of the hull in one plane, where the polygon is a
//   ray. In a span of dimension 2 the edge itself is to be a step.
// - a power cell is flat if it has no such facets, or two in one plane, back to back. In space a
//   cell with an inside has three or more; in the plane it may have two, around a corner of the
//   hull.
#include "orthoball/queries/power_neighbours.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "orthoball/exact/orient.h"
#include "orthoball/exact/power_side.h"
#include "orthoball/filtration/affine_dimension.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/triangulation/affine_basis.h"

namespace orthoball {
namespace {

constexpr std::size_t kLeastPart = std::size_t{1} << 12U;

// A triangulation of affine dimension A on axes on which it is not flat.
template <int D, int A>
class Steps {
 public:
  Steps(const Filtration<D>& filtration, const Sites<D>& sites, Threads threads)
      : filtration_(filtration),
        sites_(sites),
        cells_(filtration.triangulation().template cells<A>()),
        steps_(cells_.size()) {
    parallel_parts(threads, cells_.size(), cells_.size() / kLeastPart + 1,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t cell = begin; cell < end; ++cell) find_steps(cell);
                   });
  }

  // [edge]: whether the power cells of its ends have a common facet.
  [[nodiscard]] std::vector<std::uint8_t> edges_with_facets(Threads threads) const {
    const std::size_t edges = filtration_.count(1);
    std::vector<std::uint8_t> has_facet(edges, 1);
    if constexpr (A > 1) {
      parallel_parts(threads, edges, edges / kLeastPart + 1,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t edge = begin; edge < end; ++edge) {
                         has_facet[edge] = this->has_facet(edge) ? 1 : 0;
                       }
                     });
    }
    return has_facet;
  }

  // Whether a power cell with these neighbours is flat.
  [[nodiscard]] bool is_flat(std::uint32_t vertex, std::span<const VertexId> neighbours) const {
    if constexpr (A == 1) {
      return neighbours.size() == 2 && !is_step_at(vertex);
    } else if constexpr (A == 2) {
      return neighbours.empty() ||
             (neighbours.size() == 2 && orient<2, D>(sites_, {neighbours[0].row(), vertex,
                                                              neighbours[1].row()}) == Sign::zero);
    } else {
      return neighbours.size() <= 2;
    }
  }

 private:
  void find_steps(std::size_t cell) {
    const CellRecord<A>& record = cells_[cell];
    for (unsigned corner = 0; corner <= A; ++corner) {
      const std::uint32_t beyond = record.neighbours[corner];
      const bool is_step = beyond == kOutside ||
                           power_side<A, D>(sites_, record.corners,
                                            cells_[beyond / 4].corners[beyond % 4]) != Sign::zero;
      if (is_step) steps_[cell] |= static_cast<std::uint8_t>(1U << corner);
    }
  }
  [[nodiscard]] bool is_step(std::uint32_t cell, unsigned corner) const {
    return (unsigned{steps_[cell]} >> corner & 1U) != 0;
  }

  // On a line: a vertex between two segments.
  [[nodiscard]] bool is_step_at(std::uint32_t vertex) const {
    const std::uint32_t owner =
        filtration_.cells_beside(SimplexId(vertex))[0].row() - filtration_.table().first(A);
    return is_step(owner, cells_[owner].corners[0] == vertex ? 1 : 0);
  }

  [[nodiscard]] bool has_facet(std::size_t edge) const {
    if constexpr (A == 2) {
      const std::uint32_t owner = filtration_.table().facet_owners()[edge];
      return is_step(owner / 4, owner % 4);
    } else if constexpr (A == 3) {
      const std::uint32_t owner = filtration_.table().edge_owners()[edge];
      unsigned sides = 0;  // of steps: each has two
      Corners<3> hull{};   // the edge, and what follows it in its triangles on the hull
      std::size_t known = 2;
      for_each_around_edge(cells_, owner / 6, owner % 6, [&](std::uint32_t cell, unsigned slot) {
        for (const std::size_t i : {0U, 1U}) {
          hull[i] = cells_[cell].corners[kEdgeCorners[slot][i]];
          const unsigned corner = kEdgeCorners[5 - slot][i];
          const bool is_hull = cells_[cell].neighbours[corner] == kOutside;
          if (is_step(cell, corner)) sides += is_hull ? 2 : 1;
          if (is_hull) hull[known++] = cells_[cell].corners[kEdgeCorners[5 - slot][1 - i]];
        }
      });
      if (sides / 2 >= 3) return true;
      return known == 4 && orient<3, D>(sites_, hull) != Sign::zero;
    } else {
      return true;
    }
  }

  const Filtration<D>& filtration_;
  const Sites<D>& sites_;
  std::span<const CellRecord<A>> cells_;
  std::vector<std::uint8_t> steps_;  // [cell]: bit per corner, of the facet opposite
};

// Neighbours of vertices, one run each.
struct Lists {
  std::vector<VertexId> all;
  std::vector<std::size_t> first;

  [[nodiscard]] std::span<const VertexId> of(std::size_t vertex) const {
    return std::span(all).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

// `for_each_pair(visit)` calls visit(a, b) once for every pair, in the same order each time.
template <class ForEachPair>
Lists lists_of(std::size_t vertices, const ForEachPair& for_each_pair) {
  Lists lists;
  lists.first.assign(vertices + 1, 0);
  for_each_pair([&](VertexId a, VertexId b) {
    ++lists.first[a.row() + std::size_t{1}];
    ++lists.first[b.row() + std::size_t{1}];
  });
  std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
  lists.all.resize(lists.first.back());
  std::vector<std::size_t> next(lists.first.begin(), lists.first.end() - 1);
  for_each_pair([&](VertexId a, VertexId b) {
    lists.all[next[a.row()]++] = b;
    lists.all[next[b.row()]++] = a;
  });
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    std::sort(lists.all.begin() + static_cast<std::ptrdiff_t>(lists.first[vertex]),
              lists.all.begin() + static_cast<std::ptrdiff_t>(lists.first[vertex + 1]));
  }
  return lists;
}

// From a cell with an inside through flat ones, which lie in their common plane, to the next with
// one: their sites are on a line.
VertexId behind_flat_ones(const Lists& lists, const std::vector<bool>& is_flat, VertexId from,
                          VertexId through) {
  while (is_flat[through.row()]) {
    const auto both = lists.of(through.row());
    const VertexId next = both[0] == from ? both[1] : both[0];
    from = through;
    through = next;
  }
  return through;
}

}  // namespace

template <int D>
PowerNeighbours<D>::PowerNeighbours(const Filtration<D>& filtration, Threads threads) {
  const RegularTriangulation<D>& triangulation = filtration.triangulation();
  const std::size_t vertices = triangulation.vertex_count();
  first_.assign(vertices + 1, 0);
  is_flat_.assign(vertices, false);
  with_affine_dimension(triangulation, [&]<int A>() {
    if constexpr (A >= 1) {
      Sites<D> on_axes;
      if constexpr (A < D) {
        std::vector<std::uint32_t> order(vertices);
        std::iota(order.begin(), order.end(), std::uint32_t{0});
        on_axes = triangulation.sites().with_axes(affine_basis(triangulation.sites(), order).axes);
      }
      const Steps<D, A> steps(filtration, A < D ? on_axes : triangulation.sites(), threads);
      const auto has_facet = steps.edges_with_facets(threads);
      const Lists lists = lists_of(vertices, [&](const auto& visit) {
        for (std::size_t edge = 0; edge < has_facet.size(); ++edge) {
          if (has_facet[edge] == 0) continue;
          const auto ends = filtration.vertices(
              SimplexId(filtration.table().first(1) + static_cast<std::uint32_t>(edge)));
          visit(ends[0], ends[1]);
        }
      });
      for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
        is_flat_[vertex] = steps.is_flat(vertex, lists.of(vertex));
      }
      Lists without = lists_of(vertices, [&](const auto& visit) {
        for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
          if (is_flat_[vertex]) continue;
          for (const VertexId next : lists.of(vertex)) {
            const VertexId other = behind_flat_ones(lists, is_flat_, VertexId(vertex), next);
            if (VertexId(vertex) < other) visit(VertexId(vertex), other);
          }
        }
      });
      neighbours_ = std::move(without.all);
      first_ = std::move(without.first);
    }
  });
}

template class PowerNeighbours<2>;
template class PowerNeighbours<3>;

}  // namespace orthoball
