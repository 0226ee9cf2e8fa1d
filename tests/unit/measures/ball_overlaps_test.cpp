// SPDX-License-Identifier: MIT
#include "orthoball/measures/ball_overlaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "generators/random.h"
#include "oracles/cut_ball.h"
#include "orthoball/error.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Random;
using oracles::CutBall;

using std::numbers::pi;

template <int D>
using Balls = std::vector<Ball<D>>;

template <int D>
BallOverlap<D> overlap(const Balls<D>& balls) {
  return ball_overlap<D>(std::span<const Ball<D>>(balls));
}

template <int D>
Filtration<D> filtration_of(const Balls<D>& balls) {
  std::vector<double> coordinates, radii;
  for (const Ball<D>& ball : balls) {
    coordinates.insert(coordinates.end(), ball.centre.begin(), ball.centre.end());
    radii.push_back(ball.radius);
  }
  return Filtration<D>(
      regular_triangulation<D>(WeightedPoints(D, coordinates, WeightKind::radius, radii)));
}

template <int D>
Ball<D> random_ball(Random& random) {
  Ball<D> ball;
  for (double& x : ball.centre) x = random.uniform(-1.0, 1.0);
  ball.radius = random.uniform(0.2, 2.0);
  return ball;
}

// Balls that are a simplex of their dual complex.
template <int D>
Balls<D> random_simplex(Random& random, std::size_t count) {
  while (true) {
    Balls<D> balls;
    for (std::size_t i = 0; i < count; ++i) balls.push_back(random_ball<D>(random));
    const Filtration<D> filtration = filtration_of(balls);
    const int dimension = static_cast<int>(count) - 1;
    if (filtration.count(0) != count || filtration.count(dimension) != 1) continue;
    const SimplexId simplex(filtration.table().first(dimension));
    if (filtration.enters(simplex) <= filtration.index(0.0)) return balls;
  }
}

// The part of each ball: where its power is the largest.
template <int D>
std::vector<CutBall> parts_of(const Balls<D>& balls) {
  std::vector<CutBall> parts;
  for (const Ball<D>& ball : balls) {
    parts.push_back({{ball.centre.begin(), ball.centre.end()}, ball.radius, {}});
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (i != j) parts[i].cuts.push_back(where_power_is_more(parts[i], parts[j]));
    }
  }
  return parts;
}

// Of the line through `at` along the last axis: the length of what is in all balls.
template <int D>
double length_in_all(const Balls<D>& balls, const std::vector<double>& at) {
  double low = -10.0, high = 10.0;
  for (const Ball<D>& ball : balls) {
    double half2 = ball.radius * ball.radius;
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
      half2 -= (at[axis] - ball.centre[axis]) * (at[axis] - ball.centre[axis]);
    }
    if (half2 <= 0.0) return 0.0;
    low = std::max(low, ball.centre[at.size()] - std::sqrt(half2));
    high = std::min(high, ball.centre[at.size()] + std::sqrt(half2));
  }
  return std::max(0.0, high - low);
}

TEST(BallOverlap, OfOneBallIsTheBall) {
  const auto ball = overlap<3>({{{1, 2, 3}, 2}});
  EXPECT_DOUBLE_EQ(ball.volume, 32 * pi / 3);
  EXPECT_DOUBLE_EQ(ball.area, 16 * pi);
  const auto disk = overlap<2>({{{1, 2}, 3}});
  EXPECT_DOUBLE_EQ(disk.volume, 9 * pi);
  EXPECT_DOUBLE_EQ(disk.area, 6 * pi);
  EXPECT_EQ(overlap<3>({{{1, 2, 3}, 0}}).volume, 0.0);
}

TEST(BallOverlap, OfTwoBallsIsTheirLens) {
  const auto lens = overlap<3>({{{0, 0, 0}, 1}, {{0, 1, 0}, 1}});
  EXPECT_NEAR(lens.volume, 5 * pi / 12, 1e-15);
  EXPECT_NEAR(lens.area, 2 * pi, 1e-15);
  EXPECT_DOUBLE_EQ(lens.volumes[0], lens.volumes[1]);
  EXPECT_DOUBLE_EQ(lens.arcs[0][1], pi * std::sqrt(3.0));
  EXPECT_EQ(lens.arcs[0][1], lens.arcs[1][0]);

  // Radii 2 and 1 at distance 2: heights 7/4 and 1/4.
  const auto unequal = overlap<3>({{{0, 0, 0}, 2}, {{2, 0, 0}, 1}});
  EXPECT_DOUBLE_EQ(unequal.areas[0], 2 * pi * 2 * 0.25);
  EXPECT_DOUBLE_EQ(unequal.areas[1], 2 * pi * 0.75);
  EXPECT_NEAR(unequal.volumes[0], pi * 0.0625 * (6 - 0.25) / 3, 1e-15);
  EXPECT_NEAR(unequal.volumes[1], pi * 0.5625 * (3 - 0.75) / 3, 1e-15);

  const auto disks = overlap<2>({{{0, 0}, 1}, {{1, 0}, 1}});
  EXPECT_NEAR(disks.volume, 2 * pi / 3 - std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(disks.area, 4 * pi / 3, 1e-15);
}

TEST(BallOverlap, OfBallsThatJustTouchIsNothing) {
  const auto touching = overlap<3>({{{0, 0, 0}, 1}, {{3, 0, 0}, 2}});
  EXPECT_EQ(touching.volume, 0.0);
  EXPECT_EQ(touching.area, 0.0);
  const auto apart = overlap<3>({{{0, 0, 0}, 1}, {{4, 0, 0}, 2}});
  EXPECT_EQ(apart.volume, 0.0);
  EXPECT_EQ(apart.area, 0.0);
  const auto disks = overlap<2>({{{0, 0}, 1}, {{0, 3}, 2}});
  EXPECT_EQ(disks.volume, 0.0);
  EXPECT_EQ(disks.area, 0.0);
}

TEST(BallOverlap, OfTwoBallsVanishesSmoothlyWhereTheyPart) {
  for (double gap = 0.5; gap > 1e-15; gap /= 7) {
    const double distance = 2.0 - gap, left = 2.0 - distance;
    const double volume = pi * (4 + distance) * left * left / 12;
    const auto lens = overlap<3>({{{0, 0, 0}, 1}, {{0, 0, distance}, 1}});
    EXPECT_NEAR(lens.volume, volume, 4e-16);
    EXPECT_NEAR(lens.area, 2 * pi * left, 4e-15);
  }
}

// A small ball that sticks out of a large one by less and less.
TEST(BallOverlap, OfABallThatIsNearlySwallowedIsNearlyTheBall) {
  const double ball = 4 * pi / 3 / 64;
  double last = 0.0;
  for (double out = 0.25; out > 1e-15; out /= 3) {
    const auto lens = overlap<3>({{{0, 0, 0}, 1}, {{0.75 + out, 0, 0}, 0.25}});
    EXPECT_GE(lens.volume, last - 1e-15);
    EXPECT_LE(lens.volume, ball * (1 + 1e-14));
    last = lens.volume;
  }
  EXPECT_NEAR(last, ball, 1e-14 * ball);
  const auto inside = overlap<3>({{{0, 0, 0}, 1}, {{0.75, 0, 0}, 0.25}});
  EXPECT_NEAR(inside.volume, ball, 1e-15);
  EXPECT_NEAR(inside.areas[1], 4 * pi / 16, 1e-15);
  EXPECT_NEAR(inside.areas[0], 0.0, 1e-15);
  const auto disks = overlap<2>({{{0, 0}, 1}, {{0, 0.75}, 0.25}});
  EXPECT_NEAR(disks.volume, pi / 16, 1e-15);
}

TEST(BallOverlap, OfNearlyConcentricBallsIsNearlyABall) {
  for (double distance = 0.1; distance > 1e-300; distance *= 1e-7) {
    const auto lens = overlap<3>({{{0, 0, 0}, 1}, {{distance, 0, 0}, 1}});
    EXPECT_NEAR(lens.volume, pi * (4 + distance) * (2 - distance) * (2 - distance) / 12, 1e-14);
    EXPECT_NEAR(lens.area, 4 * pi - 2 * pi * distance, 1e-14);
    const auto disks = overlap<2>({{{0, 0}, 1}, {{0, distance}, 1}});
    EXPECT_NEAR(disks.volume, 2 * std::acos(distance / 2) - distance, distance * distance + 1e-14);
  }
}

TEST(BallOverlap, OfThreeDisksIsAReuleauxTriangle) {
  const auto disks = overlap<2>({{{0, 0}, 1}, {{1, 0}, 1}, {{0.5, std::sqrt(0.75)}, 1}});
  EXPECT_NEAR(disks.volume, (pi - std::sqrt(3.0)) / 2, 1e-15);
  EXPECT_NEAR(disks.area, pi, 2e-15);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(disks.areas[i], pi / 3, 1e-15);
}

TEST(BallOverlap, OfFourBallsIsAReuleauxTetrahedron) {
  const double s = std::sqrt(0.125);
  const auto balls =
      overlap<3>({{{s, s, s}, 1}, {{s, -s, -s}, 1}, {{-s, s, -s}, 1}, {{-s, -s, s}, 1}});
  EXPECT_NEAR(balls.volume, (3 * std::sqrt(2.0) - 49 * pi + 162 * std::atan(std::sqrt(2.0))) / 12,
              5e-15);
  EXPECT_NEAR(balls.area, 8 * pi - 18 * std::acos(1.0 / 3), 2e-14);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(balls.areas[i], balls.areas[0], 4e-15);
}

// Three unit balls at distance 1, of which AlphaMol's union of three unit balls at the corners of a
// right triangle has two lenses: 9.83075054 by reference.
TEST(BallOverlap, OfThreeBallsCompletesAPublishedUnion) {
  const double diagonal = std::sqrt(2.0);
  const double lenses = 2 * 5 * pi / 12 + pi * (4 + diagonal) * std::pow(2 - diagonal, 2) / 12;
  const auto three = overlap<3>({{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, 1, 0}, 1}});
  EXPECT_NEAR(4 * pi - lenses + three.volume, 9.83075054, 5e-9);
}

template <int D>
void expect_parts_as_cut_balls() {
  Random random(5 + D);
  for (int i = 0; i < (D == 2 ? 300 : 60); ++i) {
    const std::size_t count = 1 + static_cast<std::size_t>(i) % (D + 1);
    const Balls<D> balls = random_simplex<D>(random, count);
    const BallOverlap<D> found = overlap(balls);
    const std::vector<CutBall> parts = parts_of(balls);
    SCOPED_TRACE(::testing::Message() << D << "D, " << i);
    for (std::size_t ball = 0; ball < count; ++ball) {
      EXPECT_NEAR(found.volumes[ball], volume(parts[ball]), 1e-12);
      EXPECT_NEAR(found.areas[ball], area(parts[ball]), 1e-11);
      for (std::size_t other = 0; other < count; ++other) {
        if (other == ball) continue;
        const std::size_t cut = other < ball ? other : other - 1;
        const double arc = D == 3 ? area(facet(parts[ball], cut)) : 0.0;
        EXPECT_NEAR(found.arcs[ball][other], arc, 1e-11);
      }
    }
    for (std::size_t none = count; none <= D; ++none) {
      EXPECT_EQ(found.volumes[none], 0.0);
      EXPECT_EQ(found.areas[none], 0.0);
    }
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(BallOverlap, HasThePartsThatPlanesCutFromItsBalls) {
  expect_parts_as_cut_balls<2>();
  expect_parts_as_cut_balls<3>();
}

// By the rule of midpoints, whose error is as little regular as the ends of lines: of the order of
// the square of the step.
template <int D>
double volume_in_all(const Balls<D>& balls) {
  constexpr int kSteps = D == 2 ? 100000 : 1500;
  std::array<double, 3> low{}, step{};
  for (std::size_t axis = 0; axis < std::size_t{D}; ++axis) {
    low[axis] = -3.0;
    double high = 3.0;
    for (const Ball<D>& ball : balls) {
      low[axis] = std::max(low[axis], ball.centre[axis] - ball.radius);
      high = std::min(high, ball.centre[axis] + ball.radius);
    }
    step[axis] = (high - low[axis]) / kSteps;
  }
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = low[0] + (i + 0.5) * step[0];
    if (D == 2) sum += step[0] * length_in_all(balls, {x});
    for (int j = 0; D == 3 && j < kSteps; ++j) {
      sum += step[0] * step[1] * length_in_all(balls, {x, low[1] + (j + 0.5) * step[1]});
    }
  }
  return sum;
}

TEST(BallOverlap, IsWhatIsInAllBalls) {
  Random random(9);
  for (std::size_t count = 1; count <= 3; ++count) {
    const Balls<2> disks = random_simplex<2>(random, count);
    EXPECT_NEAR(overlap(disks).volume, volume_in_all(disks), 1e-7);
  }
  for (std::size_t count = 1; count <= 4; ++count) {
    const Balls<3> balls = random_simplex<3>(random, count);
    EXPECT_NEAR(overlap(balls).volume, volume_in_all(balls), 1e-5);
  }
}

template <int D>
void expect_growth_by_areas() {
  constexpr double kStep = 1e-5;
  Random random(20 + D);
  for (int i = 0; i < 200; ++i) {
    const std::size_t count = 1 + static_cast<std::size_t>(i) % (D + 1);
    const Balls<D> balls = random_simplex<D>(random, count);
    const BallOverlap<D> found = overlap(balls);
    for (std::size_t ball = 0; ball < count; ++ball) {
      Balls<D> larger = balls, smaller = balls;
      larger[ball].radius += kStep;
      smaller[ball].radius -= kStep;
      // Where a sphere meets the corner of the others, area is no smooth function of the radius.
      const double growth = (overlap(larger).volume - overlap(smaller).volume) / (2 * kStep);
      EXPECT_NEAR(growth, found.areas[ball], 2e-6) << i;
    }
  }
}

TEST(BallOverlap, GrowsWithARadiusByTheAreaOfThatBall) {
  expect_growth_by_areas<2>();
  expect_growth_by_areas<3>();
}

template <int D>
void expect_sums() {
  Random random(40 + D);
  for (int i = 0; i < 400; ++i) {
    const Balls<D> balls = random_simplex<D>(random, 1 + static_cast<std::size_t>(i) % (D + 1));
    const BallOverlap<D> found = overlap(balls);
    double volume = 0.0, area = 0.0;
    for (std::size_t ball = 0; ball <= D; ++ball) {
      EXPECT_GE(found.volumes[ball], 0.0);
      EXPECT_GE(found.areas[ball], 0.0);
      volume += found.volumes[ball];
      area += found.areas[ball];
    }
    EXPECT_EQ(found.volume, volume);
    EXPECT_EQ(found.area, area);
  }
}

TEST(BallOverlap, IsTheSumOfItsParts) {
  expect_sums<2>();
  expect_sums<3>();
}

template <int D>
void expect_union() {
  Random random(60 + D);
  for (int i = 0; i < 300; ++i) {
    const Balls<D> balls = random_simplex<D>(random, D + 1);
    double volume = 0.0, area = 0.0;
    std::array<double, std::size_t{D} + 1> areas{};
    for (unsigned subset = 1; subset < (1U << (D + 1)); ++subset) {
      Balls<D> some;
      std::vector<std::size_t> rows;
      for (std::size_t ball = 0; ball <= D; ++ball) {
        if ((subset >> ball & 1U) == 0) continue;
        some.push_back(balls[ball]);
        rows.push_back(ball);
      }
      const BallOverlap<D> found = overlap(some);
      const double sign = some.size() % 2 == 1 ? 1.0 : -1.0;
      volume += sign * found.volume;
      area += sign * found.area;
      for (std::size_t k = 0; k < rows.size(); ++k) areas[rows[k]] += sign * found.areas[k];
    }
    const Filtration<D> filtration = filtration_of(balls);
    const UnionOfBalls whole = union_of_balls(filtration, filtration.index(0.0), 0.0, {});
    EXPECT_NEAR(whole.volume, volume, 1e-12);
    EXPECT_NEAR(whole.area, area, 1e-12);
    for (std::size_t ball = 0; ball <= D; ++ball) {
      EXPECT_NEAR(whole.areas[ball], areas[ball], 1e-12);
    }
  }
}

TEST(BallOverlap, OfAllSubsetsIncludedAndExcludedIsTheUnion) {
  expect_union<2>();
  expect_union<3>();
}

TEST(BallOverlap, VanishesSmoothlyWhereSpheresMeetInOnePoint) {
  const double x = -0.5, y = std::sqrt(0.75);
  double last = 1.0;
  for (double more = 0.1; more > 1e-17; more /= 5) {
    const double r = 1.0 + more;
    const auto three = overlap<3>({{{1, 0, 0}, r}, {{x, y, 0}, r}, {{x, -y, 0}, r}});
    EXPECT_LE(three.volume, last);
    // Within a box of half widths about (1.2 more, 1.2 more, sqrt(2 more)).
    EXPECT_LE(three.volume, 20 * std::pow(more, 2.5) + 1e-15) << more;
    EXPECT_GE(three.volume, 0.1 * std::pow(more, 2.5) - 1e-15) << more;
    last = three.volume + 1e-15;
    const auto disks = overlap<2>({{{1, 0}, r}, {{x, y}, r}, {{x, -y}, r}});
    // Nearly a triangle whose inscribed circle has radius `more`.
    EXPECT_NEAR(disks.volume, 3 * std::sqrt(3.0) * more * more, 20 * std::pow(more, 3) + 1e-15);
  }
  const auto disks = overlap<2>({{{1, 0}, 1}, {{x, y}, 1}, {{x, -y}, 1}});
  EXPECT_NEAR(disks.volume, 0.0, 1e-15);
  const double s = std::sqrt(1.0 / 3);
  const auto four =
      overlap<3>({{{s, s, s}, 1}, {{s, -s, -s}, 1}, {{-s, s, -s}, 1}, {{-s, -s, s}, 1}});
  EXPECT_NEAR(four.volume, 0.0, 2e-15);
  EXPECT_NEAR(four.area, 0.0, 4e-15);
}

TEST(BallOverlap, IsOfOneToFourBallsThatAreBalls) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto reason_of = [](const Balls<3>& balls) {
    try {
      (void)overlap(balls);
    } catch (const InputError& error) {
      return std::pair(error.reason(), error.row());
    }
    ADD_FAILURE() << "accepted";
    return std::pair(InputError::Reason{}, std::size_t{0});
  };
  const Ball<3> unit{{0, 0, 0}, 1};
  using Reason = InputError::Reason;
  EXPECT_EQ(reason_of({}).first, Reason::wrong_argument);
  EXPECT_EQ(reason_of(Balls<3>(5, unit)).first, Reason::wrong_argument);
  EXPECT_EQ(reason_of({unit, {{1, 0, 0}, -1}}), std::pair(Reason::wrong_argument, std::size_t{1}));
  EXPECT_EQ(reason_of({unit, {{1, nan, 0}, 1}}), std::pair(Reason::not_finite, std::size_t{1}));
  EXPECT_EQ(reason_of({{{1, 0, 0}, nan}}), std::pair(Reason::not_finite, std::size_t{0}));
  EXPECT_EQ(reason_of({unit, unit, {{0, 0, infinity}, 1}}),
            std::pair(Reason::not_finite, std::size_t{2}));
  EXPECT_THROW((void)overlap(Balls<2>(4, Ball<2>{{0, 0}, 1})), InputError);
}

}  // namespace
}  // namespace orthoball
