// SPDX-License-Identifier: MIT
//
// Every function is written once and compiled twice, for vectors of two doubles and of four.
#include "orthoball/measures/sum_rows.h"

#include <cstring>

#include "orthoball/exact/double_double.h"
#include "orthoball/exact/processor.h"

namespace orthoball::sum_rows_detail {
namespace {

struct CellTag {
  std::uint8_t interior = 0, entering = 0;
};
constexpr auto kCellTags = [] {
  std::array<CellTag, 16> tags{};
  for (std::uint8_t interior = 0; interior <= 4; ++interior) {
    for (std::uint8_t entering = 0; interior + entering <= 4; ++entering) {
      tags[cell_tag(interior, entering)] = {interior, entering};
    }
  }
  return tags;
}();

[[gnu::always_inline]] inline void add(SumRow& row, const Four& term, const Four& error) {
  const Four sum = row.sum + term;
  const Four term_part = sum - row.sum;
  const Four sum_part = sum - term_part;
  row.error = row.error + (((row.sum - sum_part) + (term - term_part)) + error);
  row.sum = sum;
}

[[gnu::always_inline]] inline void add_terms_inline(const TermBins<1>& edges,
                                                    const TermBins<2>& facets,
                                                    const TermBins<6>& cells, std::uint32_t stretch,
                                                    SumRow* rows, const CountRows& counts) {
  edges.for_each(
      stretch, [&](std::size_t place, unsigned, const std::byte* values)
                   __attribute__((always_inline)) {
                     double length = 0.0;
                     std::memcpy(&length, values, sizeof length);
                     add(rows[place], Four{0.0, length, 0.0, 0.0}, Four{});
                     ++counts.edges[place];
                   });
  facets.for_each(
      stretch, [&](std::size_t place, unsigned, const std::byte* values)
                   __attribute__((always_inline)) {
                     std::array<double, 2> terms;
                     std::memcpy(&terms, values, sizeof terms);
                     add(rows[place], Four{0.0, terms[0], terms[1], 0.0}, Four{});
                     ++counts.facets[place];
                   });
  cells.for_each(
      stretch, [&](std::size_t place, unsigned tag, const std::byte* values)
                   __attribute__((always_inline)) {
                     Four terms;
                     std::array<double, 2> errors;
                     std::memcpy(&terms, values, sizeof terms);
                     std::memcpy(&errors, values + sizeof terms, sizeof errors);
                     add(rows[place], terms, Four{0.0, 0.0, errors[0], errors[1]});
                     ++counts.cells[place];
                     counts.facets[place] += kCellTags[tag].entering;
                     counts.interior_facets[place] += kCellTags[tag].interior;
                   });
}

[[gnu::always_inline]] inline void accumulate_inline(std::span<SumRow> rows) {
  SumRow all{};
  for (SumRow& row : rows) {
    add(all, row.sum, row.error);
    row = all;
  }
}

[[gnu::always_inline]] inline void read_sums_inline(const SumRow& before,
                                                    std::span<const SumRow> rows,
                                                    const SumUnits& units,
                                                    std::span<ComplexMeasures> out) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SumRow all{before.sum, Four{}};
    add(all, rows[i].sum, before.error + rows[i].error);
    const Four high = all.sum + all.error;
    const Four low = all.error - (high - all.sum);
    const auto value = [&](std::size_t lane) __attribute__((always_inline)) {
      return DoubleDouble{high[lane], low[lane]};
    };
    const DoubleDouble singular = value(kSingular), regular = value(kRegular);
    out[i].volume = units.volume(value(kVolume));
    out[i].area_singular = units.area(singular);
    out[i].area_regular = units.area(regular);
    out[i].area = units.area((singular + singular) + regular);
    out[i].length = units.length(value(kLength));
  }
}

ORTHOBALL_AVX2 void add_terms_wide(const TermBins<1>& edges, const TermBins<2>& facets,
                                   const TermBins<6>& cells, std::uint32_t stretch, SumRow* rows,
                                   const CountRows& counts) {
  add_terms_inline(edges, facets, cells, stretch, rows, counts);
}
ORTHOBALL_AVX2 void accumulate_wide(std::span<SumRow> rows) { accumulate_inline(rows); }
ORTHOBALL_AVX2 void read_sums_wide(const SumRow& before, std::span<const SumRow> rows,
                                   const SumUnits& units, std::span<ComplexMeasures> out) {
  read_sums_inline(before, rows, units, out);
}

}  // namespace

void add_row(SumRow& row, const SumRow& other) { add(row, other.sum, other.error); }

void add_terms(const TermBins<1>& edges, const TermBins<2>& facets, const TermBins<6>& cells,
               std::uint32_t stretch, SumRow* rows, const CountRows& counts) {
  has_avx2() ? add_terms_wide(edges, facets, cells, stretch, rows, counts)
             : add_terms_inline(edges, facets, cells, stretch, rows, counts);
}
void accumulate(std::span<SumRow> rows) {
  has_avx2() ? accumulate_wide(rows) : accumulate_inline(rows);
}
void read_sums(const SumRow& before, std::span<const SumRow> rows, const SumUnits& units,
               std::span<ComplexMeasures> out) {
  has_avx2() ? read_sums_wide(before, rows, units, out)
             : read_sums_inline(before, rows, units, out);
}

}  // namespace orthoball::sum_rows_detail
