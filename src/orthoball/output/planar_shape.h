// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// How a shape of a plane set is drawn.
struct PlanarShapeOptions {
  double alpha2 = 0.0;  ///< the number written beside the index; length^2
  bool roles = false;   ///< SVG: singular edges and vertices in a colour of their own
};

/// A plane shape as a GeoJSON FeatureCollection (RFC 7946): its interior as one MultiPolygon, every
/// singular edge as a LineString, every singular vertex as a Point. Properties: `role`, and the
/// input rows as `rows` (nested as the coordinates are, rings not closed) or `row`; of the
/// MultiPolygon also `alpha2` and `index`. Coordinates are those of the input, never projected.
/// @throws OutputError
void write_geojson(ByteSink& sink, const AlphaComplex<2>& complex, const WeightedPoints& points,
                   const PlanarShapeOptions& options);

/// A plane shape as a picture, 800 units wide or high, y upwards: interior filled, its boundary,
/// singular edges and vertices, and all vertices of the triangulation as dots.
/// @throws OutputError
void write_shape_svg(ByteSink& sink, const AlphaComplex<2>& complex, const WeightedPoints& points,
                     const PlanarShapeOptions& options);

}  // namespace orthoball
