// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "orthoball/filtration/filtration.h"
#include "orthoball/input/site_labels.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/snapshot.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// Writes the viewer's page with a snapshot in it: one HTML file for any browser. The same bytes on
/// any number of threads.
/// @param page  as the viewer's build makes it, with places for a title and for the data.
/// @throws OutputError
template <int D>
void write_page(ByteSink& sink, std::string_view page, const Filtration<D>& filtration,
                const WeightedPoints& points, const SiteLabels& labels, const SnapshotFacts& facts,
                Threads threads = {});

extern template void write_page<2>(ByteSink&, std::string_view, const Filtration<2>&,
                                   const WeightedPoints&, const SiteLabels&, const SnapshotFacts&,
                                   Threads);  // in page.cpp
extern template void write_page<3>(ByteSink&, std::string_view, const Filtration<3>&,
                                   const WeightedPoints&, const SiteLabels&, const SnapshotFacts&,
                                   Threads);

}  // namespace orthoball
