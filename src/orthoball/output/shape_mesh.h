// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// The boundary of one alpha shape as arrays that mesh formats can hold: its regular and singular
/// triangles (space), its singular edges and vertices; in the plane its regular and singular edges
/// and singular vertices. Regular simplices of lower dimension are the sides of those.
///
/// Regular triangles turn counterclockwise seen from outside; regular edges of a plane shape have
/// the inside on their left. Singular triangles that share an edge with exactly one other turn the
/// same way as that one wherever the patch has two sides.
struct ShapeMesh {
  int dimension = 3;        ///< of space: 2 or 3
  std::uint32_t index = 0;  ///< of the spectrum
  /// [3 * vertex + axis], input units, correctly rounded; the third is 0 in the plane.
  std::vector<double> coordinates;
  std::vector<SiteId> rows;                             ///< [vertex] the input row
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertices of this mesh
  std::vector<Role> triangle_roles;                     ///< [triangle] singular or regular
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<Role> edge_roles;         ///< [edge] singular; also regular in the plane
  std::vector<std::uint32_t> isolated;  ///< the singular vertices: no triangle or edge uses them

  [[nodiscard]] std::size_t vertex_count() const { return rows.size(); }
};

/// The boundary of K_index. Simplices and vertices come in the order of their numbers, so the mesh
/// depends on the set of sites alone but for `rows`.
/// @param points       what the filtration was made of.
/// @param regularized  regular facets only: the boundary of the closure of the shape's interior.
template <int D>
[[nodiscard]] ShapeMesh shape_mesh(const Filtration<D>& filtration, const WeightedPoints& points,
                                   std::uint32_t index, bool regularized);

extern template ShapeMesh shape_mesh<2>(const Filtration<2>&, const WeightedPoints&, std::uint32_t,
                                        bool);  // defined in shape_mesh.cpp
extern template ShapeMesh shape_mesh<3>(const Filtration<3>&, const WeightedPoints&, std::uint32_t,
                                        bool);

/// The boundary of a set of cells, all of it regular. Vertices come in the order of their numbers,
/// facets in that of the cells inside.
/// @param points    what the filtration was made of.
/// @param contains  [cell], by number among cells: the set.
template <int D>
[[nodiscard]] ShapeMesh solid_mesh(const Filtration<D>& filtration, const WeightedPoints& points,
                                   std::uint32_t index, const std::vector<bool>& contains);

extern template ShapeMesh solid_mesh<2>(const Filtration<2>&, const WeightedPoints&, std::uint32_t,
                                        const std::vector<bool>&);  // defined in shape_mesh.cpp
extern template ShapeMesh solid_mesh<3>(const Filtration<3>&, const WeightedPoints&, std::uint32_t,
                                        const std::vector<bool>&);

/// The facet of a cell opposite to corner `apex`, in the order that puts the cell on the left
/// (D = 2) or makes it turn counterclockwise seen from outside the cell (D = 3). Exact.
template <int D>
[[nodiscard]] std::array<VertexId, std::size_t{D}> outward_facet(const CellRecord<D>& cell,
                                                                 std::size_t apex);

extern template std::array<VertexId, 2> outward_facet<2>(const CellRecord<2>&, std::size_t);
extern template std::array<VertexId, 3> outward_facet<3>(const CellRecord<3>&, std::size_t);

/// A facet of the cell on its inside: corners in the order that puts the cell on the left (D = 2)
/// or makes it turn counterclockwise seen from outside (D = 3). Exact.
/// @param facet  regular at `index`.
template <int D>
[[nodiscard]] std::array<VertexId, std::size_t{D}> outward_facet(const Filtration<D>& filtration,
                                                                 SimplexId facet,
                                                                 std::uint32_t index);

extern template std::array<VertexId, 2> outward_facet<2>(const Filtration<2>&, SimplexId,
                                                         std::uint32_t);
extern template std::array<VertexId, 3> outward_facet<3>(const Filtration<3>&, SimplexId,
                                                         std::uint32_t);

}  // namespace orthoball
