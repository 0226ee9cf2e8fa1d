// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "orthoball/filtration/simplex_table.h"
#include "orthoball/parallel.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// For each simplex that is not attached, how many of some values are less than the label of its
/// squared orthoradius, and one more: the first of them, from 1, at which it is there. Linear.
///
/// @param is_attached  a bit for every simplex, 64 to a word.
/// @param values       ascending, length^2 in input units.
/// @param ranks        [simplex]; those of attached simplices are left as they are.
template <int D>
void ranks_among(std::span<const double> values, const RegularTriangulation<D>& triangulation,
                 const SimplexTable<D>& table, std::span<const std::uint64_t> is_attached,
                 std::span<std::uint32_t> ranks, Threads threads);

extern template void ranks_among<2>(std::span<const double>, const RegularTriangulation<2>&,
                                    const SimplexTable<2>&, std::span<const std::uint64_t>,
                                    std::span<std::uint32_t>, Threads);
extern template void ranks_among<3>(std::span<const double>, const RegularTriangulation<3>&,
                                    const SimplexTable<3>&, std::span<const std::uint64_t>,
                                    std::span<std::uint32_t>, Threads);

}  // namespace orthoball
