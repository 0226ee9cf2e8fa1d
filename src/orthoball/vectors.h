// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace orthoball {

// Points and vectors as doubles, rounded; any unit of length.

/// a - b
template <std::size_t N>
[[nodiscard]] std::array<double, N> difference(std::array<double, N> a,
                                               const std::array<double, N>& b) {
  for (std::size_t i = 0; i < N; ++i) a[i] -= b[i];
  return a;
}

/// The inner product.
template <std::size_t N>
[[nodiscard]] double inner(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// a x b, right-handed.
[[nodiscard]] inline std::array<double, 3> cross_product(const std::array<double, 3>& a,
                                                         const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace orthoball
