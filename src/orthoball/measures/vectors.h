// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace orthoball {

// Points and vectors in space as three doubles, rounded; any unit of length.

/// a - b
[[nodiscard]] inline std::array<double, 3> difference(const std::array<double, 3>& a,
                                                      const std::array<double, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The inner product.
[[nodiscard]] inline double inner(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a x b, right-handed.
[[nodiscard]] inline std::array<double, 3> cross_product(const std::array<double, 3>& a,
                                                         const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace orthoball
