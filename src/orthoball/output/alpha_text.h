// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "orthoball/output/byte_sink.h"

namespace orthoball {

/// Whether `alpha2` is that of index 0 itself, the empty complex: -infinity. No other is.
[[nodiscard]] inline bool is_of_empty_complex(double alpha2) {
  return std::isinf(alpha2) && alpha2 < 0.0;
}

/// Which complex it is, for titles and comments: "alpha2 2.5, index 7".
[[nodiscard]] inline std::string alpha_text(double alpha2, std::uint32_t index) {
  if (is_of_empty_complex(alpha2)) return "index 0, the empty complex";
  const std::string number = std::isfinite(alpha2) ? shortest_text(alpha2) : "beyond double range";
  return "alpha2 " + number + ", index " + std::to_string(index);
}

}  // namespace orthoball
