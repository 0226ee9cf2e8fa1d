// SPDX-License-Identifier: MIT
// TetGen's side of a comparison, see case.h: triangulations in space.
#include <tetgen.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "benchmarks/case.h"

int main(int argc, char** argv) {
  const orthoball::benchmarks::Case task = orthoball::benchmarks::case_of(argc, argv);
  const orthoball::WeightedPoints& points = task.points;
  if (task.work != "triangulation" || points.dimension() != 3) {
    throw std::invalid_argument("TetGen is asked for triangulations in space only");
  }
  const bool has_weights = points.weight_kind() != orthoball::WeightKind::none;
  tetgenio in, out;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = new REAL[3 * points.size()];
  std::copy(points.coordinates().begin(), points.coordinates().end(), in.pointlist);
  if (has_weights) {
    in.numberofpointattributes = 1;
    in.pointattributelist = new REAL[points.size()];
    for (std::size_t row = 0; row < points.size(); ++row) {
      in.pointattributelist[row] = orthoball::benchmarks::weight(points, row);
    }
  }
  const orthoball::benchmarks::Meter meter;
  char weighted[] = "Qw", plain[] = "Q";
  tetrahedralize(has_weights ? weighted : plain, &in, &out);
  meter.report(task, {{"cells", static_cast<std::size_t>(out.numberoftetrahedra)}});
}
