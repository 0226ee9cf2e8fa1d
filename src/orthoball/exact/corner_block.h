// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/exact/sites.h"

namespace orthoball {

/// A simplex by the inside numbers of its vertices, which are affinely independent, in any order.
template <std::size_t Corners>
using CornerSites = std::array<std::uint32_t, Corners>;

/// Many simplices' corners, one array a number, for loops that become vector instructions.
template <int D, std::size_t Corners>
struct CornerBlock {
  static constexpr std::size_t kSize = 64;
  std::array<std::array<std::array<double, kSize>, std::size_t{D}>, Corners>
      x;                                                      ///< [corner][axis][simplex]
  std::array<std::array<double, kSize>, Corners> weight;      ///< [corner][simplex]
  std::array<std::array<double, kSize>, Corners> weight_low;  ///< 0 where weights are doubles
};

/// Puts the sites of at most kSize simplices into a block, as `sites[i]` has them; `weight_low` is
/// left as it is. 2 to D + 1 corners.
template <int D, std::size_t Corners>
void load_corners(const Sites<D>& sites, std::span<const CornerSites<Corners>> simplices,
                  CornerBlock<D, Corners>& block);

}  // namespace orthoball
