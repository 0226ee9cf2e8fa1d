// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "python/arrays.h"

/// (k, corners) the rows of simplices of one dimension.
/// @param width  the number of corners where there are no simplices to tell it.
template <int D>
[[nodiscard]] Array<std::uint32_t> rows_of(const orthoball::Filtration<D>& filtration,
                                           const std::vector<orthoball::SimplexId>& simplices,
                                           std::size_t width) {
  std::vector<orthoball::SiteId> rows;
  for (const orthoball::SimplexId simplex : simplices) {
    const auto of_one = filtration.rows(simplex);
    rows.insert(rows.end(), of_one.begin(), of_one.end());
  }
  if (!simplices.empty()) width = rows.size() / simplices.size();
  return owned<std::uint32_t>(std::move(rows), {simplices.size(), width});
}
