// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "orthoball/output/byte_sink.h"

namespace orthoball {

/// Whether `index`, with alpha2 or alpha `number`, stands for the empty complex as such: index 0
/// with -infinity. Another number at index 0 was asked for; -infinity at another index is a number
/// below the range of doubles.
[[nodiscard]] inline bool is_of_empty_complex(std::uint32_t index, double number) {
  return index == 0 && std::isinf(number) && number < 0.0;
}

/// Which complex it is, for titles and comments: "alpha2 2.5, index 7".
[[nodiscard]] inline std::string alpha_text(double alpha2, std::uint32_t index) {
  if (is_of_empty_complex(index, alpha2)) return "index 0, the empty complex";
  const std::string number = std::isfinite(alpha2) ? shortest_text(alpha2) : "beyond double range";
  return "alpha2 " + number + ", index " + std::to_string(index);
}

}  // namespace orthoball
