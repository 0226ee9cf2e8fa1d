// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "orthoball/exact/perturbation.h"
#include "orthoball/triangulation/cell_store.h"

namespace orthoball {

/// Whether a site invalidates a cell. Exact, ties decided by perturbation.
///
/// A cell at infinity is in conflict with what is strictly beyond its hull facet, or in the plane
/// of the facet and in conflict within it. There the finite cell behind the facet answers: its
/// orthosphere cuts the plane in the facet's.
template <int A, int D>
[[nodiscard]] inline bool in_conflict(const CellStore<A>& cells, const Sites<D>& sites,
                                      std::uint32_t cell, std::uint32_t site) {
  const CellRecord<A>& record = cells[cell];
  const std::size_t infinite = cells.corner_at_infinity(record);
  if (infinite > A) return in_conflict<A, D>(sites, record.corners, site);
  Corners<A> corners = record.corners;
  corners[infinite] = site;
  const Sign side = orient<A, D>(sites, corners);
  if (side != Sign::zero) return side == Sign::positive;
  const std::uint32_t inside = record.neighbours[infinite] / 4;
  return in_conflict<A, D>(sites, cells[inside].corners, site);
}

}  // namespace orthoball
