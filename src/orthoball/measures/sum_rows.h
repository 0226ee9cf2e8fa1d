// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/measures/complex_measures.h"
#include "orthoball/measures/input_units.h"
#include "orthoball/measures/term_bins.h"

/// Four sums at once, index by index, side by side in vectors, each with the sum of what rounding
/// took from it beside it. Of measure_scan.cpp alone.
namespace orthoball::sum_rows_detail {

using Four = double __attribute__((vector_size(32)));

/// What the elements of Four are.
inline constexpr std::size_t kVolume = 0, kLength = 1, kSingular = 2, kRegular = 3;

/// What the terms of one index, or all up to one, add up to. @cite ogita_rump_oishi_2005
struct alignas(64) SumRow {
  Four sum, error;
};

/// Adds `other`, the sum of which no rounding may be lost.
void add_row(SumRow& row, const SumRow& other);

/// [place in a stretch]: simplices that change at an index.
struct CountRows {
  std::uint32_t *edges, *facets, *cells, *interior_facets;
};

/// The tag of a cell's terms: how many facets become interior with it, and how many enter with it.
[[nodiscard]] constexpr unsigned cell_tag(unsigned interior, unsigned entering) {
  return 5 * interior - interior * (interior - 1) / 2 + entering;
}

/// Adds the terms of a stretch to its rows, by dimension, and counts them.
void add_terms(const TermBins<1>& edges, const TermBins<2>& facets, const TermBins<6>& cells,
               std::uint32_t stretch, SumRow* rows, const CountRows& counts);

/// Turns the sums of single indices into those of all up to each, from the first of `rows` on.
void accumulate(std::span<SumRow> rows);

/// To input units.
struct SumUnits {
  InputUnits volume, area, length;
};

/// Rounds sums, each `before` and a row.
void read_sums(const SumRow& before, std::span<const SumRow> rows, const SumUnits& units,
               std::span<ComplexMeasures> out);

}  // namespace orthoball::sum_rows_detail
