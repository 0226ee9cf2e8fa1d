// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// The first index, not below `from`, that `may_be` allows and at which the boundary of the cells
/// of the complex is a closed manifold at every vertex; none where that never happens. Exact.
///
/// Cells are added one after the other, and of the cells around their vertices the parts are kept
/// (StarParts).
/// @param may_be  [index], 0..s.
template <int D>
[[nodiscard]] std::optional<std::uint32_t> first_manifold(const Filtration<D>& filtration,
                                                          std::uint32_t from,
                                                          const std::vector<bool>& may_be);

extern template std::optional<std::uint32_t> first_manifold<2>(
    const Filtration<2>&, std::uint32_t, const std::vector<bool>&);  // in first_manifold.cpp
extern template std::optional<std::uint32_t> first_manifold<3>(const Filtration<3>&, std::uint32_t,
                                                               const std::vector<bool>&);

}  // namespace orthoball
