// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "orthoball/filtration/simplex_table.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The exactly distinct squared orthoradii of the simplices that are not attached, in order.
struct ValueRanks {
  std::vector<double> spectrum;       ///< [rank - 1]: correctly rounded, length^2 of input
  std::vector<std::uint32_t> enters;  ///< [simplex]: rank from 1; 0 where it is attached
};

/// Exact; the labels only are rounded. Linear but for sorting within runs of equal labels; 12 bytes
/// of transient memory for each unattached simplex, 24 more where many different values share a
/// label.
template <int D>
[[nodiscard]] ValueRanks value_ranks(const RegularTriangulation<D>& triangulation,
                                     const SimplexTable<D>& table,
                                     const std::vector<bool>& is_attached);

extern template ValueRanks value_ranks<2>(const RegularTriangulation<2>&, const SimplexTable<2>&,
                                          const std::vector<bool>&);
extern template ValueRanks value_ranks<3>(const RegularTriangulation<3>&, const SimplexTable<3>&,
                                          const std::vector<bool>&);

}  // namespace orthoball
