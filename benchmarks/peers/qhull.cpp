// SPDX-License-Identifier: MIT
// Qhull's side of a comparison, see case.h: triangulations without weights, in doubles only.
#include <libqhull_r/qhull_ra.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "benchmarks/case.h"

int main(int argc, char** argv) {
  const orthoball::benchmarks::Case task = orthoball::benchmarks::case_of(argc, argv);
  const orthoball::WeightedPoints& points = task.points;
  if (task.work != "triangulation" || points.weight_kind() != orthoball::WeightKind::none) {
    throw std::invalid_argument("Qhull is asked for triangulations without weights only");
  }
  std::vector<double> coordinates(points.coordinates().begin(), points.coordinates().end());
  qhT memory;
  qhT* qh = &memory;
  const orthoball::benchmarks::Meter meter;
  qh_zero(qh, nullptr);
  char options[] = "qhull d Qt Qbb Qc";
  if (qh_new_qhull(qh, points.dimension(), static_cast<int>(points.size()), coordinates.data(),
                   False, options, nullptr, nullptr) != 0) {
    throw std::runtime_error("Qhull failed");
  }
  std::size_t cells = 0;
  for (facetT* facet = qh->facet_list; facet != nullptr && facet->next != nullptr;
       facet = facet->next) {
    if (!facet->upperdelaunay) ++cells;
  }
  meter.report(task, {{"cells", cells}});
}
