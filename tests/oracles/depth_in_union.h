// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace orthoball::oracles {

/// A ball in space.
struct SolidBall {
  std::array<double, 3> centre{};
  double radius = 0.0;
};

/// How far a point is from the nearest point outside all balls; 0 outside. By trying all spheres,
/// circles of two and points of three: O(n^4).
[[nodiscard]] double depth_in_union(const std::vector<SolidBall>& balls,
                                    const std::array<double, 3>& point);

}  // namespace orthoball::oracles
