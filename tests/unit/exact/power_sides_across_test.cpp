// SPDX-License-Identifier: MIT
#include "orthoball/exact/power_sides_across.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "oracles/exact_predicates.h"
#include "orthoball/exact/orient.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using tuples::sites_of;

struct Tally {
  int asked = 0;
  int known = 0;
};

// Any corners, positively oriented, with any apexes, whether neighbours look like this or not.
template <int D>
Tally check_sides(const WeightedPoints& points, std::uint64_t seed, int count) {
  Tally tally;
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const auto rows = tuples::any_rows<2 * D + 3>(random, points.size());
    const std::uint32_t query = rows.back();
    Corners<D> corners, apexes;
    std::copy_n(rows.begin(), D + 1, corners.begin());
    std::copy_n(rows.begin() + D + 1, D + 1, apexes.begin());
    const GlancedSides sides = glanced_power_sides_across(sites, corners, apexes, query);
    EXPECT_LT(sides.known, 1U << (D + 1));
    for (std::size_t facet = 0; facet <= D; ++facet) {
      ++tally.asked;
      if ((sides.known >> facet & 1U) == 0) continue;
      ++tally.known;
      // With the apex in the place of the corner, and turned over.
      Corners<D> neighbour = corners;
      neighbour[facet] = apexes[facet];
      std::swap(neighbour[facet == 0 ? 1 : 0], neighbour[facet == D ? D - 1 : D]);
      const Sign sign = oracles::sign_of(oracles::power_determinant(truth, neighbour, query));
      EXPECT_EQ((sides.positive >> facet & 1U) != 0 ? Sign::positive : Sign::negative, sign);
    }
  }
  return tally;
}

TEST(PowerSidesAcross, IsTheSignOfTheDeterminantWhereItIsKnown) {
  if (!can_glance_across()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      check_sides<2>(points_of(family, 2, 25, seed), seed, 60);
      check_sides<3>(points_of(family, 3, 25, seed), seed, 60);
    }
  }
}

TEST(PowerSidesAcross, LeavesLittleOpenOnSitesInGeneralPosition) {
  if (!can_glance_across()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const PointFamily family : {PointFamily::uniform, PointFamily::uniform_balls}) {
    const Tally plane = check_sides<2>(points_of(family, 2, 200, 1), 1, 2000);
    EXPECT_GT(plane.known, 0.999 * plane.asked);
    const Tally space = check_sides<3>(points_of(family, 3, 200, 1), 1, 2000);
    EXPECT_GT(space.known, 0.999 * space.asked);
  }
}

TEST(PowerSidesAcross, ClaimsNothingFalseOfNumbersOfAnySize) {
  if (!can_glance_across()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const WeightedPoints points(
      3, {most, 0, -most, 0, 1e300, 1,     least,  least, 0,     -most, 1, 2, 1e200, 1e-200, 3,
          5,    6, 7,     0, 0,     least, 1e-160, 0,     1e160, 1,     1, 1, 3,     1e-9,   4},
      WeightKind::radius, {most, 1e200, least, 0, 1, -most, -3e-320, 2, 0, 1e-160});
  check_sides<3>(points, 1, 1000);
}

TEST(PowerSidesAcross, LeavesTiesOpen) {
  const Sites<2> square = tuples::sites_at<2>({0, 0, 4, 0, 0, 4, 4, 4, 2, 9, 9, 2});
  const GlancedSides plane = glanced_power_sides_across(square, {0, 1, 2}, {3, 4, 5}, 3);
  EXPECT_EQ(plane.known & 0b001U, 0U);
  const Sites<3> cube =
      tuples::sites_at<3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1, 1, 1, 1, 1});
  EXPECT_EQ(glanced_power_sides_across(cube, {0, 1, 2, 3}, {4, 5, 6, 5}, 7).known, 0U);
}

}  // namespace
}  // namespace orthoball
