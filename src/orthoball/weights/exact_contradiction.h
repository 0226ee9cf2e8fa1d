// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "orthoball/weights/witness_program.h"

namespace orthoball {

/// Numbers of simplices, ascending, that no weights hold together: proved, for some of the
/// conditions on them sum up to 0 >= something positive, in exact numbers, whatever the weights and
/// witnesses. Empty where the sum of these conditions, or one near to it, proves nothing.
///
/// @param conditions  with factors in doubles, as WitnessProgram::contradiction() tells them; exact
///                    factors are looked for close to these. Their time grows with the cube of
///                    their number.
template <int D>
[[nodiscard]] std::vector<std::size_t> exact_contradiction(
    const DistinctSites<D>& sites, std::span<const SiteTuple> simplices,
    std::span<const WitnessCondition> conditions);

extern template std::vector<std::size_t> exact_contradiction<2>(const DistinctSites<2>&,
                                                                std::span<const SiteTuple>,
                                                                std::span<const WitnessCondition>);
extern template std::vector<std::size_t> exact_contradiction<3>(const DistinctSites<3>&,
                                                                std::span<const SiteTuple>,
                                                                std::span<const WitnessCondition>);

}  // namespace orthoball
