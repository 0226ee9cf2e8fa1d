// SPDX-License-Identifier: MIT
#include "orthoball/points/subsample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/error.h"

namespace orthoball {
namespace {

using generators::PointFamily;

// The sites, sorted.
std::vector<std::vector<double>> sites(const WeightedPoints& points) {
  std::vector<std::vector<double>> result;
  for (std::size_t row = 0; row < points.size(); ++row) {
    std::vector<double> site;
    for (int axis = 0; axis < points.dimension(); ++axis) {
      site.push_back(points.coordinate(row, axis));
    }
    site.push_back(points.weight(row));
    result.push_back(site);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Subsample, TakesItsShareOfTheSitesAndNothingElse) {
  const auto points = generators::points_of(PointFamily::protein_like, 3, 101, 1);
  const auto all = sites(points), some = sites(subsample(points, 0.8, 1));
  EXPECT_EQ(some.size(), 81U);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
  EXPECT_EQ(subsample(points, 0.8, 1).decimals(), points.decimals());
  EXPECT_EQ(sites(subsample(points, 1.0, 1)), all);
}

TEST(Subsample, DependsOnTheSeedAndNotOnTheOrderOfRows) {
  const auto points = generators::points_of(PointFamily::gaussian, 3, 100, 2);
  const auto others =
      generators::with_rows(points, generators::random_permutation(points.size(), 3));
  EXPECT_EQ(sites(subsample(points, 0.5, 7)), sites(subsample(others, 0.5, 7)));
  EXPECT_NE(sites(subsample(points, 0.5, 7)), sites(subsample(points, 0.5, 8)));
}

TEST(Subsample, OfNoSitesIsNone) { EXPECT_EQ(subsample(WeightedPoints(3), 0.5, 1).size(), 0U); }

TEST(Subsample, RefusesAShareThatIsNone) {
  const WeightedPoints points(2);
  EXPECT_THROW((void)subsample(points, 0.0, 1), InputError);
  EXPECT_THROW((void)subsample(points, 1.5, 1), InputError);
}

}  // namespace
}  // namespace orthoball
