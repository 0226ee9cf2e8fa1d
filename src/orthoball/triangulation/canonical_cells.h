// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/exact/sites.h"
#include "orthoball/triangulation/cell_store.h"

namespace orthoball {

/// The finite cells of a finished triangulation in the one order and numbering that depends on the
/// triangulation alone: vertices less the hidden ones, cells ascending by their ascending corners,
/// corners as CellRecord says. Neighbours in space become neighbours in memory. O(n) time.
///
/// Frees `cells` on the way.
template <int A, int D>
[[nodiscard]] std::vector<CellRecord<A>> canonical_cells(CellStore<A> cells, const Sites<D>& sites,
                                                         const std::vector<bool>& is_hidden) {
  constexpr std::size_t kCorners = A + 1;
  const auto vertices = static_cast<std::uint32_t>(sites.size());
  const auto old_cells = static_cast<std::uint32_t>(cells.size());

  // Number the vertices that are left; write them into the old cells in ascending order, noting for
  // each old corner where it went (2 bits a corner) and whether the order is an odd one.
  std::vector<std::uint32_t> number_of(vertices + std::size_t{1}, 0);
  for (std::uint32_t site = 0, next = 0; site < vertices; ++site) {
    if (!is_hidden[site]) number_of[site] = next++;
  }
  std::vector<std::uint8_t> place_of(old_cells, 0);
  std::vector<std::uint32_t> first_with(vertices + std::size_t{1}, 0);  // cells by smallest corner
  const auto is_kept = [&](std::uint32_t cell) {
    return cells.is_alive(cell) && cells.is_finite(cells[cell]);
  };
  std::vector<bool> kept(old_cells);
  for (std::uint32_t cell = 0; cell < old_cells; ++cell) {
    kept[cell] = is_kept(cell);
    if (!kept[cell]) continue;
    auto& corners = cells[cell].corners;
    std::array<std::uint32_t, kCorners> old = corners;
    std::array<std::uint8_t, kCorners> order;
    bool odd = false;
    for (std::size_t i = 0; i < kCorners; ++i) {  // insertion sort, counting exchanges
      const std::uint32_t vertex = number_of[old[i]];
      std::size_t at = i;
      for (; at > 0 && corners[at - 1] > vertex; --at) {
        corners[at] = corners[at - 1];
        order[at] = order[at - 1];
        odd = !odd;
      }
      corners[at] = vertex;
      order[at] = static_cast<std::uint8_t>(i);
    }
    ++first_with[corners[0] + 1];
    if (A == D && odd) {
      std::swap(corners[A - 1], corners[A]);
      std::swap(order[A - 1], order[A]);
    }
    unsigned places = 0;
    for (unsigned i = 0; i < kCorners; ++i) places |= i << (2U * order[i]);
    place_of[cell] = static_cast<std::uint8_t>(places);
  }

  // Cells by smallest corner, then by all corners.
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
    first_with[vertex + 1] += first_with[vertex];
  const std::vector<std::uint32_t> begin_with = first_with;
  std::vector<std::uint32_t> ordered(first_with[vertices]);  // [new cell] old cell
  for (std::uint32_t cell = 0; cell < old_cells; ++cell) {
    if (kept[cell]) ordered[first_with[cells[cell].corners[0]]++] = cell;
  }
  const auto ascending = [&](std::uint32_t cell) {
    auto corners = cells[cell].corners;
    if (corners[A - 1] > corners[A]) std::swap(corners[A - 1], corners[A]);
    return corners;
  };
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    std::sort(ordered.begin() + begin_with[vertex], ordered.begin() + begin_with[vertex + 1],
              [&](std::uint32_t a, std::uint32_t b) { return ascending(a) < ascending(b); });
  }

  std::vector<std::uint32_t> new_cell(old_cells, kOutside);
  for (std::uint32_t cell = 0; cell < ordered.size(); ++cell) new_cell[ordered[cell]] = cell;
  std::vector<CellRecord<A>> result(ordered.size());
  for (std::size_t cell = 0; cell < ordered.size(); ++cell) {
    const auto& old = cells[ordered[cell]];
    const unsigned places = place_of[ordered[cell]];
    result[cell].corners = old.corners;
    for (unsigned i = 0; i < kCorners; ++i) {
      const std::uint32_t old_beyond = old.neighbours[i] / 4;
      const std::uint32_t old_corner = old.neighbours[i] % 4;
      const std::uint32_t beyond = new_cell[old_beyond];
      const unsigned corner = unsigned{place_of[old_beyond]} >> (2U * old_corner) & 3U;
      result[cell].neighbours[places >> (2U * i) & 3U] =
          beyond == kOutside ? kOutside : 4 * beyond + corner;
    }
  }
  return result;
}

}  // namespace orthoball
