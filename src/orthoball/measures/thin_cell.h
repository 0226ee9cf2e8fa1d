// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "orthoball/exact/sites.h"

namespace orthoball {

/// A facet is thin where its doubled area is below this times the product of two of its edges: the
/// rounding of the cross product then turns its normal by up to 4 * 2^-53 / kThin = 2e-12.
inline constexpr double kThin = 0x1p-12;

/// The measures of a cell in space whose facets are thin, or whose coordinates differ too much in
/// size for doubles. All products are exact integers; only roots, angles and their sums are
/// rounded.
struct ThinCell {
  double volume;  ///< 6 volumes
  double length;  ///< sum over its edges of length x exterior angle
};

/// In units of 2^exponent lengths of ExactSite. Slow: about a microsecond.
[[nodiscard]] ThinCell thin_cell(const Sites<3>& sites, const std::array<std::uint32_t, 4>& corners,
                                 int exponent);

}  // namespace orthoball
