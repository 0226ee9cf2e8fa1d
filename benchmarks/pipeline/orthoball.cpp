// SPDX-License-Identifier: MIT
// Our side of a comparison, see case.h.
#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "benchmarks/case.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/large_blocks.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/parallel.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/persistence.h"
#include "orthoball/triangulation/build.h"

namespace {

using namespace orthoball;

// Each stage with the threads it can use; those that know of one only take no argument.
template <int D, class Points>
auto triangulated(const Points& points, Threads threads) {
  if constexpr (requires { regular_triangulation<D>(points, threads); }) {
    return regular_triangulation<D>(points, threads);
  } else {
    return regular_triangulation<D>(points);
  }
}
template <int D, class Triangulation>
auto filtered(Triangulation triangulation, Threads threads) {
  if constexpr (requires { Filtration<D>(std::move(triangulation), threads); }) {
    return Filtration<D>(std::move(triangulation), threads);
  } else {
    return Filtration<D>(std::move(triangulation));
  }
}
template <int D, class AnyFiltration, class Visit>
void scan(const AnyFiltration& filtration, const Visit& visit, Threads threads) {
  if constexpr (requires { scan_signatures<D>(filtration, visit, threads); }) {
    scan_signatures<D>(filtration, visit, threads);
  } else {
    scan_signatures<D>(filtration, visit);
  }
}

template <int D>
void run(const benchmarks::Case& task) {
  const Threads threads(task.threads);
  const LargeBlockReuse reuse;
  benchmarks::Meter meter;
  if (task.work == "input") {
    meter.report(task, {});
    return;
  }
  RegularTriangulation<D> triangulation = triangulated<D>(task.points, threads);
  meter.stage("triangulation");
  const std::size_t cells = triangulation.cell_count(), vertices = triangulation.vertex_count();
  if (task.work == "triangulation") {
    meter.report(task, {{"cells", cells}, {"vertices", vertices}});
    return;
  }
  if (task.work == "balls") {
    const Filtration<D> filtration(std::move(triangulation), std::array{0.0}, threads);
    meter.stage("complex");
    const UnionOfBalls balls =
        union_of_balls(filtration, filtration.index(0.0), 0.0, UnionOptions{.threads = threads});
    if (!(balls.area > 0.0)) throw std::logic_error("the union has no surface");
    meter.stage("balls");
    meter.report(task, {{"cells", cells}, {"vertices", vertices}});
    return;
  }
  const Filtration<D> filtration = filtered<D>(std::move(triangulation), threads);
  meter.stage("filtration");
  if (task.work == "signatures") {
    std::size_t last = 0;
    scan<D>(
        filtration, [&](const Signature<D>& signature) { last = signature.index; }, threads);
    if (last != filtration.spectrum_size()) throw std::logic_error("an index was left out");
    meter.stage("signatures");
  } else if (task.work == "filtration") {
    const Filter<D> filter(filtration, threads);
    if (filter.simplices().size() != filtration.size()) {
      throw std::logic_error("simplices were lost");
    }
    meter.stage("filter");
  } else if (task.work == "persistence") {
    const PersistencePairs<D> pairs = persistence_pairs(filtration, WantedPairs::lasting, threads);
    if (pairs[0].empty()) throw std::logic_error("the first component was left out");
    meter.stage("pairs");
  } else {
    throw std::invalid_argument("no work " + task.work);
  }
  meter.report(task, {{"cells", cells}, {"vertices", vertices}, {"simplices", filtration.size()}});
}

}  // namespace

int main(int argc, char** argv) {
  const benchmarks::Case task = benchmarks::case_of(argc, argv);
  task.points.dimension() == 2 ? run<2>(task) : run<3>(task);
}
