// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/exact/sites.h"

namespace orthoball {

/// Affinely independent sites that span all others, and axes on which they are still independent.
///
/// The axes come in their own order: first the lexicographically first set of them that separates
/// the sites of the span, then the others. So the order of positions is the same on the permuted
/// axes.
template <int D>
struct AffineBasis {
  std::vector<std::uint32_t> sites;        ///< affine dimension + 1; none without sites
  std::array<int, std::size_t{D}> axes{};  ///< a permutation of 0..D-1

  [[nodiscard]] int affine_dimension() const { return static_cast<int>(sites.size()) - 1; }
};

/// The basis whose sites come first in `order`. Exact; linear time, and near constant where the
/// first sites are independent.
template <int D>
[[nodiscard]] AffineBasis<D> affine_basis(const Sites<D>& sites,
                                          std::span<const std::uint32_t> order);

}  // namespace orthoball
