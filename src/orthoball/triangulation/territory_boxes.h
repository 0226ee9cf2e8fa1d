// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/exact/sites.h"
#include "orthoball/triangulation/territory.h"

namespace orthoball {

/// Disjoint boxes that together are all of space and have about as many of some sites each, with
/// borders where these are sparse: of sites that lie along the borders of other territories, most
/// are then far from the new ones.
/// @param sites    ascending by number.
/// @param count    how many boxes are wanted; there are fewer if the sites are few.
template <int D>
[[nodiscard]] std::vector<Box<D>> territory_boxes(const Sites<D>& all,
                                                  std::span<const std::uint32_t> sites,
                                                  std::size_t count);

extern template std::vector<Box<2>> territory_boxes<2>(const Sites<2>&,
                                                       std::span<const std::uint32_t>, std::size_t);
extern template std::vector<Box<3>> territory_boxes<3>(const Sites<3>&,
                                                       std::span<const std::uint32_t>, std::size_t);

}  // namespace orthoball
