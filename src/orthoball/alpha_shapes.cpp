// SPDX-License-Identifier: MIT
#include "orthoball/alpha_shapes.h"

#include <string>
#include <utility>

#include "orthoball/large_blocks.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points, const BuildOptions& options) {
  const auto tell = [&](BuildStage stage) {
    if (options.on_stage) options.on_stage(stage);
  };
  const std::string sites = std::to_string(points.size()) + " sites";
  tell(BuildStage::triangulation);
  options.memory.require(alpha_shapes_memory(D, points.size()),
                         "the triangulation and filtration of " + sites);
  RegularTriangulation<D> triangulation = regular_triangulation<D>(points, options.threads);
  tell(BuildStage::filtration);
  const std::size_t cells = triangulation.cell_count();
  options.memory.require(filtration_memory(D, points.size(), cells),
                         "the filtration of " + sites + " in " + std::to_string(cells) + " cells");
  return options.alpha2.empty()
             ? Filtration<D>(std::move(triangulation), options.threads)
             : Filtration<D>(std::move(triangulation), options.alpha2, options.threads);
}

}  // namespace

AlphaShapes::AlphaShapes(WeightedPoints points, const BuildOptions& options)
    : points_(std::move(points)) {
  const LargeBlockReuse reuse;
  if (points_.dimension() == 2) {
    filtration_ = filtration_of<2>(points_, options);
  } else {
    filtration_ = filtration_of<3>(points_, options);
  }
}

}  // namespace orthoball
