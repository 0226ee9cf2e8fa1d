// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/queries/nearest.h"

namespace orthoball {

/// Where a point is with respect to a shape.
template <int D>
struct Location {
  /// Of the triangulation, with the point in its relative interior; none outside the convex hull.
  SimplexId simplex{};
  /// The component of the shape that it is in, numbered from 1 in the order of `regions` joined by
  /// vertices; 0 outside the shape, which is closed.
  std::uint32_t region = 0;
  BoundaryPoint<D> nearest{};
};

/// [row of `points`]: where each is. Simplex and region are exact; the rest as nearest_on_boundary.
/// @throws InputError for points of another dimension.
template <int D>
[[nodiscard]] std::vector<Location<D>> locate(const AlphaComplex<D>& complex,
                                              const WeightedPoints& points, Threads threads = {});

extern template std::vector<Location<2>> locate<2>(const AlphaComplex<2>&, const WeightedPoints&,
                                                   Threads);  // in locate.cpp
extern template std::vector<Location<3>> locate<3>(const AlphaComplex<3>&, const WeightedPoints&,
                                                   Threads);

}  // namespace orthoball
