// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace orthoball {

/// The signed root of alpha2: sign(alpha2) sqrt|alpha2|, a length. Correctly rounded; for people,
/// everything inside is in alpha2.
[[nodiscard]] inline double alpha_from_alpha2(double alpha2) {
  return std::copysign(std::sqrt(std::abs(alpha2)), alpha2);
}

}  // namespace orthoball
