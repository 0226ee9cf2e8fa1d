// SPDX-License-Identifier: MIT
#include "orthoball/alpha_shapes.h"

#include <utility>

#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points, const BuildObserver& on_stage) {
  if (on_stage) on_stage(BuildStage::triangulation);
  RegularTriangulation<D> triangulation = regular_triangulation<D>(points);
  if (on_stage) on_stage(BuildStage::filtration);
  return Filtration<D>(std::move(triangulation));
}

}  // namespace

AlphaShapes::AlphaShapes(WeightedPoints points, const BuildObserver& on_stage)
    : points_(std::move(points)) {
  if (points_.dimension() == 2) {
    filtration_ = filtration_of<2>(points_, on_stage);
  } else {
    filtration_ = filtration_of<3>(points_, on_stage);
  }
}

}  // namespace orthoball
