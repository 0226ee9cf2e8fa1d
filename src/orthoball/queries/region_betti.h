// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"

namespace orthoball {

/// [region][k]: the Betti numbers of each of some regions alone; 0 from the dimension of space on.
/// Exact.
///
/// Linear in the simplices of the regions and the cells around them.
/// @param regions  [region]: all simplices of a connected complex, faces included; not empty.
/// @cite delfinado_edelsbrunner_1995
template <int D>
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> region_betti(
    const Filtration<D>& filtration, std::span<const std::vector<SimplexId>> regions);

extern template std::vector<std::array<std::uint32_t, 3>> region_betti<2>(
    const Filtration<2>&, std::span<const std::vector<SimplexId>>);  // in region_betti.cpp
extern template std::vector<std::array<std::uint32_t, 3>> region_betti<3>(
    const Filtration<3>&, std::span<const std::vector<SimplexId>>);

}  // namespace orthoball
