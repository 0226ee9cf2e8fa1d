// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// [row of `points`]: the simplex of the triangulation in whose relative interior that point lies,
/// none outside the convex hull of the sites. So a point is in the shape at an index, which is
/// closed, if enters() of its simplex is at most the index: one location serves all shapes.
///
/// Exact, also where points are decimals and sites doubles or the other way round. The weights of
/// `points` do not matter. Points near each other should have rows near each other: each is found
/// by a walk from the one before, of about the third (in the plane: square) root of the cells at
/// most. The same on any number of threads.
/// @throws InputError for points of another dimension.
/// @cite devillers_pion_teillaud_2002
template <int D>
[[nodiscard]] std::vector<SimplexId> simplices_at(const Filtration<D>& filtration,
                                                  const WeightedPoints& points,
                                                  Threads threads = {});

extern template std::vector<SimplexId> simplices_at<2>(const Filtration<2>&, const WeightedPoints&,
                                                       Threads);  // in containment.cpp
extern template std::vector<SimplexId> simplices_at<3>(const Filtration<3>&, const WeightedPoints&,
                                                       Threads);

}  // namespace orthoball
