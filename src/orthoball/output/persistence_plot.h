// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/signature_plot.h"
#include "orthoball/topology/persistence.h"

namespace orthoball {

/// How classes of cycles are drawn.
enum class PersistencePicture {
  diagram,  ///< a point for each, birth from left to right, death upwards
  barcode,  ///< a bar for each from birth to death, the longest of each dimension on top
};

/// How a picture of persistence is labelled.
struct PersistencePlotOptions {
  std::string title;     ///< the file; shortened where it is too long
  std::string subtitle;  ///< what was read; shortened as well
  std::string unit;      ///< of lengths, "Å"; empty where it is not known
  PersistencePicture picture = PersistencePicture::diagram;
  PlotAxis axis = PlotAxis::alpha;
};

/// Persistence pairs as an SVG, dimensions told apart by colour and, in the diagram, by shape. The
/// axis ends a little past the last death of a tunnel or void, or of a component where there are
/// none; what begins later is not shown, classes that never die reach beyond the edge. Of classes
/// too short to be told apart from nothing, and of bars beyond the longest 60 of each dimension,
/// only the number is told.
/// @throws OutputError
template <int D>
void write_persistence_plot(ByteSink& sink, const Filtration<D>& filtration,
                            const PersistencePairs<D>& pairs,
                            const PersistencePlotOptions& options);

extern template void write_persistence_plot<2>(ByteSink&, const Filtration<2>&,
                                               const PersistencePairs<2>&,
                                               const PersistencePlotOptions&);
extern template void write_persistence_plot<3>(ByteSink&, const Filtration<3>&,
                                               const PersistencePairs<3>&,
                                               const PersistencePlotOptions&);

}  // namespace orthoball
