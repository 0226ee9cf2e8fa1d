// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "orthoball/filtration/filtration.h"
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

/// The alphas of some points, for who asks for one that they do not have: "the first simplex enters
/// at alpha2 0, the last at 12.5; in one piece at 2; solid at 3".
template <int D>
[[nodiscard]] std::string scale_text(const Filtration<D>& filtration);

extern template std::string scale_text(const Filtration<2>&);  // in alpha_text.cpp
extern template std::string scale_text(const Filtration<3>&);

}  // namespace orthoball
