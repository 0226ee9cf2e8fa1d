// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "orthoball/exact/orient.h"

namespace orthoball {

/// Power sides of one query to several simplices, as far as a glance tells: a bit for each simplex,
/// in at most one of the masks.
struct GlancedSides {
  std::uint32_t positive = 0;
  std::uint32_t negative = 0;
  std::uint32_t zero = 0;  ///< a tie: told where numbers are small integers
};

/// Whether glanced_power_sides_across tells anything: where the processor has vectors of four
/// doubles.
[[nodiscard]] bool can_glance_across();

/// The power sides of `query` to all neighbours of a positively oriented simplex: bit i is for the
/// neighbour across the facet opposite corner i, whose own corner off that facet is apexes[i]. What
/// is told is exact; little is left open on sites in general position. Costs less than two calls of
/// power_side. Call it only if can_glance_across().
[[nodiscard]] GlancedSides glanced_power_sides_across(const Sites<3>& sites,
                                                      const Corners<3>& corners,
                                                      const Corners<3>& apexes,
                                                      std::uint32_t query);
[[nodiscard]] GlancedSides glanced_power_sides_across(const Sites<2>& sites,
                                                      const Corners<2>& corners,
                                                      const Corners<2>& apexes,
                                                      std::uint32_t query);

/// Nothing is known where sites do not span their space.
template <std::size_t Size, int D>
[[nodiscard]] GlancedSides glanced_power_sides_across(const Sites<D>&,
                                                      const std::array<std::uint32_t, Size>&,
                                                      const std::array<std::uint32_t, Size>&,
                                                      std::uint32_t) {
  return {};
}

}  // namespace orthoball
