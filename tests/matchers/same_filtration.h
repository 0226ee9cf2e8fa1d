// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "matchers/describe.h"
#include "orthoball/filtration/filtration.h"

namespace orthoball::matchers {

/// Where two filtrations differ as numbers in memory, vertices by number, labels put aside.
template <int D>
[[nodiscard]] std::vector<std::string> order_faults(const Filtration<D>& a,
                                                    const Filtration<D>& b) {
  std::vector<std::string> found;
  Comparison compare(found);
  compare("size", a.size(), b.size());
  compare("spectrum size", a.spectrum_size(), b.spectrum_size());
  if (!found.empty()) return found;
  for (std::uint32_t row = 0; row < a.size(); ++row) {
    const SimplexId simplex(row);
    const auto vertices_a = a.vertices(simplex), vertices_b = b.vertices(simplex);
    compare("same vertices",
            std::equal(vertices_a.begin(), vertices_a.end(), vertices_b.begin(), vertices_b.end()),
            true);
    compare("attached", a.is_attached(simplex), b.is_attached(simplex));
    compare("enters", a.enters(simplex), b.enters(simplex));
    compare("regular", a.regular(simplex), b.regular(simplex));
    compare("interior", a.interior(simplex), b.interior(simplex));
    if (!found.empty()) break;
  }
  return found;
}

}  // namespace orthoball::matchers
