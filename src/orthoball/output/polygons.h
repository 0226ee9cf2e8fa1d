// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/ids.h"

namespace orthoball {

/// One piece of a plane shape's interior as maps draw it: an outer ring and the rings of its holes.
struct Polygon {
  /// rings[0] is the outer one, counterclockwise; holes are clockwise. Each is a closed polygon
  /// that visits no vertex twice; the first vertex is not repeated at the end.
  std::vector<std::vector<VertexId>> rings;
};

/// The interior of a shape, one polygon for every part that is connected through edges: valid in
/// the sense of OGC Simple Features and RFC 7946 wherever parts or holes touch in vertices. Exact.
/// Polygons come in the order of their first edges, rings and their starts likewise.
[[nodiscard]] std::vector<Polygon> polygons(const AlphaComplex<2>& complex);

}  // namespace orthoball
