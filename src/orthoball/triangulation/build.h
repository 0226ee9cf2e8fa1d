// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/points/weighted_points.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The regular triangulation of `points`. Exact; see RegularTriangulation.
///
/// O(n log n) time for points that are not made to be hard; the worst case is quadratic in space,
/// as the triangulation itself is.
/// @throws InputError unless `points.dimension()` is D.
/// @throws LimitError for 2^30 cells or more.
/// @cite bowyer_1981  @cite amenta_choi_rote_2003
template <int D>
[[nodiscard]] RegularTriangulation<D> regular_triangulation(const WeightedPoints& points);

extern template RegularTriangulation<2> regular_triangulation<2>(const WeightedPoints& points);
extern template RegularTriangulation<3> regular_triangulation<3>(const WeightedPoints& points);

}  // namespace orthoball
