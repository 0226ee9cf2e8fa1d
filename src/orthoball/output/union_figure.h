// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// One picture of a union of disks.
enum class FigurePanel {
  disks,    ///< the disks, their union and its outline
  cells,    ///< the union in parts: each disk cut by its power cell
  complex,  ///< the dual complex over the union: triangles, edges and vertices by role
};

/// The colours of a figure.
enum class FigureStyle {
  colour,  ///< told apart by colour-blind readers
  print,   ///< black, white and grey
};

/// What is drawn, and how it is labelled.
struct UnionFigureOptions {
  std::uint32_t index = 0;  ///< of the dual complex
  double alpha2 = 0.0;      ///< length^2; the disks have the squared radii weight + alpha2
  /// From left to right.
  std::vector<FigurePanel> panels{FigurePanel::disks, FigurePanel::cells, FigurePanel::complex};
  FigureStyle style = FigureStyle::colour;
  double panel_width = 400.0;  ///< of each panel, pixels
  bool legend = true;          ///< title, captions and legend around the panels
  std::string title;           ///< above, the file for instance; shortened where it is too long
  std::string unit;            ///< of lengths, "m"; empty where it is not known
};

/// The union of disks in the plane and its dual complex as an SVG: panels side by side in one
/// scale, y upwards, circles as exact arcs. Positions are rounded to 1/100 pixel.
/// @param points  what the filtration was made from.
/// @throws InputError for an index beyond the spectrum's size, an alpha2 that is no number or
///         positive infinity, and disks beyond the range of doubles.
/// @throws OutputError
/// @cite edelsbrunner_1992
void write_union_figure(ByteSink& sink, const Filtration<2>& filtration,
                        const WeightedPoints& points, const UnionFigureOptions& options);

}  // namespace orthoball
