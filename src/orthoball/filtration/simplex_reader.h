// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/exact/orthoradius.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/filtration/simplex_table.h"

namespace orthoball {

/// The corners of simplices of a triangulation of A-dimensional cells.
template <int D, int A>
struct SimplexReader {
  std::span<const CellRecord<A>> cells;  ///< of the triangulation
  const SimplexTable<D>& table;

  /// Of a simplex of dimension K by its number among these, in any order.
  template <int K>
  [[nodiscard]] CornerSites<std::size_t{K} + 1> corners(std::uint32_t number) const {
    CornerSites<std::size_t{K} + 1> result;
    if constexpr (K == 0) {
      result[0] = number;
    } else if constexpr (K == A) {
      result = cells[number].corners;
    } else if constexpr (K == A - 1) {
      const std::uint32_t owner = table.facet_owners()[number];
      for (unsigned i = 0; i <= K; ++i) {
        result[i] = cells[owner / 4].corners[i + (i >= owner % 4 ? 1 : 0)];
      }
    } else {
      const std::uint32_t owner = table.edge_owners()[number];
      const auto [i, j] = kEdgeCorners[owner % 6];
      result = {cells[owner / 6].corners[i], cells[owner / 6].corners[j]};
    }
    return result;
  }
};

}  // namespace orthoball
