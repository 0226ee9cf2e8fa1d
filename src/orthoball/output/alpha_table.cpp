// SPDX-License-Identifier: MIT
#include "orthoball/output/alpha_table.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace orthoball {
namespace {

template <int D>
void write_shape(TableWriter& table, const Filtration<D>& filtration,
                 const AlphaCandidate<D>& candidate) {
  const NotableAlpha& alpha = candidate.alpha;
  table.integer(*alpha.index);
  table.real(alpha.alpha2);
  table.real(alpha.alpha);
  alpha.alpha != 0.0 ? table.real(1 / alpha.alpha) : table.none();
  for (const std::uint32_t betti : candidate.at.betti) table.integer(betti);
  table.real(candidate.at.volume);
  table.real(candidate.at.area);
  for (const std::uint32_t end : {candidate.stable_from, candidate.stable_to}) {
    const bool is_there = end > 0 && end < filtration.never();
    is_there ? table.real(filtration.alpha2(end)) : table.none();
  }
  table.real(candidate.stability);
}

}  // namespace

template <int D>
void write_alpha_candidates(ByteSink& sink, TableFormat format, const Filtration<D>& filtration,
                            std::span<const AlphaCandidate<D>> candidates,
                            std::span<const AlphaSpread> spreads) {
  std::vector<std::string> columns{"rank", "name", "index", "alpha2", "alpha", "inverse_alpha"};
  for (int k = 0; k < D; ++k) columns.push_back("betti_" + std::to_string(k));
  for (const char* column : {"volume", "area", "stable_from", "stable_to", "stability", "found",
                             "same_betti", "alpha_low", "alpha_median", "alpha_high", "reason"}) {
    columns.emplace_back(column);
  }
  constexpr int kShapeColumns = 9 + D, kSpreadColumns = 5;
  TableWriter table(sink, format, columns);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    table.integer(static_cast<std::int64_t>(i) + 1);
    table.text(candidates[i].alpha.name);
    if (candidates[i].alpha.index) {
      write_shape(table, filtration, candidates[i]);
    } else {
      for (int column = 0; column < kShapeColumns; ++column) table.none();
    }
    if (spreads.empty()) {
      for (int column = 0; column < kSpreadColumns; ++column) table.none();
    } else {
      table.integer(spreads[i].found);
      table.integer(spreads[i].same_betti);
      for (const double x : {spreads[i].low, spreads[i].median, spreads[i].high}) {
        spreads[i].found > 0 ? table.real(x) : table.none();
      }
    }
    table.text(candidates[i].alpha.reason);
  }
  table.finish();
}

template void write_alpha_candidates<2>(ByteSink&, TableFormat, const Filtration<2>&,
                                        std::span<const AlphaCandidate<2>>,
                                        std::span<const AlphaSpread>);
template void write_alpha_candidates<3>(ByteSink&, TableFormat, const Filtration<3>&,
                                        std::span<const AlphaCandidate<3>>,
                                        std::span<const AlphaSpread>);

}  // namespace orthoball
