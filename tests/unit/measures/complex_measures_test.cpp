// SPDX-License-Identifier: MIT
#include "orthoball/measures/complex_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "orthoball/filtration/filter_steps.h"
#include "orthoball/measures/contribution_stream.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(std::vector<double> coordinates) {
  return Filtration<D>(
      regular_triangulation<D>(WeightedPoints(D, std::move(coordinates), WeightKind::none, {})));
}

TEST(HullMeasures, OfCoplanarSitesInSpaceHaveBothSides) {
  const HullMeasures hull =
      hull_measures(filtration_of<3>({0, 0, 7, 2, 0, 7, 0, 2, 7, 2, 2, 7, 1, 1, 7}));
  EXPECT_EQ(hull.volume, 0.0);
  EXPECT_EQ(hull.area, 8.0);
}

TEST(HullMeasures, OfALineInThePlaneHaveBothSides) {
  EXPECT_EQ(hull_measures(filtration_of<2>({0, 0, 3, 4})).area, 10.0);
  EXPECT_EQ(hull_measures(filtration_of<3>({0, 0, 0, 3, 4, 0})).area, 0.0);
}

TEST(HullMeasures, OfNothingAndOfOnePointAreZero) {
  EXPECT_EQ(hull_measures(Filtration<3>()).area, 0.0);
  EXPECT_EQ(hull_measures(filtration_of<2>({1, 2})).area, 0.0);
}

TEST(HullMeasures, BeyondTheDoubleRangeAreInfinite) {
  const HullMeasures hull = hull_measures(filtration_of<2>({0, 0, 1e200, 0, 0, 1e200}));
  EXPECT_EQ(hull.volume, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(hull.area / 1e200, 2 + std::sqrt(2.0), 1e-15);
}

TEST(MeasureScan, AgreesWithTheBoxAcrossWindows) {
  // More triangles than fit into one window of a stream.
  constexpr std::size_t kPoints = 85000;
  std::vector<double> points;
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
    for (const int axis : {0, 1, 2}) points.push_back((corner >> axis & 1) != 0 ? 1.0 : -1.0);
  }
  std::uint64_t state = 1;
  while (points.size() < 3 * kPoints) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    points.push_back(static_cast<double>(state >> 11U) * 0x1p-52 - 1.0);
  }
  const Filtration<3> filtration = filtration_of<3>(points);
  ASSERT_GT(filtration.count(2), (ContributionStream<3, FacetContribution>::kWindow));
  FilterSteps<3> steps(filtration);
  MeasureScan<3> scan(filtration);
  double volume = 0.0;
  while (steps.next()) {
    scan.advance(steps.entering());
    const ComplexMeasures measures = scan.measures();
    ASSERT_GE(measures.volume, volume);
    ASSERT_GE(measures.area_singular, 0.0);
    ASSERT_GE(measures.area_regular, 0.0);
    volume = measures.volume;
  }
  const ComplexMeasures whole = scan.measures();
  EXPECT_NEAR(whole.volume / 8, 1.0, 1e-13);
  EXPECT_NEAR(whole.area / 24, 1.0, 1e-13);
  EXPECT_NEAR(whole.length / (12 * std::numbers::pi), 1.0, 1e-12);
  EXPECT_EQ(whole.area_singular, 0.0);
  const HullMeasures hull = hull_measures(filtration);
  EXPECT_EQ(hull.volume, whole.volume);
  EXPECT_EQ(hull.area, whole.area);
}

}  // namespace
}  // namespace orthoball
