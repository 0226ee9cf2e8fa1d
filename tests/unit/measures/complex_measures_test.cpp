// SPDX-License-Identifier: MIT
#include "orthoball/measures/complex_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

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

}  // namespace
}  // namespace orthoball
