// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// A part of the sites, drawn at random without putting any back: `share` of them, rounded up, in
/// the order of their rows, with numbers as exact as they were. Which are drawn depends on the
/// sites and the seed alone, not on the order of rows, and is the same on every machine.
/// @param share  in (0, 1].
/// @throws InputError for another share.
[[nodiscard]] WeightedPoints subsample(const WeightedPoints& points, double share,
                                       std::uint64_t seed);

}  // namespace orthoball
