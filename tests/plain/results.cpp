// SPDX-License-Identifier: MIT
// A line for each family of points: digests of its triangulation, filtration and signatures, bit by
// bit. The same program with and without vector code must print the same.
#include <cstddef>
#include <iostream>
#include <utility>

#include "generators/point_families.h"
#include "matchers/digests.h"
#include "orthoball/triangulation/build.h"

namespace {

using namespace orthoball;

template <int D>
void print(generators::PointFamily family, std::size_t count) {
  const WeightedPoints points = generators::points_of(family, D, count, /*seed=*/1);
  RegularTriangulation<D> triangulation = regular_triangulation<D>(points);
  std::cout << name(family) << ' ' << D << "D: " << matchers::digest(triangulation, points).text();
  const Filtration<D> filtration(std::move(triangulation));
  std::cout << ' ' << matchers::digest(filtration).text() << ' '
            << matchers::signatures_digest(filtration).text() << '\n';
}

}  // namespace

int main() {
  for (const generators::PointFamily family : generators::point_families()) {
    const std::size_t count = is_extreme(family) ? 60 : 1500;
    print<2>(family, count);
    print<3>(family, count);
  }
}
