// SPDX-License-Identifier: MIT
#include "orthoball/measures/measure_scan.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// The corners of the cube [-1, 1]^3, then points inside it.
std::vector<double> points_of_cube(std::size_t count) {
  std::vector<double> points;
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
    for (const int axis : {0, 1, 2}) points.push_back((corner >> axis & 1) != 0 ? 1.0 : -1.0);
  }
  std::uint64_t state = 1;
  while (points.size() < 3 * count) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    points.push_back(static_cast<double>(state >> 11U) * 0x1p-52 - 1.0);
  }
  return points;
}

Filtration<3> filtration_of(std::vector<double> points) {
  return Filtration<3>(
      regular_triangulation<3>(WeightedPoints(3, std::move(points), WeightKind::none, {})));
}

struct Totals {
  std::uint32_t edges = 0, facets = 0, interior = 0, cells = 0;
};

// Goes to the last index; `facets_last` are those of the hull.
ComplexMeasures last_measures(const Filtration<3>& filtration, Threads threads, Totals& totals) {
  const FacetRoles<3> roles(filtration, threads);
  MeasureScan<3> scan(filtration, roles, threads);
  ComplexMeasures last;
  std::uint32_t next = 0;
  double volume = 0.0;
  while (scan.next()) {
    EXPECT_EQ(scan.first_index(), next);
    next = scan.end_index();
    for (std::uint32_t index = scan.first_index(); index < next; ++index) {
      const std::uint32_t place = index - scan.first_index();
      totals.edges += scan.entering(1)[place];
      totals.facets += scan.entering(2)[place];
      totals.cells += scan.entering(3)[place];
      totals.interior += scan.becoming_interior()[place];
      const std::uint32_t regular_ever = 4 * totals.cells - totals.interior;
      const MeasureScan<3>::FacetCounts facets{totals.facets - regular_ever,
                                               regular_ever - totals.interior};
      scan.measures(index, {&facets, 1}, {&last, 1});
      EXPECT_GE(last.volume, volume);
      EXPECT_GE(last.area_singular, 0.0);
      EXPECT_GE(last.area_regular, 0.0);
      volume = last.volume;
    }
  }
  EXPECT_EQ(next, filtration.spectrum_size() + 1);
  return last;
}

TEST(MeasureScan, AgreesWithTheCubeAcrossWindows) {
  // More terms than fit into one window, and more indices than into one stretch.
  const Filtration<3> filtration = filtration_of(points_of_cube(30000));
  ASSERT_GT(filtration.spectrum_size(), 16 * kIndexStretch);
  for (const unsigned threads : {1U, 3U}) {
    Totals totals;
    const ComplexMeasures whole = last_measures(filtration, Threads(threads), totals);
    EXPECT_NEAR(whole.volume / 8, 1.0, 1e-13);
    EXPECT_NEAR(whole.area / 24, 1.0, 1e-13);
    EXPECT_NEAR(whole.length / (12 * std::numbers::pi), 1.0, 1e-13);
    EXPECT_EQ(whole.area_singular, 0.0);
    const HullMeasures hull = hull_measures(filtration);
    EXPECT_EQ(hull.volume, whole.volume);
    EXPECT_EQ(hull.area, whole.area);
    EXPECT_EQ(totals.edges, filtration.count(1));
    EXPECT_EQ(totals.facets, filtration.count(2));
    EXPECT_EQ(totals.cells, filtration.count(3));
  }
}

TEST(MeasureScan, TakesManyTermsOfOneStretchInRounds) {
  // 21^3 points of a grid: far more terms than a small window has, at few indices.
  std::vector<double> points;
  constexpr int kSide = 20;
  for (int x = 0; x <= kSide; ++x) {
    for (int y = 0; y <= kSide; ++y) {
      for (int z = 0; z <= kSide; ++z) {
        for (const int c : {x, y, z}) points.push_back(c);
      }
    }
  }
  const Filtration<3> filtration = filtration_of(points);
  ASSERT_LT(filtration.spectrum_size(), kIndexStretch);
  Totals totals;
  const ComplexMeasures whole = last_measures(filtration, Threads(1), totals);
  EXPECT_EQ(whole.volume, kSide * kSide * kSide);
  EXPECT_EQ(whole.area, 6 * kSide * kSide);
  EXPECT_NEAR(whole.length / (6 * std::numbers::pi * kSide), 1.0, 1e-13);
  EXPECT_EQ(totals.edges, filtration.count(1));
  EXPECT_EQ(totals.cells, filtration.count(3));
}

}  // namespace
}  // namespace orthoball
