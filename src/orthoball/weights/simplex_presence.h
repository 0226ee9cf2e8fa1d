// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"

namespace orthoball {

/// The input rows of the corners of one simplex, ascending: 1 to D + 1 of them.
using SimplexRows = std::vector<SiteId>;

/// [simplex]: whether the alpha complex K_index has the simplex, be it as the face of a larger one.
/// Exact. A row that is a duplicate stands for its representative; a hidden row is in no simplex.
/// O(simplices of the filtration).
template <int D>
[[nodiscard]] std::vector<bool> are_present(const Filtration<D>& filtration, std::uint32_t index,
                                            std::span<const SimplexRows> simplices);

extern template std::vector<bool> are_present<2>(const Filtration<2>&, std::uint32_t,
                                                 std::span<const SimplexRows>);
extern template std::vector<bool> are_present<3>(const Filtration<3>&, std::uint32_t,
                                                 std::span<const SimplexRows>);

}  // namespace orthoball
