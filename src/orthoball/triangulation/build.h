// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// The regular triangulation of `points`. Exact; see RegularTriangulation. The same whatever the
/// number of threads.
///
/// O(n log n) time for points that are not made to be hard. At worst quadratic: in space, as the
/// triangulation itself is then, and in the plane.
/// @throws InputError unless `points.dimension()` is D.
/// @throws LimitError for more than 2^29 cells.
/// @cite bowyer_1981  @cite amenta_choi_rote_2003  @cite marot_pellerin_remacle_2019
template <int D>
[[nodiscard]] RegularTriangulation<D> regular_triangulation(const WeightedPoints& points,
                                                            Threads threads = {});

extern template RegularTriangulation<2> regular_triangulation<2>(const WeightedPoints& points,
                                                                 Threads);
extern template RegularTriangulation<3> regular_triangulation<3>(const WeightedPoints& points,
                                                                 Threads);

}  // namespace orthoball
