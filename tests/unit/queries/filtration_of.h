// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/filtration/filtration.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {

/// The filtration of points, for tests of what is asked of it.
template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

}  // namespace orthoball
