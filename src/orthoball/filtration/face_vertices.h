// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "orthoball/filtration/edge_ring.h"
#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// The N vertices of a facet (N = D) or of an edge (N = 2), by number, ascending: what
/// Filtration::vertices gives, for loops over millions of them.
template <std::size_t N, int D>
[[nodiscard]] inline std::array<std::uint32_t, N> face_vertices(const Filtration<D>& filtration,
                                                                SimplexId face) {
  const auto cells = filtration.triangulation().template cells<D>();
  const SimplexTable<D>& table = filtration.table();
  std::array<std::uint32_t, N> result{};
  if (cells.empty()) {
    const auto vertices = filtration.vertices(face);
    for (std::size_t i = 0; i < N; ++i) result[i] = vertices[i].row();
  } else if constexpr (N == static_cast<std::size_t>(D)) {
    const std::uint32_t owner = table.facet_owners()[face.row() - table.first(D - 1)];
    const CellRecord<D>& record = cells[owner / 4];
    const std::size_t left_out = owner % 4;
    for (std::size_t i = 0; i < N; ++i) result[i] = record.corners[i < left_out ? i : i + 1];
    // Corners ascend but for the last two.
    const std::uint32_t a = result[N - 2], b = result[N - 1];
    result[N - 2] = std::min(a, b);
    result[N - 1] = std::max(a, b);
  } else {
    const std::uint32_t owner = table.edge_owners()[face.row() - table.first(1)];
    const CellRecord<D>& record = cells[owner / 6];
    const auto [i, j] = kEdgeCorners[owner % 6];
    const std::uint32_t a = record.corners[i], b = record.corners[j];
    result = {std::min(a, b), std::max(a, b)};
  }
  return result;
}

}  // namespace orthoball
