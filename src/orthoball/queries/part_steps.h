// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "orthoball/queries/star_parts.h"

namespace orthoball {

/// Cells around one vertex that could change sides together, to make the parts there fewer.
struct PartStep {
  double cost = 0.0;                 ///< the volume of the cells
  std::vector<std::uint32_t> cells;  ///< ascending
};

/// Of every part of a side that has several: the whole of it, but for that which has the outside,
/// and the cheapest path through cells of the other side to another part of its side. The cheapest
/// first, then the fewest cells.
///
/// All paths are found at once, in the time of sorting the cells around the vertex: from where the
/// cells that are nearest to one part meet those of another.
/// @param stars   a vertex has been read.
/// @param cells   the cells around it.
/// @param volume  of a cell.
template <int D>
[[nodiscard]] std::vector<PartStep> part_steps(const StarParts<D>& stars,
                                               std::span<const std::uint32_t> cells,
                                               const std::function<double(std::uint32_t)>& volume);

extern template std::vector<PartStep> part_steps(
    const StarParts<2>&, std::span<const std::uint32_t>,
    const std::function<double(std::uint32_t)>&);  // in part_steps.cpp
extern template std::vector<PartStep> part_steps(const StarParts<3>&,
                                                 std::span<const std::uint32_t>,
                                                 const std::function<double(std::uint32_t)>&);

}  // namespace orthoball
