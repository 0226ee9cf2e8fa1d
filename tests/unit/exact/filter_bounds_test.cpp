// SPDX-License-Identifier: MIT
//
// Looks for inputs on which the double stages are further off than filter_bounds.h says: random
// ones, and ones that a search makes worse and worse.
#include "orthoball/exact/filter_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "oracles/exact_predicates.h"
#include "orthoball/exact/power_side.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using oracles::Rational;
using tuples::sites_of;

// A few sites: [D * row + axis] and [row]; no weights where they are all 0.
struct Numbers {
  std::vector<double> coordinates;
  std::vector<double> weights;
};

template <int D>
WeightedPoints points_of(const Numbers& numbers) {
  return {D, numbers.coordinates, WeightKind::weight, numbers.weights};
}

template <int A>
Corners<A> first_corners() {
  Corners<A> corners;
  for (std::uint32_t i = 0; i <= A; ++i) corners[i] = i;
  return corners;
}

// The true determinant in the unit of the double stages.
template <int D>
Rational in_unit_of(const Sites<D>& sites, const oracles::ExactPoints& truth,
                    const oracles::Integer& determinant, int lengths) {
  Rational value(determinant);
  const Rational unit = truth.unit * oracles::power_of_two(sites.scale_exponent());
  for (int i = 0; i < lengths; ++i) value *= unit;
  return value;
}

// |value - true| / bound, above 1 where the bound is wrong. `is_exact` must mean no error at all.
template <int D>
double share_of_bound(const FilteredDeterminant& filtered, const Rational& truth) {
  const Rational error = abs(Rational(filtered.value) - truth);
  if (filtered.is_exact) {
    EXPECT_EQ(error, 0);
  }
  return static_cast<double>(Rational(error / Rational(filtered.bound)));
}

template <int A, int D>
double orient_share(const Numbers& numbers) {
  const WeightedPoints points = points_of<D>(numbers);
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  const Corners<A> corners = first_corners<A>();
  std::array<int, std::size_t{A}> axes;
  for (int i = 0; i < A; ++i) axes[static_cast<std::size_t>(i)] = i;
  return share_of_bound<D>(filtered_orient<A, D>(sites, corners),
                           in_unit_of(sites, truth, oracles::orientation(truth, corners, axes), A));
}

template <int A, int D>
double power_share(const Numbers& numbers) {
  const WeightedPoints points = points_of<D>(numbers);
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  const Corners<A> corners = first_corners<A>();
  return share_of_bound<D>(
      filtered_power_side<A, D>(sites, corners, A + 1),
      in_unit_of(sites, truth, oracles::power_determinant(truth, corners, A + 1), A + 2));
}

// Ways of writing numbers down that round badly: full mantissas, mantissas just above a power of
// two (the largest relative rounding errors), few magnitudes, many magnitudes.
Numbers any_numbers(Random& random, int dimension, int sites, int style, bool has_weights) {
  const auto number = [&](int exponent) {
    const double mantissa = style == 1   ? 1 + 0x1p-40 * random.uniform()
                            : style == 2 ? 1 + 0x1p-20 * random.uniform()
                                         : random.uniform(0.5, 1.0);
    return std::ldexp(random.coin() ? mantissa : -mantissa,
                      style == 3 ? random.integer(-exponent, exponent) : 0);
  };
  Numbers numbers;
  for (int i = 0; i < sites * dimension; ++i) numbers.coordinates.push_back(number(30));
  for (int i = 0; i < sites; ++i) numbers.weights.push_back(has_weights ? number(50) : 0.0);
  return numbers;
}

// The largest share found by changing one number at a time and keeping what is worse.
template <class Share>
double worst_share(int dimension, int sites, const Share& share) {
  Random random(3);
  double worst = 0.0;
  for (int start = 0; start < 24; ++start) {
    Numbers numbers = any_numbers(random, dimension, sites, start % 4, start % 3 != 0);
    double here = share(numbers);
    for (int step = 0; step < 150; ++step) {
      Numbers changed = numbers;
      auto& list = random.integer(0, 3) == 0 ? changed.weights : changed.coordinates;
      double& one = list[random.bits() % list.size()];
      const double ulps = random.integer(-8, 8) * std::pow(2.0, random.integer(0, 40));
      one *= 1 + ulps * std::numeric_limits<double>::epsilon();
      const double there = share(changed);
      if (there >= here) {
        here = there;
        numbers = std::move(changed);
      }
    }
    worst = std::max(worst, here);
  }
  return worst;
}

TEST(FilterBounds, HoldForOrientationsThatASearchMakesWorse) {
  EXPECT_LE(worst_share(2, 2, orient_share<1, 2>), 0.5 + 1e-9);
  EXPECT_LE(worst_share(2, 3, orient_share<2, 2>), 1.0);
  EXPECT_LE(worst_share(3, 3, orient_share<2, 3>), 1.0);
  EXPECT_LE(worst_share(3, 4, orient_share<3, 3>), 1.0);
}

TEST(FilterBounds, HoldForPowerTestsThatASearchMakesWorse) {
  EXPECT_LE(worst_share(2, 3, power_share<1, 2>), 1.0);
  EXPECT_LE(worst_share(3, 3, power_share<1, 3>), 1.0);
  EXPECT_LE(worst_share(2, 4, power_share<2, 2>), 1.0);
  EXPECT_LE(worst_share(3, 4, power_share<2, 3>), 1.0);
  EXPECT_LE(worst_share(3, 5, power_share<3, 3>), 1.0);
}

// The search does come near: a bound that is too large by orders would send too much to the exact
// stage, and a search that finds nothing would prove nothing.
TEST(FilterBounds, AreWithinAFewOrdersOfWhatTheSearchFinds) {
  EXPECT_GE(worst_share(2, 2, orient_share<1, 2>), 0.3);
  EXPECT_GE(worst_share(2, 3, orient_share<2, 2>), 0.1);
  EXPECT_GE(worst_share(3, 4, orient_share<3, 3>), 0.02);
  EXPECT_GE(worst_share(2, 4, power_share<2, 2>), 0.02);
  EXPECT_GE(worst_share(3, 5, power_share<3, 3>), 0.005);
}

template <int D>
Numbers rows_of(const WeightedPoints& points, std::span<const std::uint32_t> rows) {
  Numbers numbers;
  for (const std::uint32_t row : rows) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      numbers.coordinates.push_back(points.coordinates()[D * row + axis]);
    }
    numbers.weights.push_back(points.weights().empty() ? 0.0 : points.weights()[row]);
  }
  return numbers;
}

TEST(FilterBounds, HoldOnEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      const WeightedPoints solid = generators::points_of(family, 3, 30, seed);
      const WeightedPoints flat = generators::points_of(family, 2, 30, seed);
      Random random(seed);
      for (int i = 0; i < 30; ++i) {
        const Numbers five = rows_of<3>(solid, tuples::any_rows<5>(random, solid.size()));
        EXPECT_LE((orient_share<3, 3>(five)), 1.0);
        EXPECT_LE((power_share<2, 3>(five)), 1.0);
        EXPECT_LE((power_share<3, 3>(five)), 1.0);
        const Numbers four = rows_of<2>(flat, tuples::any_rows<4>(random, flat.size()));
        EXPECT_LE((orient_share<2, 2>(four)), 1.0);
        EXPECT_LE((power_share<1, 2>(four)), 1.0);
        EXPECT_LE((power_share<2, 2>(four)), 1.0);
      }
    }
  }
}

// Radii that a double cannot square: the error of the weights is part of the bound.
TEST(FilterBounds, HoldForWeightsThatAreRounded) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> coordinates, radii;
    const double size = std::ldexp(1.0, random.integer(0, 60));
    for (int site = 0; site < 5; ++site) {
      for (int axis = 0; axis < 3; ++axis) coordinates.push_back(random.uniform());
      radii.push_back(size * (1 + 0x1p-20 * random.uniform()));
    }
    const WeightedPoints points(3, coordinates, WeightKind::radius, radii);
    const Sites<3> sites = sites_of<3>(points);
    const oracles::ExactPoints truth = oracles::exact_points(points);
    const Corners<3> corners{0, 1, 2, 3};
    EXPECT_LE(share_of_bound<3>(
                  filtered_power_side<3, 3>(sites, corners, 4),
                  in_unit_of(sites, truth, oracles::power_determinant(truth, corners, 4), 5)),
              1.0);
  }
}

// At both ends of the range of the double stages nothing overflows, and what underflow takes is
// within the bound.
TEST(FilterBounds, HoldAtTheEndsOfTheRange) {
  Random random(6);
  for (int i = 0; i < 400; ++i) {
    Numbers numbers = any_numbers(random, 3, 5, 0, true);
    numbers.coordinates[1] *= 0x1p-20;  // no integers of 53 bits
    const auto scale = [&](int lengths) {
      Numbers scaled = numbers;
      for (double& x : scaled.coordinates) x = std::ldexp(x, lengths);
      for (double& w : scaled.weights) w = std::ldexp(w, 2 * lengths);
      return scaled;
    };
    for (const int lengths : {150, -19}) {
      const Numbers scaled = scale(lengths);
      ASSERT_EQ(sites_of<3>(points_of<3>(scaled)).scale_exponent(), 0);
      EXPECT_LE((orient_share<3, 3>(scaled)), 1.0);
      EXPECT_LE((power_share<3, 3>(scaled)), 1.0);
      EXPECT_LE((power_share<2, 3>(scaled)), 1.0);
      const Sites<3> sites = sites_of<3>(points_of<3>(scaled));
      EXPECT_TRUE(std::isfinite(filtered_power_side<3, 3>(sites, {0, 1, 2, 3}, 4).bound));
    }
    // One site far smaller than the others, one coordinate below every normal number.
    Numbers mixed = scale(140);
    for (std::size_t axis = 0; axis < 3; ++axis) mixed.coordinates[axis] *= 0x1p-900;
    mixed.coordinates[4] = std::ldexp(mixed.coordinates[4], -1190);
    EXPECT_LE((power_share<3, 3>(mixed)), 1.0);
    EXPECT_LE((power_share<1, 3>(mixed)), 1.0);
    EXPECT_LE((orient_share<3, 3>(mixed)), 1.0);
  }
}

// Integers whose determinant's terms just fit 53 bits, and the least that do not.
TEST(FilterBounds, CountTheTermsOfSmallIntegers) {
  const auto sites = [](double side) { return tuples::sites_at<2>({0, 0, side, 1, 1, side}); };
  const auto is_exact = [&](double side) {
    return filtered_orient<2, 2>(sites(side), {0, 1, 2}).is_exact;
  };
  EXPECT_TRUE(is_exact(0x1p+26));  // 2 * 2^52
  EXPECT_FALSE(is_exact(0x1p+26 + 1));
}

}  // namespace
}  // namespace orthoball
