// SPDX-License-Identifier: MIT
// Nanoseconds of each predicate in each of its stages, on inputs that this stage decides.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/exact/orient.h"
#include "orthoball/exact/perturbation.h"
#include "orthoball/exact/power_side.h"

namespace {

using namespace orthoball;
using generators::PointFamily;

struct Tuples {
  Sites<3> sites;
  std::vector<std::array<std::uint32_t, 5>> rows;
};

// Random tuples of four corners and a query.
Tuples tuples_of(const WeightedPoints& points) {
  std::vector<SiteId> all;
  for (std::uint32_t row = 0; row < points.size(); ++row) all.emplace_back(row);
  Tuples tuples{Sites<3>(points, all), {}};
  generators::Random random(1);
  for (int i = 0; i < 1024; ++i) {
    std::array<std::uint32_t, 5> rows{};
    for (std::uint32_t& row : rows) {
      row = static_cast<std::uint32_t>(random.bits() % points.size());
    }
    tuples.rows.push_back(rows);
  }
  return tuples;
}

template <class Predicate>
void measure(benchmark::State& state, const Tuples& tuples, const Predicate& predicate) {
  std::size_t at = 0;
  for (auto unused : state) {
    benchmark::DoNotOptimize(predicate(tuples.sites, tuples.rows[at]));
    at = (at + 1) % tuples.rows.size();
  }
}

constexpr auto kOrient = [](const Sites<3>& sites, const std::array<std::uint32_t, 5>& rows) {
  return orient<3, 3>(sites, {rows[0], rows[1], rows[2], rows[3]});
};
constexpr auto kExactOrient = [](const Sites<3>& sites, const std::array<std::uint32_t, 5>& rows) {
  return exact_orient<3, 3>(sites, {rows[0], rows[1], rows[2], rows[3]}, {0, 1, 2});
};
constexpr auto kPowerSide = [](const Sites<3>& sites, const std::array<std::uint32_t, 5>& rows) {
  return power_side<3, 3>(sites, {rows[0], rows[1], rows[2], rows[3]}, rows[4]);
};
constexpr auto kExactPowerSide = [](const Sites<3>& sites,
                                    const std::array<std::uint32_t, 5>& rows) {
  return exact_power_side<3, 3>(sites, {rows[0], rows[1], rows[2], rows[3]}, rows[4]);
};

WeightedPoints uniform() { return points_of(PointFamily::uniform, 3, 1024, 1); }
WeightedPoints grid() { return points_of(PointFamily::grid, 3, 512, 1); }
WeightedPoints atoms() { return points_of(PointFamily::protein_like, 3, 1024, 1); }
WeightedPoints mixed() { return points_of(PointFamily::mixed_scales, 3, 64, 1); }

BENCHMARK_CAPTURE(measure, orient_filter, tuples_of(uniform()), kOrient);
BENCHMARK_CAPTURE(measure, orient_small_integers, tuples_of(grid()), kOrient);
BENCHMARK_CAPTURE(measure, orient_exact_atoms, tuples_of(atoms()), kExactOrient);
BENCHMARK_CAPTURE(measure, orient_exact_doubles, tuples_of(uniform()), kExactOrient);
BENCHMARK_CAPTURE(measure, orient_exact_mixed_scales, tuples_of(mixed()), kExactOrient);
BENCHMARK_CAPTURE(measure, power_side_filter, tuples_of(uniform()), kPowerSide);
BENCHMARK_CAPTURE(measure, power_side_small_integers, tuples_of(grid()), kPowerSide);
BENCHMARK_CAPTURE(measure, power_side_exact_atoms, tuples_of(atoms()), kExactPowerSide);
BENCHMARK_CAPTURE(measure, power_side_exact_doubles, tuples_of(uniform()), kExactPowerSide);
BENCHMARK_CAPTURE(measure, power_side_exact_mixed_scales, tuples_of(mixed()), kExactPowerSide);

// The unit cube's corner against the tetrahedron of the others: a tie, decided by perturbation.
void perturbation(benchmark::State& state) {
  const WeightedPoints cube(3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, WeightKind::none, {});
  const Sites<3> sites(cube, {SiteId(0), SiteId(1), SiteId(2), SiteId(3), SiteId(4)});
  for (auto unused : state) {
    benchmark::DoNotOptimize(perturbed_conflict<3, 3>(sites, {0, 1, 2, 3}, 4));
  }
}
BENCHMARK(perturbation);

}  // namespace
