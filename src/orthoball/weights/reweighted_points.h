// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "orthoball/ids.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// A row and the weight that it gets, in the unit of the points' arrays squared.
struct NewWeight {
  SiteId row;
  double weight;
};

/// Points with some weights replaced; all other numbers are exactly what they were.
///
/// Decimal fixed point stays so, in units of at most `more` decimals more, as 2^53 and 106 bits
/// allow; weights, radii among them, become weights there. Doubles stay doubles; radii stay radii
/// there, the signed root of the new weight being rounded. New weights are rounded to the nearest
/// such number.
/// @throws LimitError for a weight beyond 106 bits or the range of doubles.
[[nodiscard]] WeightedPoints reweighted(const WeightedPoints& points, int more,
                                        std::span<const NewWeight> weights);

/// How many decimals more make weights multiples of at most `step` (in the unit of the points'
/// arrays squared); 0 for doubles.
[[nodiscard]] int decimals_for(const WeightedPoints& points, double step);

/// Points with more rows behind theirs, which have the weight 0. `more` as above.
/// @param positions  in the unit of the points' arrays; rounded to the nearest numbers.
[[nodiscard]] WeightedPoints with_more_rows(const WeightedPoints& points, int more,
                                            std::span<const std::array<double, 3>> positions);

}  // namespace orthoball
