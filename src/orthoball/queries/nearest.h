// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// A point of a boundary, in input units.
template <int D>
struct BoundaryPoint {
  std::array<double, std::size_t{D}> point{};                 ///< [axis]; lengths
  double distance = std::numeric_limits<double>::infinity();  ///< from where it was looked for
  SimplexId simplex{};  ///< facet, or singular simplex of lower dimension; none without boundary
};

/// [row of `points`]: the point of the boundary of a shape that is nearest to that point: on its
/// regular and singular facets, singular edges and singular vertices. Of simplices at one distance
/// that with the smallest number.
///
/// Computed in doubles: distances err by a few 2^-53 of the largest coordinate or distance at hand,
/// and of two simplices that are as near as that either may be taken. About logarithmic for each
/// point, by a tree of boxes around the simplices.
/// @throws InputError for points of another dimension.
template <int D>
[[nodiscard]] std::vector<BoundaryPoint<D>> nearest_on_boundary(const AlphaComplex<D>& complex,
                                                                const WeightedPoints& points,
                                                                Threads threads = {});

extern template std::vector<BoundaryPoint<2>> nearest_on_boundary<2>(const AlphaComplex<2>&,
                                                                     const WeightedPoints&,
                                                                     Threads);  // in nearest.cpp
extern template std::vector<BoundaryPoint<3>> nearest_on_boundary<3>(const AlphaComplex<3>&,
                                                                     const WeightedPoints&,
                                                                     Threads);

}  // namespace orthoball
