// SPDX-License-Identifier: MIT
//
// The boundary edges of a plane shape, each with the inside on its left, joined to rings.
//
// Where several parts of the shape meet in a vertex, several edges leave it. The ring stays with
// the sector of triangles it came along: from an edge u -> v it turns around v through the shape's
// triangles to the edge v -> w at the other end of the sector. So a ring never passes from one part
// to another, but a part that touches itself makes a ring that visits a vertex twice. Such a ring
// is cut there: each loop that closes is a ring of its own. Of the rings of one part exactly one
// turns counterclockwise: its outer boundary. That is decided exactly, at the ring's
// lexicographically smallest vertex.

#include "orthoball/output/polygons.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "orthoball/exact/orient.h"
#include "orthoball/output/shape_mesh.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using Ring = std::vector<VertexId>;

struct BoundaryEdge {
  std::uint32_t from, to;
  std::uint32_t cell;  // the triangle on its left
  std::uint32_t apex;  // the corner of that triangle opposite this edge
};

// The triangles of the shape as the walk sees them.
class Shape {
 public:
  explicit Shape(const AlphaComplex<2>& complex)
      : complex_(complex),
        cells_(complex.filtration().triangulation().cells<2>()),
        first_(complex.filtration().table().first(2)) {}

  [[nodiscard]] std::size_t cell_count() const { return cells_.size(); }
  [[nodiscard]] const CellRecord<2>& cell(std::uint32_t cell) const { return cells_[cell]; }
  [[nodiscard]] bool contains(std::uint32_t cell) const {
    return complex_.contains(SimplexId(first_ + cell));
  }
  // The neighbour across the edge opposite a corner as 4 * cell + corner, kOutside if not in K.
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t cell, std::uint32_t corner) const {
    const std::uint32_t across = cells_[cell].neighbours[corner];
    return across == kOutside || !contains(across / 4) ? kOutside : across;
  }

 private:
  const AlphaComplex<2>& complex_;
  std::span<const CellRecord<2>> cells_;
  std::uint32_t first_;  // cell, as a simplex
};

std::vector<BoundaryEdge> boundary_edges(const Shape& shape) {
  std::vector<BoundaryEdge> edges;
  for (std::uint32_t c = 0; c < shape.cell_count(); ++c) {
    if (!shape.contains(c)) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (shape.neighbour(c, i) != kOutside) continue;
      const auto& corners = shape.cell(c).corners;
      edges.push_back({corners[(i + 1) % 3], corners[(i + 2) % 3], c, i});
    }
  }
  return edges;
}

// The edge at the other end of the sector of triangles around the edge's end, as cell and apex.
std::pair<std::uint32_t, std::uint32_t> next_edge(const Shape& shape, const BoundaryEdge& edge) {
  std::uint32_t cell = edge.cell;
  std::uint32_t opposite = (edge.apex + 1) % 3;  // the corner `from`: the edge to -> apex faces it
  for (;;) {
    const std::uint32_t across = shape.neighbour(cell, opposite);
    if (across == kOutside) return {cell, opposite};
    // In the neighbour the common edge runs apex -> to; its next edge leaves `to`.
    cell = across / 4;
    opposite = (across % 4 + 1) % 3;
  }
}

// Cuts a closed walk into loops that visit no vertex twice. `position` is kNone everywhere, before
// and after.
void cut(const Ring& walk, std::vector<std::uint32_t>& position, std::vector<Ring>& rings) {
  Ring open;
  for (const VertexId v : walk) {
    const std::uint32_t seen = position[v.row()];
    if (seen != kNone) {
      rings.emplace_back(open.begin() + seen, open.end());
      for (std::size_t i = seen; i < open.size(); ++i) position[open[i].row()] = kNone;
      open.resize(seen);
    }
    position[v.row()] = static_cast<std::uint32_t>(open.size());
    open.push_back(v);
  }
  for (const VertexId v : open) position[v.row()] = kNone;
  rings.push_back(std::move(open));
}

bool is_counterclockwise(const Sites<2>& sites, const Ring& ring) {
  const auto is_before = [&](VertexId a, VertexId b) {
    const auto p = sites.exact(a.row()), q = sites.exact(b.row());
    return std::pair(p.x[0], p.x[1]) < std::pair(q.x[0], q.x[1]);
  };
  const auto smallest = static_cast<std::size_t>(
      std::min_element(ring.begin(), ring.end(), is_before) - ring.begin());
  const VertexId before = ring[(smallest + ring.size() - 1) % ring.size()];
  const VertexId after = ring[(smallest + 1) % ring.size()];
  return orient<2, 2>(sites, Corners<2>{before.row(), ring[smallest].row(), after.row()}) ==
         Sign::positive;
}

}  // namespace

std::vector<Polygon> polygons(const AlphaComplex<2>& complex) {
  const Filtration<2>& filtration = complex.filtration();
  const Shape shape(complex);
  const std::vector<BoundaryEdge> edges = boundary_edges(shape);
  std::vector<std::array<std::uint32_t, 3>> edge_at(shape.cell_count(), {kNone, kNone, kNone});
  for (std::uint32_t e = 0; e < edges.size(); ++e) edge_at[edges[e].cell][edges[e].apex] = e;

  UnionFind parts(shape.cell_count());
  for (std::uint32_t c = 0; c < shape.cell_count(); ++c) {
    for (std::uint32_t i = 0; i < 3 && shape.contains(c); ++i) {
      if (shape.neighbour(c, i) != kOutside) parts.unite(c, shape.neighbour(c, i) / 4);
    }
  }
  std::vector<Polygon> found;
  std::vector<std::uint32_t> polygon_of_part(shape.cell_count(), kNone);
  std::vector<std::uint32_t> position(filtration.triangulation().vertex_count(), kNone);
  std::vector<bool> is_used(edges.size(), false);
  for (std::uint32_t first = 0; first < edges.size(); ++first) {
    if (is_used[first]) continue;
    Ring walk;
    for (std::uint32_t e = first; !is_used[e];) {
      is_used[e] = true;
      walk.emplace_back(edges[e].from);
      const auto [cell, apex] = next_edge(shape, edges[e]);
      e = edge_at[cell][apex];
    }
    std::uint32_t& polygon = polygon_of_part[parts.find(edges[first].cell)];
    if (polygon == kNone) {
      polygon = static_cast<std::uint32_t>(found.size());
      found.emplace_back();
    }
    auto& rings = found[polygon].rings;
    const std::size_t known = rings.size();
    cut(walk, position, rings);
    for (std::size_t r = known; r < rings.size(); ++r) {
      if (is_counterclockwise(filtration.triangulation().sites(), rings[r])) {
        std::swap(rings[0], rings[r]);
      }
    }
  }
  return found;
}

}  // namespace orthoball
