// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "orthoball/exact/corner_block.h"

namespace orthoball {

/// What labels of one set of sites have in common.
struct LabelUnit {
  std::array<double, 2> divisor;   ///< 10^(2 decimals), as the sum of two
  double scale = 1.0;              ///< 2^(-2 scale_exponent), a normal number
  double weights_are_pairs = 0.0;  ///< 1 where differences of weights are rounded, else 0
};

/// The squared orthoradii of a block's simplices in input units, `labels[i]` correctly rounded; NaN
/// where the error bound leaves two candidates, a simplex is outside the range of the bounds, or
/// not all differences of its coordinates are doubles. Vector instructions where the machine has
/// them; the same numbers everywhere.
template <int D, std::size_t Corners>
void certified_labels(const CornerBlock<D, Corners>& block, const LabelUnit& unit,
                      std::span<double, CornerBlock<D, Corners>::kSize> labels);

/// The same of the first simplex of a block alone, whose differences need not be doubles.
template <int D, std::size_t Corners>
[[nodiscard]] double certified_label_of_one(const CornerBlock<D, Corners>& block,
                                            const LabelUnit& unit);

/// A number known to lie in [least, most].
struct Bounds {
  double least;
  double most;
};

/// What rounding took from `label`, the correctly rounded squared orthoradius of the first simplex
/// of a block: that value less the label, both over `unit.scale`. Unbounded where the simplex or
/// the label is outside the range of the bounds.
template <int D, std::size_t Corners>
[[nodiscard]] Bounds label_remainder_of_one(const CornerBlock<D, Corners>& block,
                                            const LabelUnit& unit, double label);

}  // namespace orthoball
