// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "orthoball/points/weighted_points.h"
#include "orthoball/weights/enforced_weights.h"

namespace orthoball::matchers {

// A simplex by its rows.
inline SimplexRows simplex(std::initializer_list<std::uint32_t> rows) {
  SimplexRows ids;
  for (const std::uint32_t row : rows) ids.emplace_back(row);
  return ids;
}

// Points of the plane in tenths, without weights.
inline WeightedPoints plane(std::vector<double> coordinates) {
  return WeightedPoints::fixed_point(2, 1, std::move(coordinates), WeightKind::none, {});
}

}  // namespace orthoball::matchers
