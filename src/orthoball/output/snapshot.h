// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "orthoball/filtration/filtration.h"
#include "orthoball/input/site_labels.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/signatures/notable_alphas.h"

namespace orthoball {

/// What a snapshot says beside what is computed.
struct SnapshotFacts {
  std::string source{};          ///< file name of the input, for titles
  std::string unit{};            ///< of lengths: "Å", or empty where it is not known
  std::string radii{};           ///< where weights come from, in words
  WeightMeaning weights{};       ///< the same for programs
  std::uint32_t index = 0;       ///< of the spectrum, to be shown first; 0..s
  double alpha2 = 0.0;           ///< to be shown first; length^2, index() of it is `index`
  std::string chosen_because{};  ///< why that one, in words; empty where the user chose
};

/// Writes everything a viewer needs to show any alpha shape of a filtration, in one file of packed
/// arrays: sites with their labels, the spectrum, all simplices with their three indices, Betti
/// numbers and measures at every index, persistence pairs, cycles of the tunnels that live longest,
/// notable alphas.
/// docs/file_formats/snapshot.md describes it; a test holds the two together.
///
/// Exact: coordinates, weights and the spectrum are the doubles that this library reports, every
/// index and number of simplices is kept. Measures are those doubles too, or rounded to 24 bits
/// where there are more than kExactMeasures indices. The same bytes on any number of threads.
///
/// Memory beyond the filtration: what persistence_pairs takes and, up to kMostSimplicesForCycles,
/// Representatives; 44 bytes an index, and one array at a time.
/// @param points  what the filtration was made of.
/// @param labels  of its rows.
/// @throws OutputError
template <int D>
void write_snapshot(ByteSink& sink, const Filtration<D>& filtration, const WeightedPoints& points,
                    const SiteLabels& labels, const SnapshotFacts& facts, Threads threads = {});

/// Up to so many indices measures are kept as doubles.
inline constexpr std::uint32_t kExactMeasures = 1U << 20U;

extern template void write_snapshot<2>(ByteSink&, const Filtration<2>&, const WeightedPoints&,
                                       const SiteLabels&, const SnapshotFacts&,
                                       Threads);  // defined in snapshot.cpp
extern template void write_snapshot<3>(ByteSink&, const Filtration<3>&, const WeightedPoints&,
                                       const SiteLabels&, const SnapshotFacts&, Threads);

}  // namespace orthoball
