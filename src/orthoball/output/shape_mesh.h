// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/alpha_complex.h"
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

/// The boundary of a complex. Simplices and vertices come in the order of their numbers, so the
/// mesh depends on the set of sites alone but for `rows`.
/// @param points  what the filtration was made of.
template <int D>
[[nodiscard]] ShapeMesh shape_mesh(const AlphaComplex<D>& complex, const WeightedPoints& points);

extern template ShapeMesh shape_mesh<2>(const AlphaComplex<2>&,
                                        const WeightedPoints&);  // defined in shape_mesh.cpp
extern template ShapeMesh shape_mesh<3>(const AlphaComplex<3>&, const WeightedPoints&);

/// The facet of a cell opposite to corner `apex`, in the order that puts the cell on the left
/// (D = 2) or makes it turn counterclockwise seen from outside the cell (D = 3). Exact.
template <int D>
[[nodiscard]] std::array<VertexId, std::size_t{D}> outward_facet(const CellRecord<D>& cell,
                                                                 std::size_t apex);

extern template std::array<VertexId, 2> outward_facet<2>(const CellRecord<2>&, std::size_t);
extern template std::array<VertexId, 3> outward_facet<3>(const CellRecord<3>&, std::size_t);

/// A facet of the cell on its inside: corners in the order that puts the cell on the left (D = 2)
/// or makes it turn counterclockwise seen from outside (D = 3). Exact.
/// @param facet  regular in the complex.
template <int D>
[[nodiscard]] std::array<VertexId, std::size_t{D}> outward_facet(const AlphaComplex<D>& complex,
                                                                 SimplexId facet);

extern template std::array<VertexId, 2> outward_facet<2>(const AlphaComplex<2>&, SimplexId);
extern template std::array<VertexId, 3> outward_facet<3>(const AlphaComplex<3>&, SimplexId);

}  // namespace orthoball
