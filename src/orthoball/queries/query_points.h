// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "orthoball/error.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// Refuses points that are asked about in a space of another dimension.
/// @throws InputError
inline void require_dimension(const WeightedPoints& points, int dimension) {
  if (points.dimension() == dimension) return;
  throw InputError(InputError::Reason::wrong_size, InputError::kNoRow,
                   "the points have " + std::to_string(points.dimension()) +
                       " coordinates; they must have " + std::to_string(dimension) +
                       ", as the sites do");
}

}  // namespace orthoball
