// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/ranked_bits.h"
#include "orthoball/filtration/simplex_table.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The exactly distinct squared orthoradii of the simplices that are not attached, in order.
struct ValueRanks {
  RawVector<double> spectrum;  ///< [rank - 1]: correctly rounded, length^2 of input
  RankedBits starts;           ///< places in the order of values where a rank starts
};

/// Exact; the labels only are rounded. Linear but for sorting within runs of equal labels; 12 bytes
/// of transient memory for each unattached simplex, 24 more where many different values share a
/// label.
///
/// @param is_attached  a bit for every simplex, 64 to a word.
/// @param order        filled with the simplices that are not attached, as many as there are, by
///                     value.
template <int D>
[[nodiscard]] ValueRanks value_ranks(const RegularTriangulation<D>& triangulation,
                                     const SimplexTable<D>& table,
                                     std::span<const std::uint64_t> is_attached,
                                     std::span<SimplexId> order, Threads threads);

/// Writes the rank of each simplex of the order, from 1, to [simplex].
void deal_ranks(std::span<const SimplexId> order, const RankedBits& starts,
                std::span<std::uint32_t> ranks, Threads threads);

extern template ValueRanks value_ranks<2>(const RegularTriangulation<2>&, const SimplexTable<2>&,
                                          std::span<const std::uint64_t>, std::span<SimplexId>,
                                          Threads);
extern template ValueRanks value_ranks<3>(const RegularTriangulation<3>&, const SimplexTable<3>&,
                                          std::span<const std::uint64_t>, std::span<SimplexId>,
                                          Threads);

}  // namespace orthoball
