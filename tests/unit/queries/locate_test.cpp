// SPDX-License-Identifier: MIT
#include "orthoball/queries/locate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/queries/containment.h"
#include "orthoball/queries/edited_shape.h"
#include "orthoball/queries/regions.h"
#include "unit/queries/filtration_of.h"

namespace orthoball {
namespace {

WeightedPoints plain(int dimension, std::vector<double> coordinates) {
  return {dimension, std::move(coordinates), WeightKind::none, {}};
}

TEST(Locate, TellsRegionSimplexAndNearestPoint) {
  // A large triangle, a small one, an edge.
  const auto filtration =
      filtration_of<2>(plain(2, {0, 0, 4, 0, 0, 4, 100, 0, 102, 0, 100, 2, 200, 0, 201, 0}));
  const AlphaComplex<2> complex(filtration, filtration.index(8.0));
  const auto found =
      locate(complex, plain(2, {1, 1, 101, 0.5, 200.5, 0, 200.5, 1, 50, 1, -5, 0, 4, 0}));
  std::vector<std::uint32_t> numbers;
  for (const auto& one : found) numbers.push_back(one.region);
  EXPECT_EQ(numbers, (std::vector<std::uint32_t>{1, 2, 3, 0, 0, 0, 1}));
  EXPECT_EQ(found[0].nearest.distance, 1.0);
  EXPECT_EQ(found[2].nearest.distance, 0.0);
  EXPECT_EQ(found[3].nearest.distance, 1.0);
  EXPECT_TRUE(found[4].simplex.exists());
  EXPECT_FALSE(found[5].simplex.exists());
  EXPECT_EQ(found[5].nearest.distance, 5.0);
  EXPECT_EQ(filtration.dimension(found[6].simplex), 0);
}

TEST(Locate, RefusesPointsOfAnotherDimension) {
  const auto filtration = filtration_of<2>(plain(2, {0, 0, 1, 0}));
  EXPECT_THROW((void)locate(AlphaComplex<2>(filtration, 1), plain(3, {0, 0, 0})), InputError);
}

template <int D>
void expect_each(const WeightedPoints& points, std::uint64_t seed) {
  const auto filtration = filtration_of<D>(points);
  generators::Random random(seed);
  std::vector<double> coordinates;
  for (std::size_t i = 0; i < 3 * points.size(); ++i) {
    const auto row =
        static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1));
    for (int axis = 0; axis < D; ++axis) {
      const double factor = i % 3 == 0 ? 1.0 : random.uniform(0.6, 1.4);
      coordinates.push_back(points.coordinate(row, axis) * factor);
    }
  }
  const WeightedPoints queries = plain(D, coordinates);
  for (const std::uint32_t part : {3U, 6U, 8U}) {
    const std::uint32_t index = filtration.spectrum_size() * part / 8;
    for (const ShapeEdits& edits : {ShapeEdits{}, ShapeEdits{.regularized = true}}) {
      const auto complex = edited_shape(filtration, index, edits).complex;
      const auto found = locate(complex, queries);
      const auto simplices = simplices_at(filtration, queries);
      const auto parts = regions(complex, JoinedBy::vertices);
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].simplex, simplices[i]);
        std::uint32_t region = 0;
        if (found[i].simplex.exists() && complex.contains(found[i].simplex)) {
          const SiteId row = filtration.rows(found[i].simplex)[0];
          while (!std::binary_search(parts[region].rows.begin(), parts[region].rows.end(), row)) {
            ++region;
          }
          ++region;
        }
        ASSERT_EQ(found[i].region, region);
      }
    }
  }
}

TEST(Locate, AgreesWithContainmentAndRegions) {
  for (const auto family : generators::point_families()) {
    SCOPED_TRACE(generators::name(family));
    if (generators::is_extreme(family)) continue;
    expect_each<2>(generators::points_of(family, 2, 60, 2), 5);
    expect_each<3>(generators::points_of(family, 3, 60, 2), 6);
  }
}

}  // namespace
}  // namespace orthoball
