// SPDX-License-Identifier: MIT
// Voro++'s side of a comparison, see case.h: every cell of the Voronoi diagram in the unit box,
// without what joins them, so less than a triangulation.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <voro++/voro++.hh>

#include "benchmarks/case.h"

int main(int argc, char** argv) {
  const orthoball::benchmarks::Case task = orthoball::benchmarks::case_of(argc, argv);
  const orthoball::WeightedPoints& points = task.points;
  if (task.work != "triangulation" || points.dimension() != 3 ||
      points.weight_kind() != orthoball::WeightKind::none || points.decimals()) {
    throw std::invalid_argument("Voro++ is asked for points of the unit box only");
  }
  const orthoball::benchmarks::Meter meter;
  // About five points to a block, as its manual advises.
  const int side = std::max(1, static_cast<int>(std::cbrt(static_cast<double>(points.size()) / 5)));
  voro::container box(0, 1, 0, 1, 0, 1, side, side, side, false, false, false, 8);
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double* x = points.coordinates().data() + 3 * row;
    box.put(static_cast<int>(row), x[0], x[1], x[2]);
  }
  std::size_t vertices = 0;
  double volume = 0.0;
  voro::voronoicell cell;
  voro::c_loop_all loop(box);
  if (loop.start()) {
    do {
      if (!box.compute_cell(cell, loop)) continue;
      ++vertices;
      volume += cell.volume();
    } while (loop.inc());
  }
  if (std::abs(volume - 1.0) > 1e-8) throw std::runtime_error("Voro++: volumes do not add up");
  meter.report(task, {{"vertices", vertices}});
}
