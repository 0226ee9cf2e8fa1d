// SPDX-License-Identifier: MIT
// Sites a second of each layer on each family of points: what comes before is built outside.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "generators/point_families.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/triangulation/insertion_order.h"

namespace {

using namespace orthoball;
using generators::PointFamily;

WeightedPoints shuffled(PointFamily family, int dimension, std::size_t count) {
  const WeightedPoints points = generators::points_of(family, dimension, count, 1);
  return generators::with_rows(points, generators::random_permutation(points.size(), 1));
}

void count_sites(benchmark::State& state, std::size_t count) {
  state.SetItemsProcessed(static_cast<std::int64_t>(count) * state.iterations());
}

template <int D>
void curve(benchmark::State& state, PointFamily family, std::size_t count) {
  const WeightedPoints points = shuffled(family, D, count);
  for (auto unused : state) benchmark::DoNotOptimize(curve_order<D>(points));
  count_sites(state, count);
}

template <int D>
void triangulation(benchmark::State& state, PointFamily family, std::size_t count) {
  const WeightedPoints points = shuffled(family, D, count);
  for (auto unused : state) benchmark::DoNotOptimize(regular_triangulation<D>(points));
  count_sites(state, count);
}

template <int D>
void filtration(benchmark::State& state, PointFamily family, std::size_t count) {
  const auto built = regular_triangulation<D>(shuffled(family, D, count));
  for (auto unused : state) {
    const Filtration<D> filtration(built);
    benchmark::DoNotOptimize(filtration.size());
  }
  count_sites(state, count);
}

template <int D>
void filter(benchmark::State& state, PointFamily family, std::size_t count) {
  const Filtration<D> filtration(regular_triangulation<D>(shuffled(family, D, count)));
  for (auto unused : state) {
    const Filter<D> filter(filtration);
    benchmark::DoNotOptimize(filter.simplices().data());
  }
  count_sites(state, count);
}

template <int D>
void signatures(benchmark::State& state, PointFamily family, std::size_t count) {
  const Filtration<D> filtration(regular_triangulation<D>(shuffled(family, D, count)));
  for (auto unused : state) {
    std::size_t last = 0;
    scan_signatures<D>(filtration, [&](const Signature<D>& signature) { last = signature.index; });
    benchmark::DoNotOptimize(last);
  }
  count_sites(state, count);
}

template <int D>
void add_stages(PointFamily family) {
  constexpr std::size_t kCount = 100'000;
  const auto add = [&](const std::string& stage, auto run) {
    const std::string title =
        stage + '/' + generators::name(family) + '/' + std::to_string(D) + 'D';
    benchmark::RegisterBenchmark(title.c_str(), run, family, kCount)->Unit(benchmark::kMillisecond);
  };
  add("curve", curve<D>);
  add("triangulation", triangulation<D>);
  add("filtration", filtration<D>);
  add("filter", filter<D>);
  add("signatures", signatures<D>);
}

// Registered before main runs.
const bool kAreAdded = [] {
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::uniform_balls, PointFamily::protein_like,
        PointFamily::scan_like, PointFamily::grid}) {
    add_stages<2>(family);
    add_stages<3>(family);
  }
  return true;
}();

}  // namespace
