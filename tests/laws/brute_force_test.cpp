// SPDX-License-Identifier: MIT
// The oracle against other definitions of the same things, before it judges anything else.
#include "oracles/brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "generators/point_families.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::points_of;
using oracles::brute_force;
using oracles::BruteForce;
using oracles::BruteSimplex;

// A few sites of every family in both dimensions.
template <class Check>
void for_each_case(const Check& check) {
  for (const PointFamily family : generators::point_families()) {
    for (int dimension = 2; dimension <= 3; ++dimension) {
      for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const std::size_t count = 3 + seed % 6;
        SCOPED_TRACE(std::string(name(family)) + " dimension " + std::to_string(dimension) +
                     " count " + std::to_string(count) + " seed " + std::to_string(seed));
        check(points_of(family, dimension, count, seed));
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(BruteForce, FindsTheCellsThatLoweredWeightsGive) {
  for_each_case([](const WeightedPoints& points) {
    const BruteForce result = brute_force(points);
    std::vector<std::vector<std::uint32_t>> cells;
    for (const BruteSimplex& simplex : result.simplices) {
      if (simplex.dimension() == result.affine_dimension) cells.push_back(simplex.rows);
    }
    std::sort(cells.begin(), cells.end());
    EXPECT_EQ(cells, oracles::cells_by_lowered_weights(points));
  });
}

TEST(BruteForce, HidesTheSitesWithoutPowerCell) {
  for_each_case([](const WeightedPoints& points) {
    EXPECT_EQ(brute_force(points).hidden, oracles::sites_without_power_cell(points));
  });
}

TEST(BruteForce, KnowsThePublishedFiltrationOfFiveWeightedPoints) {
  // A documented example of CGAL and GUDHI: site 4 lies on the face between two power cells.
  const BruteForce result = brute_force({3,
                                         {1, -1, -1, -1, 1, -1, -1, -1, 1, 1, 1, 1, 2, 2, 2},
                                         WeightKind::weight,
                                         {4, 4, 4, 4, 1}});
  EXPECT_EQ(result.simplices.size(), 29U);
  const std::vector<oracles::Rational> expected{-4, -2, oracles::Rational(-4, 3), -1, 23, 95};
  EXPECT_EQ(result.spectrum, expected);
}

TEST(NearestDouble, RoundsTiesToEvenAndKnowsTheEndsOfTheRange) {
  using oracles::Integer, oracles::nearest_double, oracles::Rational;
  EXPECT_EQ(nearest_double(Rational(1, 3)), 1.0 / 3.0);
  EXPECT_EQ(nearest_double(Rational(-2, 7)), -2.0 / 7.0);
  EXPECT_EQ(nearest_double(Rational((Integer(1) << 53) + 1)), 0x1p53);
  EXPECT_EQ(nearest_double(Rational((Integer(1) << 53) + 3)), 0x1p53 + 4);
  EXPECT_EQ(nearest_double(Rational(3, Integer(1) << 1075)), 2 * 0x1p-1074);
  EXPECT_EQ(nearest_double(Rational(1, Integer(1) << 1075)), 0.0);
  EXPECT_EQ(nearest_double(Rational(Integer(1) << 1023)), 0x1p1023);
  EXPECT_EQ(nearest_double(Rational(Integer(1) << 1024)), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace orthoball
