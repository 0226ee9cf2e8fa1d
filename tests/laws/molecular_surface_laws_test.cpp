// SPDX-License-Identifier: MIT
// What holds for the molecular surfaces of any balls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/cases.h"
#include "orthoball/measures/molecular_surface.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;

// Calls check(filtration, union, largest) for unions along the spectra of every family but those at
// the ends of the double range, with a length that no point of the union is deep in it.
template <class Check>
void for_each_union(std::size_t largest_count, const Check& check) {
  for (const Case& one : generators::cases(3, 5, largest_count)) {
    if (one.dimension != 3 || generators::is_extreme(one.family)) continue;
    SCOPED_TRACE(::testing::Message() << one);
    const WeightedPoints points = one.points();
    const Filtration<3> filtration(regular_triangulation<3>(points));
    const std::uint32_t last = filtration.spectrum_size();
    for (std::uint32_t part = 1; part <= 5; ++part) {
      const std::uint32_t index = last * part / 5;
      if (index == 0) continue;
      const double here = filtration.alpha2(index);
      const double next = index < last ? filtration.alpha2(index + 1) : here + std::abs(here) + 1;
      const double alpha2 = here + (next - here) / 2;
      SCOPED_TRACE(::testing::Message() << "alpha2 " << alpha2);
      double farthest = 0.0, largest = 0.0;
      for (std::size_t row = 0; row < points.size(); ++row) {
        for (int axis = 0; axis < 3; ++axis) {
          farthest = std::max(farthest,
                              std::abs(points.coordinate(row, axis) - points.coordinate(0, axis)));
        }
        largest = std::max(largest, ball_radius(points, row, alpha2).value_or(0.0));
      }
      check(filtration, union_of_balls(filtration, index, alpha2, {}), 2 * farthest + largest);
      if (::testing::Test::HasFailure()) return;  // one tells enough
    }
  }
}

// Every point of the union is nearest to some point of its surface: what the probes have of the
// spheres, arcs, triangles and cells fills it without gaps and twice nowhere.
TEST(MolecularSurfaceLaws, OfAHugeProbeIsNothing) {
  for_each_union(120, [](const auto& filtration, const UnionOfBalls& balls, double probe) {
    const MolecularSurface surface = molecular_surface(filtration, balls, probe);
    EXPECT_NEAR(surface.area, 0.0, 1e-9 * balls.area);
    EXPECT_NEAR(surface.volume, 0.0, 1e-10 * balls.volume);
  });
}

}  // namespace
}  // namespace orthoball
