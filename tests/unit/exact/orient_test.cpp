// SPDX-License-Identifier: MIT
#include "orthoball/exact/orient.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "oracles/exact_predicates.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using tuples::sites_at;
using tuples::sites_of;

constexpr double kUlp = std::numeric_limits<double>::epsilon();

template <int A>
constexpr std::array<int, std::size_t{A}> first_axes() {
  std::array<int, std::size_t{A}> axes{};
  std::iota(axes.begin(), axes.end(), 0);
  return axes;
}

template <int A, int D>
Stage stage_of(const Sites<D>& sites, const Corners<A>& corners) {
  return deciding_stage(filtered_orient<A, D>(sites, corners));
}

TEST(Orient, IsPositiveForTheSimplexOfTheAxes) {
  EXPECT_EQ((orient<1, 2>(sites_at<2>({0, 0, 1, 0}), {0, 1})), Sign::positive);
  EXPECT_EQ((orient<2, 2>(sites_at<2>({0, 0, 1, 0, 0, 1}), {0, 1, 2})), Sign::positive);
  EXPECT_EQ((orient<3, 3>(sites_at<3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}), {0, 1, 2, 3})),
            Sign::positive);
}

// All families, all dimensions of simplices: the sign is that of the determinant in integers, the
// exact stage agrees, and the filter is right whenever it answers.
template <int A, int D>
void check_signs(const WeightedPoints& points, std::uint64_t seed, int count) {
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Corners<A> corners = tuples::any_rows<A + 1>(random, points.size());
    const Sign sign = oracles::sign_of(oracles::orientation(truth, corners, first_axes<A>()));
    EXPECT_EQ((orient<A, D>(sites, corners)), sign);
    EXPECT_EQ((exact_orient<A, D>(sites, corners, first_axes<A>())), sign);
    const FilteredDeterminant filtered = filtered_orient<A, D>(sites, corners);
    const Sign shown = Sign((filtered.value > 0) - (filtered.value < 0));
    if (deciding_stage(filtered) != Stage::exact) {
      EXPECT_EQ(shown, sign);
    }
  }
}

TEST(Orient, IsTheSignOfTheDeterminantOnEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      const WeightedPoints flat = points_of(family, 2, 25, seed);
      const WeightedPoints solid = points_of(family, 3, 25, seed);
      check_signs<1, 2>(flat, seed, 20);
      check_signs<2, 2>(flat, seed, 60);
      check_signs<1, 3>(solid, seed, 20);
      check_signs<2, 3>(solid, seed, 60);
      check_signs<3, 3>(solid, seed, 60);
    }
  }
}

TEST(Orient, ReadsTheAxesItIsGiven) {
  const WeightedPoints points = points_of(PointFamily::lattice, 3, 20, 1);
  const Sites<3> sites = sites_of<3>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  Random random(1);
  for (const std::array<int, 2> axes : {std::array{0, 1}, {0, 2}, {1, 2}, {2, 0}}) {
    for (int i = 0; i < 50; ++i) {
      const Corners<2> corners = tuples::any_rows<3>(random, points.size());
      EXPECT_EQ((exact_orient<2, 3>(sites, corners, axes)),
                oracles::sign_of(oracles::orientation(truth, corners, axes)));
    }
  }
  for (const int axis : {0, 1, 2}) {
    const Corners<1> corners{0, 7};
    EXPECT_EQ((exact_orient<1, 3>(sites, corners, {axis})),
              oracles::sign_of(oracles::orientation(truth, corners, std::array{axis})));
  }
}

TEST(Orient, SwappingTwoCornersFlipsTheSign) {
  Random random(7);
  for (const PointFamily family : {PointFamily::uniform, PointFamily::one_ulp, PointFamily::lattice,
                                   PointFamily::mixed_scales}) {
    const Sites<3> sites = sites_of<3>(points_of(family, 3, 20, 3));
    for (int i = 0; i < 100; ++i) {
      const Corners<3> corners = tuples::any_rows<4>(random, sites.size());
      const Sign sign = orient<3, 3>(sites, corners);
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          Corners<3> swapped = corners;
          std::swap(swapped[a], swapped[b]);
          EXPECT_EQ((orient<3, 3>(sites, swapped)), -sign);
        }
      }
    }
  }
}

TEST(Orient, DecidesWellShapedSimplicesByTheFilter) {
  const Sites<2> sites = sites_at<2>({0.1, 0.2, 0.7, 0.1, 0.3, 0.9});
  EXPECT_EQ((orient<2, 2>(sites, {0, 1, 2})), Sign::positive);
  EXPECT_EQ((stage_of<2, 2>(sites, {0, 1, 2})), Stage::filter);
}

TEST(Orient, DecidesSmallIntegersWithoutTheExactStage) {
  const Sites<3> sites = sites_at<3>({0, 0, 0, 1, 2, 3, 2, 4, 6, -3, 1, 5});
  EXPECT_EQ((orient<3, 3>(sites, {0, 1, 2, 3})), Sign::zero);
  EXPECT_EQ((stage_of<3, 3>(sites, {0, 1, 2, 3})), Stage::integers);
  // Quarters are integers in another unit.
  const Sites<2> quarters = sites_at<2>({0.25, 0.5, 0.75, 1.0, 1.25, 1.5});
  EXPECT_EQ((orient<2, 2>(quarters, {0, 1, 2})), Sign::zero);
  EXPECT_EQ((stage_of<2, 2>(quarters, {0, 1, 2})), Stage::integers);
}

TEST(Orient, DecidesIntegersOfSixteenBitsWithoutTheExactStage) {
  Random random(3);
  std::vector<double> coordinates;
  for (int i = 0; i < 300; ++i) coordinates.push_back(random.integer(0, (1 << 16) - 1));
  coordinates.insert(coordinates.end(), {0, 0, 0, 65535, 65535, 65535});
  const Sites<3> sites = sites_at<3>(coordinates);
  for (int i = 0; i < 500; ++i) {
    EXPECT_NE((stage_of<3, 3>(sites, tuples::any_rows<4>(random, sites.size()))), Stage::exact);
  }
}

TEST(Orient, LeavesLargeIntegersOnALineToTheExactStage) {
  const double side = 0x1p+40;
  const Sites<2> sites = sites_at<2>({0, 1, side, 1 + side, 2 * side - 1, 2 * side});
  EXPECT_TRUE(sites.is_integral());
  EXPECT_EQ((orient<2, 2>(sites, {0, 1, 2})), Sign::zero);
  EXPECT_EQ((stage_of<2, 2>(sites, {0, 1, 2})), Stage::exact);
}

TEST(Orient, NeedsTheExactStageOneUlpOffTheLine) {
  for (const double off : {-1.0, 0.0, 1.0}) {
    const double y = 0.5 + 0.5 * kUlp * off;
    const Sites<2> sites = sites_at<2>({0.1, 0.1, 1.1, 1.1, 0.5, y});
    EXPECT_EQ((orient<2, 2>(sites, {0, 1, 2})), Sign(static_cast<int>(off)));
    EXPECT_EQ((stage_of<2, 2>(sites, {0, 1, 2})), Stage::exact);
  }
}

// The grid of Kettner and others: points one ulp apart around a line, where naive determinants show
// patterns of wrong signs. The sign must be monotone along rows and columns.
TEST(Orient, DividesAGridOfUlpsAlongTheLine) {
  constexpr int kSide = 32;
  std::vector<double> coordinates{12.0, 12.0, 24.0, 24.0};
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      coordinates.insert(coordinates.end(), {0.5 + 0.5 * kUlp * i, 0.5 + 0.5 * kUlp * j});
    }
  }
  const Sites<2> sites = sites_at<2>(coordinates);
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const auto site = static_cast<std::uint32_t>(2 + kSide * i + j);
      EXPECT_EQ((orient<2, 2>(sites, {0, 1, site})), Sign((j > i) - (j < i)));
    }
  }
}

TEST(Orient, KeepsSignAndStageWhenScaledByAPowerOfTwo) {
  for (const PointFamily family : {PointFamily::uniform, PointFamily::one_ulp, PointFamily::grid}) {
    const WeightedPoints points = points_of(family, 3, 40, 2);
    const Sites<3> sites = sites_of<3>(points);
    for (const int exponent : {-500, -30, 1, 30, 500}) {
      const Sites<3> scaled = sites_of<3>(generators::scaled_by_power_of_two(points, exponent));
      Random random(5);
      for (int i = 0; i < 100; ++i) {
        const Corners<3> corners = tuples::any_rows<4>(random, sites.size());
        EXPECT_EQ((orient<3, 3>(scaled, corners)), (orient<3, 3>(sites, corners)));
        EXPECT_EQ((stage_of<3, 3>(scaled, corners)), (stage_of<3, 3>(sites, corners)));
      }
    }
  }
}

TEST(Orient, IsExactBesideNumbersOfAnySize) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  const Sites<2> sites = sites_at<2>({-most, 0, most, 0, 0, least, 0, -least, 1, 0});
  EXPECT_EQ((orient<2, 2>(sites, {0, 1, 2})), Sign::positive);
  EXPECT_EQ((orient<2, 2>(sites, {0, 1, 3})), Sign::negative);
  EXPECT_EQ((orient<2, 2>(sites, {0, 1, 4})), Sign::zero);
  EXPECT_EQ((orient<1, 2>(sites, {2, 3})), Sign::zero);
}

// Share of random tuples that the doubles leave to the exact stage.
template <int A, int D>
double share_undecided(const WeightedPoints& points) {
  const Sites<D> sites = sites_of<D>(points);
  Random random(11);
  constexpr int kTrials = 20000;
  int undecided = 0;
  for (int i = 0; i < kTrials; ++i) {
    const Corners<A> corners = tuples::any_rows<A + 1>(random, sites.size());
    undecided += stage_of<A, D>(sites, corners) == Stage::exact ? 1 : 0;
  }
  return static_cast<double>(undecided) / kTrials;
}

TEST(Orient, SeldomGivesUp) {
  EXPECT_EQ((share_undecided<2, 2>(points_of(PointFamily::uniform, 2, 1000, 1))), 0.0);
  EXPECT_EQ((share_undecided<3, 3>(points_of(PointFamily::uniform, 3, 1000, 1))), 0.0);
  EXPECT_EQ((share_undecided<3, 3>(tuples::on_sphere(3, 1000, 1))), 0.0);
  EXPECT_EQ((share_undecided<2, 2>(points_of(PointFamily::grid, 2, 10000, 1))), 0.0);
  EXPECT_EQ((share_undecided<3, 3>(points_of(PointFamily::grid, 3, 10000, 1))), 0.0);
  EXPECT_EQ((share_undecided<3, 3>(points_of(PointFamily::protein_like, 3, 1000, 1))), 0.0);
  // Two ulps wide: the doubles are right to answer seldom, and never wrong (above).
  EXPECT_LT((share_undecided<2, 2>(points_of(PointFamily::one_ulp, 2, 1000, 1))), 1.0);
}

}  // namespace
}  // namespace orthoball
