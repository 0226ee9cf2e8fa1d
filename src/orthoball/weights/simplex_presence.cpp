// SPDX-License-Identifier: MIT
#include "orthoball/weights/simplex_presence.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace orthoball {
namespace {

// [row]: its vertex, none for a hidden one.
template <int D>
std::vector<VertexId> vertex_of_row(const RegularTriangulation<D>& triangulation) {
  std::vector<VertexId> vertices(triangulation.site_count());
  for (std::uint32_t vertex = 0; vertex < triangulation.vertex_count(); ++vertex) {
    vertices[triangulation.sites().row(vertex).row()] = VertexId(vertex);
  }
  for (const Duplicate& duplicate : triangulation.duplicates()) {
    vertices[duplicate.row.row()] = vertices[duplicate.representative.row()];
  }
  return vertices;
}

}  // namespace

template <int D>
std::vector<bool> are_present(const Filtration<D>& filtration, std::uint32_t index,
                              std::span<const SimplexRows> simplices) {
  using Corners = std::vector<VertexId>;
  const std::vector<VertexId> vertices = vertex_of_row(filtration.triangulation());
  std::vector<std::pair<Corners, std::size_t>> wanted;
  std::vector<bool> is_corner(filtration.triangulation().vertex_count());
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    Corners corners;
    for (const SiteId row : simplices[i]) corners.push_back(vertices[row.row()]);
    std::sort(corners.begin(), corners.end());
    if (!corners.back().exists()) continue;  // "none" is the last of all
    for (const VertexId corner : corners) is_corner[corner.row()] = true;
    wanted.emplace_back(std::move(corners), i);
  }
  std::sort(wanted.begin(), wanted.end());

  std::vector<bool> present(simplices.size());
  for (std::uint32_t number = 0; number < filtration.size(); ++number) {
    const SimplexId simplex(number);
    if (filtration.enters(simplex) > index) continue;
    const auto corners = filtration.vertices(simplex);
    if (!std::all_of(corners.begin(), corners.end(),
                     [&](VertexId corner) { return is_corner[corner.row()]; })) {
      continue;
    }
    const std::pair<Corners, std::size_t> first(Corners(corners.begin(), corners.end()), 0);
    for (auto at = std::lower_bound(wanted.begin(), wanted.end(), first);
         at != wanted.end() && at->first == first.first; ++at) {
      present[at->second] = true;
    }
  }
  return present;
}

template std::vector<bool> are_present<2>(const Filtration<2>&, std::uint32_t,
                                          std::span<const SimplexRows>);
template std::vector<bool> are_present<3>(const Filtration<3>&, std::uint32_t,
                                          std::span<const SimplexRows>);

}  // namespace orthoball
