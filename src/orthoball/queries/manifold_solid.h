// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/ids.h"

namespace orthoball {

/// Cells joined through facets that were all added to a solid or all removed from it.
template <int D>
struct SolidChange {
  bool is_added = false;
  double volume = 0.0;           ///< length^D
  std::vector<SimplexId> cells;  ///< ascending
  std::vector<SiteId> rows;      ///< of their vertices, ascending
  /// The mean of these sites' centres; input units.
  std::array<double, std::size_t{D}> centre{};
};

/// A set of cells whose boundary is a closed manifold: of every component of the boundary one side
/// is solid, and nowhere do two sheets of it meet.
template <int D>
struct ManifoldSolid {
  std::vector<bool> contains;  ///< [cell], by number among cells
  std::uint32_t cell_count = 0;
  double volume = 0.0;                  ///< length^D
  double area = 0.0;                    ///< of the boundary; length^(D-1)
  std::uint32_t surface_count = 0;      ///< components of the boundary
  std::int64_t euler = 0;               ///< Euler number of the boundary: 2 a sphere, 0 a torus
  double added = 0.0, removed = 0.0;    ///< volumes; length^D
  std::vector<SolidChange<D>> changes;  ///< the largest volume first, then by first cell
  /// The vertices at which the boundary of the cells of the shape is no manifold, by row.
  std::vector<SiteId> offending;
  std::uint32_t offending_edges = 0;  ///< in space: edges with more than two boundary triangles
};

/// The solid nearest to the cells of a shape, as far as a local search sees, whose boundary is a
/// closed manifold: cells of the triangulation are added or removed where two sheets of the
/// boundary meet in an edge or a vertex. Its vertices are sites; none is there twice. Singular
/// simplices are no part of it. All cells of the shape, and nothing else, where these are a
/// manifold already; no cells where the sites span less than R^D.
///
/// A manifold: exact, always. Near: each step makes the number of surplus parts around vertices
/// (StarParts) smaller, and those come first that change the least volume for it; at the end no
/// single cell that was changed could be changed back, unless 64 looks at all of them were not
/// enough to find out. Volumes are compared as they are rounded, equal ones by number; the result
/// depends on the set of sites alone.
///
/// A wall that is one cell thick, with all its vertices on both of its sides, is not near to any
/// such solid: then much is changed.
///
/// Time for n cells, whether few or all are around one vertex: O(n log n) for each round of the
/// search, and what floods take that find the smaller pieces into which changed cells cut others.
/// A dozen rounds are usual; there are no more than 100 each time that vertices had to be cleared,
/// which happens O(log n) times, an eighth of those left each time. 110 bytes a cell, 250 where
/// nearly every vertex offends.
template <int D>
[[nodiscard]] ManifoldSolid<D> manifold_solid(const AlphaComplex<D>& shape);

/// The solid in the place of that shape: its cells and all their faces.
template <int D>
[[nodiscard]] AlphaComplex<D> complex_of(const ManifoldSolid<D>& solid,
                                         const AlphaComplex<D>& shape);

extern template ManifoldSolid<2> manifold_solid(const AlphaComplex<2>&);  // in manifold_solid.cpp
extern template ManifoldSolid<3> manifold_solid(const AlphaComplex<3>&);
extern template AlphaComplex<2> complex_of(const ManifoldSolid<2>&, const AlphaComplex<2>&);
extern template AlphaComplex<3> complex_of(const ManifoldSolid<3>&, const AlphaComplex<3>&);

}  // namespace orthoball
