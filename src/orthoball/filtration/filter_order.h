// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/ranked_bits.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// All simplices by the index at which they enter, then number, made of the order of those that
/// are not attached: `filter`, as long as there are simplices, is filled.
///
/// Linear; 6 bytes of transient memory for an attached simplex.
///
/// An attached simplex is a face of an unattached one that enters with it, so it has a smaller
/// number where that is the only one.
///
/// @param order        the unattached simplices by value, then number, as value_ranks leaves them.
/// @param starts       places in `order` where an index starts
/// @param enters       [simplex]: its index
/// @param is_attached  a bit for every simplex, 64 to a word, none beyond.
/// @return a bit for every place of `filter`, and one beyond, set where an index starts and beyond.
[[nodiscard]] std::vector<std::uint64_t> fill_filter(std::span<const SimplexId> order,
                                                     const RankedBits& starts,
                                                     std::span<const std::uint32_t> enters,
                                                     std::span<const std::uint64_t> is_attached,
                                                     Threads threads, std::span<SimplexId> filter);

}  // namespace orthoball
