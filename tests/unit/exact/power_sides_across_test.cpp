// SPDX-License-Identifier: MIT
#include "orthoball/exact/power_sides_across.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "oracles/exact_predicates.h"
#include "orthoball/exact/orient.h"
#include "orthoball/exact/processor.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using tuples::sites_of;

#ifdef ORTHOBALL_WIDE_CODE

template <int D>
ORTHOBALL_AVX2 GlancedSides sides_across(const Sites<D>& sites, const Corners<D>& corners,
                                         const Corners<D>& apexes, std::uint32_t query) {
  return PowerSidesAcross<D>(sites, query)(corners, apexes);
}

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
    const GlancedSides sides = sides_across<D>(sites, corners, apexes, query);
    EXPECT_EQ(sides.positive + sides.negative + sides.zero + sides.open, (2U << D) - 1);
    EXPECT_EQ(sides.positive | sides.negative | sides.zero | sides.open, (2U << D) - 1);
    for (std::size_t facet = 0; facet <= D; ++facet) {
      const auto has = [&](std::uint32_t mask) { return (mask >> facet & 1U) != 0; };
      ++tally.asked;
      if (!has(sides.positive | sides.negative | sides.zero)) continue;
      ++tally.known;
      // With the apex in the place of the corner, and turned over.
      Corners<D> neighbour = corners;
      neighbour[facet] = apexes[facet];
      std::swap(neighbour[facet == 0 ? 1 : 0], neighbour[facet == D ? D - 1 : D]);
      const Sign told = has(sides.zero)       ? Sign::zero
                        : has(sides.positive) ? Sign::positive
                                              : Sign::negative;
      EXPECT_EQ(told, oracles::sign_of(oracles::power_determinant(truth, neighbour, query)));
    }
  }
  return tally;
}

TEST(PowerSidesAcross, IsTheSignOfTheDeterminantWhereItIsKnown) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      check_sides<2>(points_of(family, 2, 25, seed), seed, 60);
      check_sides<3>(points_of(family, 3, 25, seed), seed, 60);
    }
  }
}

TEST(PowerSidesAcross, LeavesLittleOpenOnSitesInGeneralPosition) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const PointFamily family : {PointFamily::uniform, PointFamily::uniform_balls}) {
    const Tally plane = check_sides<2>(points_of(family, 2, 200, 1), 1, 2000);
    EXPECT_GT(plane.known, 0.999 * plane.asked);
    const Tally space = check_sides<3>(points_of(family, 3, 200, 1), 1, 2000);
    EXPECT_GT(space.known, 0.999 * space.asked);
  }
}

TEST(PowerSidesAcross, ClaimsNothingFalseOfNumbersOfAnySize) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const WeightedPoints points(
      3, {most, 0, -most, 0, 1e300, 1,     least,  least, 0,     -most, 1, 2, 1e200, 1e-200, 3,
          5,    6, 7,     0, 0,     least, 1e-160, 0,     1e160, 1,     1, 1, 3,     1e-9,   4},
      WeightKind::radius, {most, 1e200, least, 0, 1, -most, -3e-320, 2, 0, 1e-160});
  check_sides<3>(points, 1, 1000);
}

// A facet of rows (x, lift) seen from the origin, with the unit as determinant of its x, and an
// apex whose row is their sum, but for `step` in its lift: the determinant is +-step, however long
// the rows are.
template <int D>
WeightedPoints rows_of_small_determinant(Random& random, int size, int step) {
  const double m = std::ldexp(1.0, size);
  // A lower times an upper triangular matrix with ones on the diagonals.
  const auto entry = [&] { return std::floor(random.uniform() * std::sqrt(m)) + 1.0; };
  std::array<std::array<double, std::size_t{D}>, std::size_t{D}> lower{}, upper{};
  for (std::size_t i = 0; i < D; ++i) {
    lower[i][i] = upper[i][i] = 1.0;
    for (std::size_t j = 0; j < i; ++j) {
      lower[i][j] = entry();
      upper[j][i] = entry();
    }
  }
  std::vector<double> x(D * D, 0.0);
  for (std::size_t i = 0; i < D * D * D; ++i) {
    x[i / D] += lower[i / (D * D)][i % D] * upper[i % D][i / D % D];
  }
  std::vector<double> lifts;
  for (int i = 0; i < D; ++i) lifts.push_back(std::floor(random.uniform() * m * m));
  std::vector<double> sum(D, 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) sum[i % D] += x[i];
  x.insert(x.end(), sum.begin(), sum.end());
  lifts.push_back(std::accumulate(lifts.begin(), lifts.end(), 1.0 * step));
  x.insert(x.end(), D, 0.0);
  lifts.push_back(0.0);
  std::vector<double> weights;
  for (std::size_t i = 0; i < lifts.size(); ++i) {
    double square = 0.0;
    for (std::size_t axis = 0; axis < D; ++axis) square += x[D * i + axis] * x[D * i + axis];
    weights.push_back(square - lifts[i]);
  }
  return {D, x, WeightKind::weight, weights};
}

template <int D>
void check_small_determinants() {
  Random random(7);
  for (int size = 1; size <= 20; ++size) {
    for (int round = 0; round < 30; ++round) {
      const int step = round % 3 - 1;
      const WeightedPoints points = rows_of_small_determinant<D>(random, size, step);
      const Sites<D> sites = sites_of<D>(points);
      Corners<D> corners, neighbour;  // the query stands where nothing but its row, 0, counts
      for (std::uint32_t i = 0; i < D; ++i) neighbour[i + 1] = corners[i + 1] = i;
      corners[0] = D + 1;
      neighbour[0] = D;
      Corners<D> apexes = corners;
      apexes[0] = D;
      const GlancedSides sides = sides_across<D>(sites, corners, apexes, D + 1);
      std::swap(neighbour[1], neighbour[2]);
      const Sign truth = oracles::sign_of(
          oracles::power_determinant(oracles::exact_points(points), neighbour, D + 1));
      ASSERT_EQ(truth == Sign::zero, step == 0);
      const unsigned told =
          (sides.positive & 1U) | (sides.negative & 1U) << 1U | (sides.zero & 1U) << 2U;
      const unsigned right = truth == Sign::positive ? 1U : truth == Sign::negative ? 2U : 4U;
      EXPECT_EQ(told & ~right, 0U) << "coordinates of " << size << " bits";
      if (size <= 5) {
        EXPECT_EQ(told, right) << "coordinates of " << size << " bits";
      }
    }
  }
}

TEST(PowerSidesAcross, TellsIntegersUpToWhereTheirProductsAreExact) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  check_small_determinants<2>();
  check_small_determinants<3>();
}

TEST(PowerSidesAcross, TellsTiesOfSmallIntegersOnly) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const double unit : {1.0, 0x1p+20, 0.1}) {
    const auto scaled = [&](std::vector<double> numbers) {
      for (double& number : numbers) number *= unit;
      return numbers;
    };
    const Sites<2> square = tuples::sites_at<2>(scaled({0, 0, 1, 0, 0, 1, 1, 1, 2, 9, 9, 2}));
    const Sites<3> cube = tuples::sites_at<3>(
        scaled({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1, 1, 1, 1, 1, 7, 7, 5}));
    const bool is_told = unit != 0.1;
    EXPECT_EQ(sides_across<2>(square, {0, 1, 2}, {3, 4, 5}, 3).zero, is_told ? 0b001U : 0U);
    EXPECT_EQ(sides_across<3>(cube, {0, 1, 2, 3}, {4, 5, 6, 5}, 7).zero, is_told ? 0b1111U : 0U);
  }
}

TEST(PowerSidesAcross, LeavesOpenWhatConcernsTheVertexAtInfinity) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const double unit : {1.0, 0x1p-60, 0x1p+149}) {
    const auto points = [&](int dimension) {
      const WeightedPoints all = points_of(PointFamily::uniform_balls, dimension, 20, 1);
      std::vector<double> x(all.coordinates().begin(), all.coordinates().end());
      for (double& number : x) number *= unit;
      return WeightedPoints(dimension, x, WeightKind::none, {});
    };
    const Sites<2> plane = sites_of<2>(points(2));
    const Sites<3> space = sites_of<3>(points(3));
    EXPECT_EQ(sides_across<2>(plane, {0, 1, 20}, {3, 4, 5}, 6).open, 0b111U);
    EXPECT_EQ(sides_across<2>(plane, {0, 1, 2}, {3, 20, 5}, 6).open & 0b010U, 0b010U);
    EXPECT_EQ(sides_across<3>(space, {0, 20, 1, 2}, {3, 4, 5, 7}, 6).open, 0b1111U);
    EXPECT_EQ(sides_across<3>(space, {0, 1, 2, 8}, {3, 4, 20, 7}, 6).open & 0b100U, 0b100U);
  }
}

#endif

}  // namespace
}  // namespace orthoball
