// SPDX-License-Identifier: MIT
#include "orthoball/output/shape_mesh.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace orthoball {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

using Triangle = std::array<std::uint32_t, 3>;

// One side of a triangle, for finding the triangles on both sides of an edge.
struct Side {
  std::uint64_t ends;  // smaller vertex in the upper half
  std::uint32_t triangle;
  bool ascends;  // the triangle runs through it from the smaller to the larger vertex
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      const auto [low, high] = std::minmax(from, to);
      sides.push_back(
          {(std::uint64_t{low} << 32U) | high, static_cast<std::uint32_t>(t), from == low});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.ends, a.triangle) < std::pair(b.ends, b.triangle);
  });
  return sides;
}

// Turns singular triangles so that two that share an edge with no third run through it in opposite
// directions, going out from the first triangle of every patch.
void orient_alike(std::vector<Triangle>& triangles) {
  struct Link {
    std::uint32_t triangle;
    bool differs;  // as they stand, both run through the edge in the same direction
  };
  std::vector<std::array<Link, 3>> links(triangles.size(),
                                         {{{kUnused, false}, {kUnused, false}, {kUnused, false}}});
  std::vector<std::uint8_t> link_count(triangles.size(), 0);
  const std::vector<Side> sides = sorted_sides(triangles);
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].ends == sides[first].ends) ++last;
    if (last - first != 2) continue;
    const Side &a = sides[first], &b = sides[first + 1];
    const bool differs = a.ascends == b.ascends;
    links[a.triangle][link_count[a.triangle]++] = {b.triangle, differs};
    links[b.triangle][link_count[b.triangle]++] = {a.triangle, differs};
  }
  std::vector<bool> is_done(triangles.size(), false), is_turned(triangles.size(), false);
  std::vector<std::uint32_t> front;
  for (std::uint32_t start = 0; start < triangles.size(); ++start) {
    if (is_done[start]) continue;
    is_done[start] = true;
    front.push_back(start);
    while (!front.empty()) {
      const std::uint32_t t = front.back();
      front.pop_back();
      for (std::size_t i = 0; i < link_count[t]; ++i) {
        const Link& link = links[t][i];
        if (is_done[link.triangle]) continue;
        is_done[link.triangle] = true;
        is_turned[link.triangle] = is_turned[t] != link.differs;
        front.push_back(link.triangle);
      }
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (is_turned[t]) std::swap(triangles[t][1], triangles[t][2]);
  }
}

// Gives mesh numbers to the vertices that are used, in their order, and writes all simplices in
// these numbers.
template <int D>
void number_vertices(ShapeMesh& mesh, const Sites<D>& sites, const WeightedPoints& points) {
  std::vector<std::uint32_t> number(sites.size(), kUnused);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) number[v] = 0;
  }
  for (const auto& edge : mesh.edges) {
    for (const std::uint32_t v : edge) number[v] = 0;
  }
  for (const std::uint32_t v : mesh.isolated) number[v] = 0;

  for (std::uint32_t v = 0; v < sites.size(); ++v) {
    if (number[v] == kUnused) continue;
    number[v] = static_cast<std::uint32_t>(mesh.rows.size());
    mesh.rows.push_back(sites.row(v));
    for (int axis = 0; axis < 3; ++axis) {
      mesh.coordinates.push_back(axis < D ? points.coordinate(sites.row(v).row(), axis) : 0.0);
    }
  }
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) v = number[v];
  }
  for (auto& edge : mesh.edges) {
    for (std::uint32_t& v : edge) v = number[v];
  }
  for (std::uint32_t& v : mesh.isolated) v = number[v];
}

template <std::size_t N, class Simplices, class Corners>
void append(Simplices& simplices, const Corners& corners) {
  std::array<std::uint32_t, N> numbers;
  std::transform(corners.begin(), corners.end(), numbers.begin(),
                 [](VertexId v) { return v.row(); });
  simplices.push_back(numbers);
}

// Calls `visit(simplex, role)` for every simplex of a dimension on the boundary of a complex.
template <int D, class Visit>
void for_boundary(const AlphaComplex<D>& complex, int dimension, const Visit& visit) {
  const Filtration<D>& filtration = complex.filtration();
  const std::uint32_t first = filtration.table().first(dimension);
  const auto end = static_cast<std::uint32_t>(first + filtration.count(dimension));
  for (std::uint32_t row = first; row < end; ++row) {
    const Role role = complex.role(SimplexId(row));
    if (role == Role::singular || role == Role::regular) visit(SimplexId(row), role);
  }
}

}  // namespace

template <int D>
std::array<VertexId, std::size_t{D}> outward_facet(const CellRecord<D>& cell, std::size_t apex) {
  // The cell is positively oriented; so is (facet, apex) after an even permutation of it.
  std::array<VertexId, std::size_t{D}> outward;
  for (std::size_t i = 0; i < D; ++i) {
    outward[i] = VertexId(cell.corners[(apex + 1 + i) % (D + 1)]);
  }
  if (D == 3 && apex % 2 == 1) std::swap(outward[1], outward[2]);
  return outward;
}

template <int D>
std::array<VertexId, std::size_t{D}> outward_facet(const AlphaComplex<D>& complex,
                                                   SimplexId facet) {
  const Filtration<D>& filtration = complex.filtration();
  const auto beside = filtration.cells_beside(facet);
  const SimplexId inside = complex.contains(beside[0]) ? beside[0] : beside[1];
  const CellRecord<D>& cell =
      filtration.triangulation().template cells<D>()[inside.row() - filtration.table().first(D)];
  const auto vertices = filtration.vertices(facet);
  std::size_t apex = 0;  // the corner that is not a vertex of the facet
  while (std::any_of(vertices.begin(), vertices.end(),
                     [&](VertexId v) { return v.row() == cell.corners[apex]; })) {
    ++apex;
  }
  return outward_facet<D>(cell, apex);
}

template <int D>
ShapeMesh shape_mesh(const AlphaComplex<D>& complex, const WeightedPoints& points) {
  const Filtration<D>& filtration = complex.filtration();
  ShapeMesh mesh;
  mesh.dimension = D;
  mesh.index = complex.index();
  std::vector<Triangle> singular_triangles;
  for_boundary(complex, D - 1, [&](SimplexId facet, Role role) {
    if constexpr (D == 2) {
      if (role == Role::regular) append<2>(mesh.edges, outward_facet(complex, facet));
      if (role == Role::singular) append<2>(mesh.edges, filtration.vertices(facet));
      mesh.edge_roles.push_back(role);
    } else if (role == Role::regular) {
      append<3>(mesh.triangles, outward_facet(complex, facet));
    } else {
      append<3>(singular_triangles, filtration.vertices(facet));
    }
  });
  mesh.triangle_roles.assign(mesh.triangles.size(), Role::regular);
  orient_alike(singular_triangles);
  mesh.triangles.insert(mesh.triangles.end(), singular_triangles.begin(), singular_triangles.end());
  mesh.triangle_roles.resize(mesh.triangles.size(), Role::singular);

  if constexpr (D == 3) {
    for_boundary(complex, 1, [&](SimplexId edge, Role role) {
      if (role == Role::singular) append<2>(mesh.edges, filtration.vertices(edge));
    });
    mesh.edge_roles.assign(mesh.edges.size(), Role::singular);
  }
  for_boundary(complex, 0, [&](SimplexId vertex, Role role) {
    if (role == Role::singular) mesh.isolated.push_back(vertex.row());
  });
  number_vertices(mesh, filtration.triangulation().sites(), points);
  return mesh;
}

template std::array<VertexId, 2> outward_facet<2>(const CellRecord<2>&, std::size_t);
template std::array<VertexId, 3> outward_facet<3>(const CellRecord<3>&, std::size_t);
template std::array<VertexId, 2> outward_facet<2>(const AlphaComplex<2>&, SimplexId);
template std::array<VertexId, 3> outward_facet<3>(const AlphaComplex<3>&, SimplexId);
template ShapeMesh shape_mesh<2>(const AlphaComplex<2>&, const WeightedPoints&);
template ShapeMesh shape_mesh<3>(const AlphaComplex<3>&, const WeightedPoints&);

}  // namespace orthoball
