// SPDX-License-Identifier: MIT
// Digests of the triangulation, filtrations, signatures and union of balls of large inputs of every
// family on several numbers of threads, with rows in order and shuffled: a line for each input, and
// a failure where any of them differ. Takes minutes.
//
//   digests [LARGEST [FAMILY]]     at most so many points of a family, a million if not given;
//                                  of all families if none is named
#include "matchers/digests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/large_blocks.h"
#include "orthoball/triangulation/build.h"

namespace {

using namespace orthoball;
using generators::PointFamily;

// As many points as take some seconds.
std::size_t count_of(PointFamily family) {
  switch (family) {
    case PointFamily::uniform:
    case PointFamily::uniform_balls:
    case PointFamily::protein_like:
    case PointFamily::scan_like:
    case PointFamily::grid:
      return 1'000'000;
    case PointFamily::cospherical:
    case PointFamily::nested_balls:
    case PointFamily::same_centres:
    case PointFamily::near_sphere:
    case PointFamily::one_ulp:
      return 10'000;
    default:
      return is_extreme(family) ? 100 : 200'000;
  }
}

// How the same points are triangulated.
struct Way {
  unsigned threads;
  bool is_shuffled;
};
constexpr std::array<Way, 5> kWays{{{1, false}, {2, true}, {2, false}, {4, false}, {16, true}}};

// Some values of the spectrum, ascending.
template <int D>
std::vector<double> quartiles(const Filtration<D>& filtration) {
  std::vector<double> values;
  for (std::uint64_t quarter = 1; quarter < 4; ++quarter) {
    const auto index = static_cast<std::uint32_t>(filtration.spectrum_size() * quarter / 4);
    if (index == 0 || !std::isfinite(filtration.alpha2(index))) continue;
    if (values.empty() || values.back() < filtration.alpha2(index)) {
      values.push_back(filtration.alpha2(index));
    }
  }
  return values;
}

template <int D>
std::string digests(const WeightedPoints& points, Threads threads) {
  const LargeBlockReuse reuse;
  RegularTriangulation<D> triangulation = regular_triangulation<D>(points, threads);
  std::string text = matchers::digest(triangulation, points).text();
  const Filtration<D> filtration(std::move(triangulation), threads);
  const Filtration<D> coarse(filtration.triangulation(), quartiles(filtration), threads);
  return text + ' ' + matchers::digest(coarse, threads).text() + ' ' +
         matchers::digest(filtration, threads).text() + ' ' +
         matchers::signatures_digest(filtration, threads).text() + ' ' +
         matchers::balls_digest(filtration, threads).text();
}

template <int D>
bool is_determined(PointFamily family, std::size_t largest) {
  const std::size_t count = std::min(count_of(family), largest);
  const WeightedPoints points = generators::points_of(family, D, count, /*seed=*/1);
  const WeightedPoints shuffled =
      generators::with_rows(points, generators::random_permutation(points.size(), /*seed=*/2));
  std::cout << D << "D " << name(family) << ' ' << points.size() << ": " << std::flush;
  std::string expected;
  for (const Way& way : kWays) {
    const std::string found = digests<D>(way.is_shuffled ? shuffled : points, Threads(way.threads));
    if (expected.empty()) {
      expected = found;
      std::cout << expected << std::flush;
    } else if (found != expected) {
      std::cout << "\n  but on " << way.threads << " threads"
                << (way.is_shuffled ? ", shuffled: " : ": ") << found << std::endl;
      return false;
    }
  }
  std::cout << std::endl;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  bool all = true, any = false;
  const std::string_view wanted = argc > 2 ? argv[2] : "";
  for (const PointFamily family : generators::point_families()) {
    if (!wanted.empty() && name(family) != wanted) continue;
    any = true;
    all &= is_determined<2>(family, largest);
    all &= is_determined<3>(family, largest);
  }
  if (!any) std::cerr << "no family is named " << wanted << '\n';
  return all && any ? EXIT_SUCCESS : EXIT_FAILURE;
}
