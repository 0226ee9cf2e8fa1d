// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The corners of a tetrahedron's six edges, by slot. Slot 5 - s is the edge opposite slot s.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> kEdgeCorners{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// [corner][corner]: the slot of the edge between two different corners of a tetrahedron.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> kEdgeSlot{
    {{6, 0, 1, 2}, {0, 6, 3, 4}, {1, 3, 6, 5}, {2, 4, 5, 6}}};

/// Calls `visit(cell, slot)` once for every tetrahedron around the edge in `slot` of `start`, with
/// the edge's slot there: `start` first, then the ring in one direction, and where that ends at the
/// hull, the rest in the other. Linear in the cells around the edge.
template <class Visit>
void for_each_around_edge(std::span<const CellRecord<3>> cells, std::uint32_t start, unsigned slot,
                          const Visit& visit) {
  visit(start, slot);
  for (unsigned direction = 0; direction < 2; ++direction) {
    // The cell at hand has the edge and two more corners: the one behind, which the last step came
    // across, and the one ahead, opposite the facet that the next step crosses.
    std::uint32_t cell = start;
    unsigned ahead = kEdgeCorners[5 - slot][direction];
    unsigned behind = kEdgeCorners[5 - slot][1 - direction];
    while (true) {
      const std::uint32_t kept = cells[cell].corners[behind];
      const std::uint32_t beyond = cells[cell].neighbours[ahead];
      if (beyond == kOutside) break;
      cell = beyond / 4;
      if (cell == start) return;
      behind = beyond % 4;
      const auto& corners = cells[cell].corners;
      ahead = corners[0] == kept ? 0U : corners[1] == kept ? 1U : corners[2] == kept ? 2U : 3U;
      visit(cell, 5U - kEdgeSlot[ahead][behind]);
    }
  }
}

}  // namespace orthoball
