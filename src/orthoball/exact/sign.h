// SPDX-License-Identifier: MIT
#pragma once

namespace orthoball {

/// The sign of an exact number, the answer of every predicate.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

[[nodiscard]] constexpr Sign operator-(Sign sign) {
  return static_cast<Sign>(-static_cast<signed char>(sign));
}
[[nodiscard]] constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<signed char>(a) * static_cast<signed char>(b));
}

}  // namespace orthoball
