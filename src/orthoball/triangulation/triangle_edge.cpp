// SPDX-License-Identifier: MIT
//
// Dobkin, Laszlo. Primitives for the manipulation of three-dimensional subdivisions. Algorithmica 4
//   (1989). Muecke. Shapes and implementations in three-dimensional geometry. Thesis (1993): the
//   same for triangulations, six references stored for every triangle. Here the steps follow from
//   the cells' corners and neighbours, and nothing is stored.
#include "orthoball/triangulation/triangle_edge.h"

#include <cstddef>
#include <set>

namespace orthoball {

std::vector<TriangleEdge> TriangleEdges::ring(const TriangleEdge& at) const {
  // Back through the triangle itself until the hull or the start is met.
  TriangleEdge first = at;
  for (TriangleEdge behind = other_side(first); behind.exists(); behind = other_side(first)) {
    first = other_triangle(behind);
    if (first == at) break;
  }
  std::vector<TriangleEdge> cells{first};
  for (TriangleEdge next = next_triangle(first); next.exists() && next != first;
       next = next_triangle(next)) {
    cells.push_back(next);
  }
  return cells;
}

std::vector<TriangleEdge> TriangleEdges::link(const TriangleEdge& at) const {
  const std::uint32_t vertex = vertices(at)[0];
  std::vector<TriangleEdge> triangles{triangle(at.cell, at.from)};
  std::set<std::uint32_t> is_met{at.cell};
  for (std::size_t next = 0; next < triangles.size(); ++next) {
    const auto& record = cells_[triangles[next].cell];
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t beyond = record.neighbours[i];
      if (i == triangles[next].apex || beyond == kOutside) continue;
      if (!is_met.insert(beyond / 4).second) continue;
      std::uint32_t corner = 0;
      while (cells_[beyond / 4].corners[corner] != vertex) ++corner;
      triangles.push_back(triangle(beyond / 4, corner));
    }
  }
  return triangles;
}

std::vector<TriangleEdge> TriangleEdges::hull() const {
  std::vector<TriangleEdge> triangles;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    for (std::uint32_t facet = 0; facet < 4; ++facet) {
      if (cells_[cell].neighbours[facet] == kOutside) triangles.push_back(triangle(cell, facet));
    }
  }
  return triangles;
}

TriangleEdge TriangleEdges::next_on_hull(const TriangleEdge& at) const {
  TriangleEdge last = other_triangle(at);
  for (TriangleEdge next = other_side(last); next.exists(); next = other_side(last)) {
    last = other_triangle(next);
  }
  return reversed(last);
}

}  // namespace orthoball
