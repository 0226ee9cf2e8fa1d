// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

namespace orthoball {

/// body(0), body(1), ... body(Size - 1), written out: what stands in a loop to be vectorized must
/// have none of its own.
template <std::size_t Size, class Body>
[[gnu::always_inline]] constexpr void unrolled(const Body& body) {
  [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    (body(I), ...);
  }
  (std::make_index_sequence<Size>());
}

}  // namespace orthoball
