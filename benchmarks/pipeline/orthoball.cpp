// SPDX-License-Identifier: MIT
// Our side of a comparison, see case.h.
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "benchmarks/case.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"

namespace {

using namespace orthoball;

// Number of cells; for the work `signatures` of all simplices.
template <int D>
std::size_t result(const benchmarks::Case& task) {
  RegularTriangulation<D> triangulation = regular_triangulation<D>(task.points);
  if (task.work == "triangulation") return triangulation.cell_count();
  const Filtration<D> filtration(std::move(triangulation));
  std::size_t last = 0;
  scan_signatures<D>(filtration, [&](const Signature<D>& signature) { last = signature.index; });
  if (last != filtration.spectrum_size()) throw std::logic_error("an index was left out");
  return filtration.size();
}

}  // namespace

int main(int argc, char** argv) {
  const benchmarks::Case task = benchmarks::case_of(argc, argv);
  const benchmarks::Stopwatch watch;
  const std::size_t count = task.points.dimension() == 2 ? result<2>(task) : result<3>(task);
  benchmarks::report(watch.seconds(), count);
}
