// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// Where sets of cells outside a complex end, voids or pockets: the facets that one of their cells
/// has and no other cell of the same set; sheets of the complex inside a region are left out.
/// Regions have no vertices in common, so each is a connected set of its own. In the plane facets
/// are edges.
///
/// Triangles turn counterclockwise seen from outside the region; edges have it on their left.
template <int D>
struct RegionMesh {
  std::uint32_t index = 0;          ///< of the complex
  std::vector<double> coordinates;  ///< [3 * vertex + axis]; 0 for z in
                                    ///< the plane
  std::vector<SiteId> rows;         ///< [vertex] the input row
  std::vector<std::array<std::uint32_t, std::size_t{D}>> facets;  ///< vertices of this mesh
  std::vector<std::uint32_t> regions;                             ///< [facet] from 0
  std::vector<bool> are_open;  ///< [facet] outside the complex: a
                               ///< part of a mouth
};

/// The boundaries of some sets of cells. Linear.
/// @param points   what the filtration was made of.
/// @param regions  sets of cells of the filtration that have none in common.
template <int D>
[[nodiscard]] RegionMesh<D> region_mesh(const Filtration<D>& filtration,
                                        const WeightedPoints& points, std::uint32_t index,
                                        std::span<const std::span<const SimplexId>> regions);

/// What a mesh of regions says of itself.
struct RegionMeshText {
  std::string_view title;  ///< one line, a comment
  std::string_view name;   ///< of the property that numbers the regions from 1: "void"
  bool mouths = false;     ///< tell facets outside the complex by the property `mouth`
};

/// A binary PLY: vertices with `row`; faces, in the plane edges, with the number of their region
/// and, where wanted, `mouth`, which is 1 where the region opens to the outside, else 0.
/// @throws OutputError
template <int D>
void write_region_ply(ByteSink& sink, const RegionMesh<D>& mesh, const RegionMeshText& text);

extern template RegionMesh<2> region_mesh(const Filtration<2>&, const WeightedPoints&,
                                          std::uint32_t,  // in region_mesh.cpp
                                          std::span<const std::span<const SimplexId>>);
extern template RegionMesh<3> region_mesh(const Filtration<3>&, const WeightedPoints&,
                                          std::uint32_t,
                                          std::span<const std::span<const SimplexId>>);
extern template void write_region_ply(ByteSink&, const RegionMesh<2>&, const RegionMeshText&);
extern template void write_region_ply(ByteSink&, const RegionMesh<3>&, const RegionMeshText&);

}  // namespace orthoball
