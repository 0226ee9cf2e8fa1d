// SPDX-License-Identifier: MIT
#include "orthoball/exact/power_side.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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

template <int A, int D>
Stage stage_of(const Sites<D>& sites, const Corners<A>& corners, std::uint32_t query) {
  return deciding_stage(filtered_power_side<A, D>(sites, corners, query));
}

TEST(PowerSide, IsPositiveInsideTheOrthosphereOfAPositiveSimplex) {
  const Sites<2> flat = sites_at<2>({0, 0, 4, 0, 0, 4, 1, 1, 9, 9, 4, 4});
  EXPECT_EQ((power_side<2, 2>(flat, {0, 1, 2}, 3)), Sign::positive);
  EXPECT_EQ((power_side<2, 2>(flat, {0, 1, 2}, 4)), Sign::negative);
  EXPECT_EQ((power_side<2, 2>(flat, {0, 1, 2}, 5)), Sign::zero);
  const Sites<3> solid =
      sites_at<3>({0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 1, 1, 1, 9, 9, 9, 4, 4, 4});
  EXPECT_EQ((power_side<3, 3>(solid, {0, 1, 2, 3}, 4)), Sign::positive);
  EXPECT_EQ((power_side<3, 3>(solid, {0, 1, 2, 3}, 5)), Sign::negative);
  EXPECT_EQ((power_side<3, 3>(solid, {0, 1, 2, 3}, 6)), Sign::zero);
  const Sites<2> line = sites_at<2>({0, 0, 4, 0, 1, 0, 9, 0});
  EXPECT_EQ((power_side<1, 2>(line, {0, 1}, 2)), Sign::positive);
  EXPECT_EQ((power_side<1, 2>(line, {0, 1}, 3)), Sign::negative);
}

TEST(PowerSide, LetsAHeavySiteInAndALightOneOut) {
  // At (4, 4), on the circle of the others where it weighs as much as they do.
  for (const int weight : {-1, 0, 1}) {
    const Sites<2> sites = sites_of<2>(
        {2, {0, 0, 4, 0, 0, 4, 4, 4}, WeightKind::weight, {0, 0, 0, static_cast<double>(weight)}});
    EXPECT_EQ((power_side<2, 2>(sites, {0, 1, 2}, 3)), Sign(weight));
  }
}

template <int A, int D>
void check_signs(const WeightedPoints& points, std::uint64_t seed, int count) {
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const auto rows = tuples::any_rows<A + 2>(random, points.size());
    const std::uint32_t query = rows.back();
    Corners<A> corners;
    std::copy_n(rows.begin(), A + 1, corners.begin());
    const Sign sign = oracles::sign_of(oracles::power_determinant(truth, corners, query));
    EXPECT_EQ((power_side<A, D>(sites, corners, query)), sign);
    EXPECT_EQ((exact_power_side<A, D>(sites, corners, query)), sign);
    const FilteredDeterminant filtered = filtered_power_side<A, D>(sites, corners, query);
    const Sign shown = Sign((filtered.value > 0) - (filtered.value < 0));
    if (deciding_stage(filtered) != Stage::exact) {
      EXPECT_EQ(shown, sign);
    }
  }
}

TEST(PowerSide, IsTheSignOfTheDeterminantOnEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      const WeightedPoints flat = points_of(family, 2, 25, seed);
      const WeightedPoints solid = points_of(family, 3, 25, seed);
      check_signs<1, 2>(flat, seed, 20);
      check_signs<2, 2>(flat, seed, 60);
      check_signs<1, 3>(solid, seed, 20);
      check_signs<2, 3>(solid, seed, 40);
      check_signs<3, 3>(solid, seed, 60);
    }
  }
}

TEST(PowerSide, IsTheSignOfTheDeterminantOnNumbersOfAnySize) {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const WeightedPoints points(3, {most, 0,     -most,  0, 1e300, 1, least, least, 0, -most, 1,
                                  2,    1e200, 1e-200, 3, 5,     6, 7,     0,     0, least},
                              WeightKind::radius, {most, 1e200, least, 0, 1, -most, -3e-320});
  check_signs<3, 3>(points, 1, 300);
  check_signs<2, 3>(points, 1, 100);
  check_signs<1, 3>(points, 1, 100);
}

TEST(PowerSide, SwappingTwoCornersFlipsTheSign) {
  Random random(7);
  for (const PointFamily family :
       {PointFamily::uniform_balls, PointFamily::one_ulp, PointFamily::lattice}) {
    const Sites<3> sites = sites_of<3>(points_of(family, 3, 20, 3));
    for (int i = 0; i < 100; ++i) {
      const auto [a, b, c, d, q] = tuples::any_rows<5>(random, sites.size());
      const Sign sign = power_side<3, 3>(sites, {a, b, c, d}, q);
      EXPECT_EQ((power_side<3, 3>(sites, {b, a, c, d}, q)), -sign);
      EXPECT_EQ((power_side<3, 3>(sites, {a, c, b, d}, q)), -sign);
      EXPECT_EQ((power_side<3, 3>(sites, {a, b, d, c}, q)), -sign);
      EXPECT_EQ((power_side<3, 3>(sites, {b, c, d, a}, q)), -sign);
      EXPECT_EQ((power_side<3, 3>(sites, {b, a, d, c}, q)), sign);
      // The lower hull of the lifted sites knows no query: exchanging it with a corner flips too.
      EXPECT_EQ((power_side<3, 3>(sites, {q, b, c, d}, a)), -sign);
      EXPECT_EQ((power_side<3, 3>(sites, {a, b, c, q}, d)), -sign);
    }
  }
}

TEST(PowerSide, DoesNotChangeWhenAllWeightsGrowAlike) {
  const WeightedPoints points = points_of(PointFamily::lattice, 3, 30, 4);
  std::vector<double> coordinates(points.coordinates().begin(), points.coordinates().end());
  std::vector<double> weights, heavier;
  Random random(1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    weights.push_back(random.integer(-4, 4));
    heavier.push_back(weights.back() + 0x1p+40);
  }
  const Sites<3> light = sites_of<3>({3, coordinates, WeightKind::weight, weights});
  const Sites<3> heavy = sites_of<3>({3, coordinates, WeightKind::weight, heavier});
  for (int i = 0; i < 200; ++i) {
    const auto [a, b, c, d, q] = tuples::any_rows<5>(random, points.size());
    EXPECT_EQ((power_side<3, 3>(light, {a, b, c, d}, q)),
              (power_side<3, 3>(heavy, {a, b, c, d}, q)));
  }
}

TEST(PowerSide, DecidesByTheCheapestStageThatCan) {
  const Sites<2> clear = sites_at<2>({0.1, 0.1, 0.9, 0.2, 0.3, 0.8, 0.4, 0.4});
  EXPECT_EQ((stage_of<2, 2>(clear, {0, 1, 2}, 3)), Stage::filter);
  const Sites<2> grid = sites_at<2>({0, 0, 4, 0, 0, 4, 4, 4});
  EXPECT_EQ((stage_of<2, 2>(grid, {0, 1, 2}, 3)), Stage::integers);
  // The unit circle through points that only nearly lie on it.
  const Sites<2> circle = sites_at<2>({0.6, 0.8, -0.8, 0.6, -0.6, -0.8, 0.8, -0.6});
  EXPECT_EQ((stage_of<2, 2>(circle, {0, 1, 2}, 3)), Stage::exact);
  // Cocircular integers of 26 bits: the doubles cannot see the zero.
  const double s = 0x1p+26;
  const Sites<2> large = sites_at<2>({0, 0, s, 0, 0, s - 1, s, s - 1});
  EXPECT_TRUE(large.is_integral());
  EXPECT_EQ((power_side<2, 2>(large, {0, 1, 2}, 3)), Sign::zero);
  EXPECT_EQ((stage_of<2, 2>(large, {0, 1, 2}, 3)), Stage::exact);
}

TEST(PowerSide, DecidesIntegersOfNineBitsWithoutTheExactStage) {
  Random random(3);
  std::vector<double> coordinates;
  for (int i = 0; i < 300; ++i) coordinates.push_back(random.integer(0, (1 << 9) - 1));
  coordinates.insert(coordinates.end(), {0, 0, 0, 511, 511, 511, 0, 511, 0, 511, 0, 511});
  const Sites<3> sites = sites_at<3>(coordinates);
  for (int i = 0; i < 1000; ++i) {
    const auto [a, b, c, d, q] = tuples::any_rows<5>(random, sites.size());
    EXPECT_NE((stage_of<3, 3>(sites, {a, b, c, d}, q)), Stage::exact);
  }
}

TEST(PowerSide, SeesOneUlpOffTheCircle) {
  // Corners on the axes at distance 1, the query beside the fourth one.
  for (const double off : {-1.0, 0.0, 1.0}) {
    const double y = off < 0 ? -1 + 0.5 * kUlp : off > 0 ? -1 - kUlp : -1.0;
    const Sites<2> sites = sites_at<2>({1, 0, 0, 1, -1, 0, 0, y});
    EXPECT_EQ((power_side<2, 2>(sites, {0, 1, 2}, 3)), Sign(static_cast<int>(-off)));
    EXPECT_EQ((stage_of<2, 2>(sites, {0, 1, 2}, 3)), off == 0.0 ? Stage::integers : Stage::exact);
  }
}

// Around a corner of a cube whose other corners give the sphere, one ulp apart.
TEST(PowerSide, DividesAGridOfUlpsByTheSphere) {
  std::vector<double> coordinates{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      for (int k = -2; k <= 2; ++k) {
        for (const int at : {i, j, k}) coordinates.push_back(1 + kUlp * at);
      }
    }
  }
  const WeightedPoints points(3, coordinates, WeightKind::none, {});
  const Sites<3> sites = sites_of<3>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  int zeros = 0;
  for (std::uint32_t query = 4; query < points.size(); ++query) {
    const Corners<3> corners{0, 1, 2, 3};
    const Sign sign = power_side<3, 3>(sites, corners, query);
    EXPECT_EQ(sign, oracles::sign_of(oracles::power_determinant(truth, corners, query)));
    zeros += sign == Sign::zero ? 1 : 0;
  }
  EXPECT_EQ(zeros, 1);  // the corner itself
}

TEST(PowerSide, SeesTheLastBitOfAWeight) {
  const double next = std::nextafter(0.1, 1.0);
  for (const auto& [radius, sign] : {std::pair{std::nextafter(0.1, 0.0), Sign::negative},
                                     {0.1, Sign::zero},
                                     {next, Sign::positive}}) {
    const Sites<2> sites =
        sites_of<2>({2, {0, 0, 4, 0, 0, 4, 4, 4}, WeightKind::radius, {0.1, 0.1, 0.1, radius}});
    EXPECT_EQ((power_side<2, 2>(sites, {0, 1, 2}, 3)), sign);
    EXPECT_EQ((stage_of<2, 2>(sites, {0, 1, 2}, 3)), Stage::exact);
  }
}

TEST(PowerSide, KeepsSignAndStageWhenScaledByAPowerOfTwo) {
  for (const PointFamily family :
       {PointFamily::uniform_balls, PointFamily::one_ulp, PointFamily::grid}) {
    const WeightedPoints points = points_of(family, 3, 40, 2);
    const Sites<3> sites = sites_of<3>(points);
    for (const int exponent : {-400, -30, 1, 30, 400}) {
      const Sites<3> scaled = sites_of<3>(generators::scaled_by_power_of_two(points, exponent));
      Random random(5);
      for (int i = 0; i < 100; ++i) {
        const auto [a, b, c, d, q] = tuples::any_rows<5>(random, sites.size());
        EXPECT_EQ((power_side<3, 3>(scaled, {a, b, c, d}, q)),
                  (power_side<3, 3>(sites, {a, b, c, d}, q)));
        EXPECT_EQ((stage_of<3, 3>(scaled, {a, b, c, d}, q)),
                  (stage_of<3, 3>(sites, {a, b, c, d}, q)));
      }
    }
  }
}

template <int D>
double share_undecided(const WeightedPoints& points) {
  const Sites<D> sites = sites_of<D>(points);
  Random random(11);
  constexpr int kTrials = 20000;
  int undecided = 0;
  for (int i = 0; i < kTrials; ++i) {
    const auto rows = tuples::any_rows<D + 2>(random, sites.size());
    Corners<D> corners;
    std::copy_n(rows.begin(), D + 1, corners.begin());
    undecided += stage_of<D, D>(sites, corners, rows.back()) == Stage::exact ? 1 : 0;
  }
  return static_cast<double>(undecided) / kTrials;
}

TEST(PowerSide, SeldomGivesUp) {
  EXPECT_EQ((share_undecided<2>(points_of(PointFamily::uniform, 2, 1000, 1))), 0.0);
  EXPECT_EQ((share_undecided<3>(points_of(PointFamily::uniform, 3, 1000, 1))), 0.0);
  EXPECT_EQ((share_undecided<3>(points_of(PointFamily::uniform_balls, 3, 1000, 1))), 0.0);
  EXPECT_EQ((share_undecided<3>(points_of(PointFamily::grid, 3, 10000, 1))), 0.0);
  const WeightedPoints tiny =
      generators::scaled_by_power_of_two(points_of(PointFamily::uniform, 3, 1000, 1), -300);
  EXPECT_EQ((share_undecided<3>(tiny)), 0.0);
  EXPECT_LT((share_undecided<3>(points_of(PointFamily::scan_like, 3, 1000, 1))), 0.001);
  EXPECT_LT((share_undecided<3>(points_of(PointFamily::protein_like, 3, 1000, 1))), 0.001);
}

// On a sphere every test is a tie or a last bit: all the doubles can do is say so.
TEST(PowerSide, GivesUpOnTheSphere) {
  EXPECT_GT((share_undecided<2>(tuples::on_sphere(2, 1000, 1))), 0.9);
  EXPECT_GT((share_undecided<3>(tuples::on_sphere(3, 1000, 1))), 0.9);
}

}  // namespace
}  // namespace orthoball
