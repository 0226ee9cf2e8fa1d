// SPDX-License-Identifier: MIT
#include "orthoball/exact/sites.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "oracles/exact_predicates.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using oracles::Rational;
using tuples::sites_of;

constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();

// Every number of `sites.exact` against the input, and of the approximate sites within their bound.
template <int D>
void check_numbers(const WeightedPoints& points) {
  const Sites<D> sites = sites_of<D>(points);
  oracles::ExactPoints truth = oracles::exact_points(points);
  if (points.decimals()) {
    truth.unit *= oracles::Rational(boost::multiprecision::pow(
        oracles::Integer(10), static_cast<unsigned>(*points.decimals())));
  }
  const Rational exact_scale = oracles::power_of_two(sites.exact_scale_exponent());
  const Rational scale = oracles::power_of_two(sites.scale_exponent());
  const Rational least = oracles::power_of_two(-1074);
  double largest_error = 0.0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const ExactSite<D> site = sites.exact(i);
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Rational x = truth.unit * Rational(truth.position[i][axis]);
      EXPECT_EQ(Rational(site.x[axis]), x * exact_scale);
      const Rational error = abs(Rational(sites[i].x[axis]) - x * scale);
      EXPECT_LT(error, sites.is_exact() ? least / least : least);
      if (sites.is_exact()) {
        EXPECT_EQ(error, 0);
      }
      EXPECT_LT(std::abs(sites[i].x[axis]), kLargestMagnitude);
      if (sites.is_integral()) {
        EXPECT_EQ(sites[i].x[axis], std::trunc(sites[i].x[axis]));
        EXPECT_LE(std::abs(sites[i].x[axis]), 0x1p+53);
      }
    }
    const Rational weight = truth.unit * truth.unit * Rational(truth.weight[i]);
    EXPECT_EQ((Rational(site.weight_high) + Rational(site.weight_low)) *
                  oracles::power_of_two(site.weight_exponent),
              weight * exact_scale * exact_scale);
    const Rational error = abs(Rational(sites[i].weight) - weight * scale * scale);
    EXPECT_LE(error, Rational(sites.weight_error()));
    if (sites.is_exact()) {
      EXPECT_EQ(error, 0);
    }
    if (sites.is_integral()) {
      EXPECT_EQ(sites[i].weight, std::trunc(sites[i].weight));
    }
    EXPECT_LE(std::abs(sites[i].weight), kLargestMagnitude * kLargestMagnitude);
    largest_error = std::max(largest_error, std::abs(sites[i].weight));
  }
  // The bound is no more than a few units in the last place.
  EXPECT_LE(sites.weight_error(), 0x1p-51 * largest_error + 0x1p-1000);
}

TEST(Sites, HoldEveryNumberExactlyAndItsDoubleWithinTheBound) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      check_numbers<2>(points_of(family, 2, 20, seed));
      check_numbers<3>(points_of(family, 3, 20, seed));
    }
  }
}

TEST(Sites, KeepNumbersThatNoDoubleStageCanHold) {
  check_numbers<2>(
      {2, {1e300, 1, kLeast, kMost, -kMost, -1}, WeightKind::radius, {1, 1e200, kMost}});
  check_numbers<2>({2, {0, 1, 1, 0}, WeightKind::weight, {kMost, kLeast}});
  check_numbers<2>(
      {2, {kLeast, -kLeast, 3 * kLeast, 0}, WeightKind::radius, {kLeast, -3 * kLeast}});
  check_numbers<3>({3, {1e-200, 0, 1e200, 1, 2, 3}, WeightKind::weight, {1e-300, 1e300}});
}

TEST(Sites, AreIntegralWhereOnePowerOfTwoMakesThemSmallIntegers) {
  const Sites<2> sites = sites_of<2>({2, {0.25, -1.5, 3.0, 0.0}, WeightKind::weight, {1, 0.0625}});
  EXPECT_TRUE(sites.is_integral());
  EXPECT_TRUE(sites.is_exact());
  EXPECT_EQ(sites.scale_exponent(), 2);
  EXPECT_EQ(sites[0].x[0], 1.0);
  EXPECT_EQ(sites[0].x[1], -6.0);
  EXPECT_EQ(sites[0].weight, 16.0);
  EXPECT_EQ(sites[1].weight, 1.0);
}

TEST(Sites, AreIntegralUpToFiftyThreeBits) {
  EXPECT_TRUE(sites_of<2>({2, {0x1p+53 - 1, 1, 0, 0}, WeightKind::none, {}}).is_integral());
  EXPECT_FALSE(sites_of<2>({2, {0x1p+53, 1, 0, 0}, WeightKind::none, {}}).is_integral());
  EXPECT_FALSE(sites_of<2>({2, {0.1, 1, 0, 0}, WeightKind::none, {}}).is_integral());
  EXPECT_TRUE(sites_of<2>({2, {1024, 3072, 0, 0}, WeightKind::none, {}}).is_integral());
  // A weight of an odd power of two needs lengths in units of its root, rounded down.
  const Sites<2> sites = sites_of<2>({2, {1, 1, 0, 0}, WeightKind::weight, {0.5, 2}});
  EXPECT_EQ(sites.scale_exponent(), 1);
  EXPECT_TRUE(sites.is_integral());
}

TEST(Sites, OfNothingButZerosAreIntegral) {
  const Sites<3> sites = sites_of<3>({3, {0, 0, 0, -0.0, 0, 0}, WeightKind::weight, {0, -0.0}});
  EXPECT_TRUE(sites.is_integral());
  EXPECT_EQ(sites.scale_exponent(), 0);
  EXPECT_TRUE(sites.is_unweighted());
}

TEST(Sites, HaveNoNegativeZero) {
  const Sites<2> sites = sites_of<2>({2, {-0.0, 0.1, 0.3, -0.0}, WeightKind::weight, {-0.0, 0.7}});
  EXPECT_FALSE(std::signbit(sites[0].x[0]));
  EXPECT_FALSE(std::signbit(sites[1].x[1]));
  EXPECT_FALSE(std::signbit(sites[0].weight));
  const Sites<2> wide = sites_of<2>({2, {-0.0, 1e300, kLeast, 0}, WeightKind::none, {}});
  EXPECT_FALSE(wide.is_exact());
  EXPECT_FALSE(std::signbit(wide.exact(0).x[0]));
}

TEST(Sites, ScaleWhatLeavesTheRangeOfTheDoubleStages) {
  EXPECT_EQ(sites_of<2>({2, {0.1, 3, 7, 0}, WeightKind::none, {}}).scale_exponent(), 0);
  const Sites<2> huge = sites_of<2>({2, {1e300, 3e299, 0, -1e300}, WeightKind::none, {}});
  EXPECT_TRUE(huge.is_exact());
  EXPECT_LT(std::abs(huge[0].x[0]), kLargestMagnitude);
  const Sites<2> tiny = sites_of<2>({2, {1e-300, 3e-299, 0, -1e-300}, WeightKind::none, {}});
  EXPECT_TRUE(tiny.is_exact());
  EXPECT_GT(std::abs(tiny[0].x[0]), 1 / kLargestMagnitude);
  EXPECT_FALSE(sites_of<2>({2, {1e300, 1, 0, kLeast}, WeightKind::none, {}}).is_exact());
}

TEST(Sites, TakeRadiiAsTheirSquares) {
  const Sites<2> sites = sites_of<2>({2, {0, 0, 8, 0, 0, 8}, WeightKind::radius, {3, -2, 0}});
  EXPECT_EQ(sites[0].weight, 9.0);
  EXPECT_EQ(sites[1].weight, -4.0);
  EXPECT_EQ(sites[2].weight, 0.0);
  EXPECT_FALSE(sites.is_unweighted());
  EXPECT_EQ(sites.weight_error(), 0.0);
  EXPECT_GT(sites_of<2>({2, {0, 0}, WeightKind::radius, {0.1}}).weight_error(), 0.0);
}

TEST(Sites, KnowWhetherAllWeightsAreEqual) {
  EXPECT_TRUE(sites_of<2>({2, {0, 0, 8, 0}, WeightKind::radius, {1e200, 1e200}}).is_unweighted());
  EXPECT_TRUE(sites_of<2>({2, {0, 0, 8, 0}, WeightKind::none, {}}).is_unweighted());
  const double next = std::nextafter(0.1, 1.0);
  EXPECT_FALSE(sites_of<2>({2, {0, 0, 8, 0}, WeightKind::radius, {0.1, next}}).is_unweighted());
  EXPECT_FALSE(sites_of<2>(WeightedPoints::fixed_point(2, 0, {0, 0, 8, 0}, WeightKind::weight,
                                                       {0x1p+60, 0x1p+60}, {0, 1}))
                   .is_unweighted());
}

TEST(Sites, ReadFixedPointInItsUnit) {
  const auto points = WeightedPoints::fixed_point(3, 3, {1500, -2, 0, 4, 4, 4}, WeightKind::weight,
                                                  {0x1p+80, 7}, {5, 0});
  const Sites<3> sites = sites_of<3>(points);
  EXPECT_EQ(sites.decimals(), 3);
  EXPECT_FALSE(sites.is_exact());
  EXPECT_EQ(sites.exact(0).x[0], 1500.0);
  EXPECT_EQ(sites.exact(0).weight_high, 0x1p+80);
  EXPECT_EQ(sites.exact(0).weight_low, 5.0);
  check_numbers<3>(points);
  check_numbers<2>(WeightedPoints::fixed_point(2, 7, {0x1p+53, -0x1p+53, 0, 1}, WeightKind::radius,
                                               {0x1p+53, 1}));
}

// Rows in another order, a part of them, other axes: the same numbers in their places.
TEST(Sites, KeepTheirNumbersWhenOthersAreDroppedAndOnPermutedAxes) {
  for (const WeightedPoints& points :
       {WeightedPoints(3, {1, 2, 3, 4, 5, 6, 7, 8, 9}, WeightKind::radius, {0.1, 2, 3}),
        WeightedPoints(3, {1, 2, 3, 4, 5, 6, 7, 8, 9}, WeightKind::weight, {1, 2, 3})}) {
    const Sites<3> sites(points, {SiteId(2), SiteId(0), SiteId(1)});
    EXPECT_EQ(sites.row(0), SiteId(2));
    EXPECT_EQ(sites.exact(0).x[1] * std::ldexp(1.0, -sites.exact_scale_exponent()), 8.0);
    Sites<3> left = sites;
    left.drop({false, true, false});
    constexpr std::array<std::size_t, 2> kept{0, 2};
    ASSERT_EQ(left.size(), 2U);
    EXPECT_EQ(left.row(0), SiteId(2));
    EXPECT_EQ(left.row(1), SiteId(1));
    EXPECT_EQ(left.is_exact(), sites.is_exact());
    EXPECT_EQ(left.is_integral(), sites.is_integral());
    EXPECT_EQ(left.weight_error(), sites.weight_error());
    EXPECT_EQ(left.scale_exponent(), sites.scale_exponent());
    const Sites<3> turned = left.with_axes({2, 0, 1});
    for (std::size_t i = 0; i < 2; ++i) {
      const ExactSite<3> before = sites.exact(kept[i]), after = turned.exact(i);
      EXPECT_EQ(after.weight_high, before.weight_high);
      EXPECT_EQ(after.weight_low, before.weight_low);
      EXPECT_EQ(turned[i].weight, sites[kept[i]].weight);
      constexpr std::array<std::size_t, 3> axes{2, 0, 1};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(after.x[axis], before.x[axes[axis]]);
        EXPECT_EQ(turned[i].x[axis], sites[kept[i]].x[axes[axis]]);
      }
    }
  }
}

TEST(Sites, OfNoRowsAreNone) {
  const Sites<2> sites(WeightedPoints(2), {});
  EXPECT_EQ(sites.size(), 0U);
  EXPECT_TRUE(sites.is_exact());
  EXPECT_TRUE(sites.span().empty());
  EXPECT_TRUE(sites.rows().empty());
}

}  // namespace
}  // namespace orthoball
