// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/contributions.h"
#include "orthoball/measures/input_units.h"

namespace orthoball {

/// The units in which a filtration is to be measured, the preferred first: one, or two.
///
/// One is that of the double stages of Sites, in which nothing leaves the double range. Where it is
/// so much coarser than input units, or the sites so close, that values of a double's range would
/// vanish, input units come first: sums in these serve as long as no term is too large, after that
/// the others do, for then what they lack is far below the last bit.
template <int D>
[[nodiscard]] std::vector<Contributions<D>> contributions_of(const Filtration<D>& filtration,
                                                             std::span<const std::uint8_t> roles);

/// From the units of `contributions` to input units.
/// @param power    1 for lengths, 2 for areas, 3 for volumes.
/// @param divisor  the values are this many times too large.
template <int D>
[[nodiscard]] InputUnits input_units(const Filtration<D>& filtration,
                                     const Contributions<D>& contributions, int power, int divisor);

/// n!
[[nodiscard]] constexpr int factorial(int n) { return n <= 1 ? 1 : n * factorial(n - 1); }

}  // namespace orthoball
