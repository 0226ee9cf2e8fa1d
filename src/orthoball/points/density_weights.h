// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// The sites of `points` with weights from their density, instead of those they have: large where
/// they are sparse, small where they are dense, so that one alpha2 serves them all. With d_1 <= ...
/// <= d_K the distances from site i to the K nearest other positions
///
///     w_i = (d_1^2 + ... + d_K^2) / (2 K),
///
/// half the mean square distance. It is free of scale: lengths times s make weights times s^2, so
/// the shape at alpha2 = 0 does not depend on the unit. Rows at one position count once and have
/// one weight.
///
/// No site is hidden by such weights: |x|^2 - w(x), with w the formula for any x (x itself at
/// distance 0 among K + 1), is the largest of convex functions, so no lifted site lies above the
/// others. With d_K^2 alone in the place of the mean that is not so. (Of two sites nearer than some
/// 10^-7 of the root of their weights, the rounding below can still hide one.)
///
/// Decimal fixed point stays so: coordinates as they are, weights rounded to integers in units of
/// two decimals more than the coordinates have (fewer where 2^53 leaves less). Otherwise weights
/// are doubles. Before that rounding they are off by less than (K + 8) 2^-53 of themselves. The
/// same for any order of rows and number of threads.
///
/// O(n K log n) time for points that are not made to be hard.
/// @param neighbours  K, at least 1.
/// @throws InputError for K = 0; unless there are more than K positions (or no site at all); for a
///         weight outside the range of normal doubles, naming the row.
/// @cite chazal_cohen_steiner_merigot_2011  @cite akkiraju_1995_alpha
[[nodiscard]] WeightedPoints with_density_weights(const WeightedPoints& points,
                                                  std::size_t neighbours, Threads threads = {});

/// Bytes that with_density_weights takes beyond the points it is given and gives.
[[nodiscard]] std::size_t density_weights_memory(int dimension, std::size_t sites);

}  // namespace orthoball
