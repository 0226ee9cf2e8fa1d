// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "orthoball/exact/orient.h"
#include "orthoball/triangulation/cell_store.h"

namespace orthoball {

/// The cell that contains a site, by a walk: cross any facet that has the site strictly beyond it.
///
/// In a regular triangulation such a walk cannot return to a cell, so it ends: in a finite cell
/// that contains the site (boundary included), or at infinity behind a hull facet that has the site
/// strictly beyond it.  @cite devillers_pion_teillaud_2002
/// @param start  a finite cell or a cell at infinity.
template <int A, int D>
[[nodiscard]] inline std::uint32_t locate(const CellStore<A>& cells, const Sites<D>& sites,
                                          std::uint32_t site, std::uint32_t start) {
  std::uint32_t cell = start;
  std::size_t entered = cells.corner_at_infinity(cells[cell]);  // facet not to be tested
  if (entered <= A) {
    const std::uint32_t inside = cells[cell].neighbours[entered];
    cell = inside / 4;
    entered = A + 1;
  }
  for (;;) {
    const auto& record = cells[cell];
    std::uint32_t next = kOutside;
    for (std::size_t i = 0; i <= A; ++i) {
      if (i == entered) continue;
      Corners<A> corners = record.corners;
      corners[i] = site;
      if (orient<A, D>(sites, corners) == Sign::negative) {
        next = record.neighbours[i];
        break;
      }
    }
    if (next == kOutside) return cell;
    cell = next / 4;
    if (!cells.is_finite(cells[cell])) return cell;
    entered = next % 4;
  }
}

}  // namespace orthoball
