// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace orthoball {

/// Where elements go that several parts have counted, each its own, and will deal to groups: those
/// of a group stand one part after the other, so they keep their order.
/// @param next    [part][group]: how many elements; becomes where the part's first one goes.
/// @param begins  [group]: set to where the group begins; one more, to where the last one ends.
inline void find_places_of_parts(std::span<std::vector<std::uint32_t>> next,
                                 std::span<std::uint32_t> begins) {
  std::uint32_t sum = 0;
  for (std::size_t group = 0; group + 1 < begins.size(); ++group) {
    begins[group] = sum;
    for (auto& of_part : next) sum += std::exchange(of_part[group], sum);
  }
  begins.back() = sum;
}

}  // namespace orthoball
