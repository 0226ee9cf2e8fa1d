// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/queries/alpha_candidates.h"

namespace orthoball {

/// Candidates for alpha, one line each in the order given:
/// `rank,name,index,alpha2,alpha,inverse_alpha,betti_0,..,volume,area,stable_from,stable_to,
/// stability,found,same_betti,alpha_low,alpha_median,alpha_high,reason`. `stable_from` and
/// `stable_to` are alpha2, no value for a stretch without an end; the five columns before the
/// reason have no values without resamples, and all but the name of a candidate without an index.
/// @param spreads  one for each candidate, or none.
template <int D>
void write_alpha_candidates(ByteSink& sink, TableFormat format, const Filtration<D>& filtration,
                            std::span<const AlphaCandidate<D>> candidates,
                            std::span<const AlphaSpread> spreads);

extern template void write_alpha_candidates<2>(ByteSink&, TableFormat, const Filtration<2>&,
                                               std::span<const AlphaCandidate<2>>,
                                               std::span<const AlphaSpread>);
extern template void write_alpha_candidates<3>(ByteSink&, TableFormat, const Filtration<3>&,
                                               std::span<const AlphaCandidate<3>>,
                                               std::span<const AlphaSpread>);

}  // namespace orthoball
