// SPDX-License-Identifier: MIT
#include "orthoball/measures/molecular_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "generators/random.h"
#include "oracles/depth_in_union.h"
#include "orthoball/error.h"
#include "orthoball/points/probe.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Random;
using oracles::depth_in_union;
using oracles::SolidBall;
using std::numbers::pi;

MolecularSurface surface_of(const WeightedPoints& points, double probe, double alpha2 = 0.0) {
  const Filtration<3> filtration(regular_triangulation<3>(points));
  const UnionOfBalls balls = union_of_balls(filtration, filtration.index(alpha2), alpha2, {});
  return molecular_surface(filtration, balls, probe, Threads(1));
}
// Of atoms, without the probe's radius.
MolecularSurface surface_of_atoms(std::vector<double> coordinates, std::vector<double> radii,
                                  double probe) {
  const WeightedPoints atoms(3, std::move(coordinates), WeightKind::radius, std::move(radii));
  return surface_of(with_probe(atoms, {probe, {}, 0}), probe);
}

// The volume of what lies deeper than the probe, a lattice point for each of many small cubes.
double volume_by_counting(const std::vector<SolidBall>& balls, double probe, int steps) {
  std::array<double, 3> low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-low[0]);
  for (const SolidBall& ball : balls) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], ball.centre[axis] - (ball.radius - probe));
      high[axis] = std::max(high[axis], ball.centre[axis] + (ball.radius - probe));
    }
  }
  Random random(1);
  std::size_t deep = 0;
  const auto along = [&](std::size_t axis, int step) {
    return low[axis] + (high[axis] - low[axis]) * (step + random.uniform()) / steps;
  };
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      for (int k = 0; k < steps; ++k) {
        if (depth_in_union(balls, {along(0, i), along(1, j), along(2, k)}) >= probe) ++deep;
      }
    }
  }
  return static_cast<double>(deep) / (1.0 * steps * steps * steps) * (high[0] - low[0]) *
         (high[1] - low[1]) * (high[2] - low[2]);
}

TEST(MolecularSurface, OfNothingIsEmpty) {
  const MolecularSurface none = surface_of(WeightedPoints(3), 1.4);
  EXPECT_EQ(none.probe, 1.4);
  EXPECT_EQ(none.volume, 0.0);
  EXPECT_EQ(none.area, 0.0);
}

TEST(MolecularSurface, OfOneBallIsTheBall) {
  const MolecularSurface ball = surface_of_atoms({1, 2, 3}, {2}, 1.5);
  EXPECT_NEAR(ball.volume, 32 * pi / 3, 1e-13);
  EXPECT_NEAR(ball.area, 16 * pi, 1e-13);
  EXPECT_EQ(ball.convex_area, ball.area);
  EXPECT_EQ(ball.concave_area, 0.0);
}

TEST(MolecularSurface, WithoutAProbeIsThatOfTheUnion) {
  const MolecularSurface two = surface_of_atoms({0, 0, 0, 0, 1, 0}, {1, 1}, 0.0);
  EXPECT_NEAR(two.volume, 8 * pi / 3 - 5 * pi / 12, 1e-14);
  EXPECT_NEAR(two.area, 6 * pi, 1e-13);
  EXPECT_EQ(two.toroidal_area, 0.0);
}

// Two unit balls whose probe turns about the axis at a distance of 2, and less than its own radius.
TEST(MolecularSurface, OfTwoBallsIsABodyOfRevolution) {
  for (const auto& [distance, probe] : {std::pair{2.0, 1.5}, {3.0, 1.0}, {3.5, 1.0}, {1.0, 5.0}}) {
    SCOPED_TRACE(::testing::Message() << distance << ' ' << probe);
    const MolecularSurface two = surface_of_atoms({0, 0, 0, distance, 0, 0}, {1, 1}, probe);
    // The profile from the middle between the balls on, by the midpoint rule.
    const double c = std::sqrt((1 + probe) * (1 + probe) - distance * distance / 4);
    const double touch = distance / 2 * probe / (1 + probe);  // where the probe meets a ball
    const double cusp = c < probe ? std::sqrt(probe * probe - c * c) : 0.0;
    double volume = 0.0, toroidal = 0.0;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
      // In angle, so that nothing is steep.
      const double begin = std::asin(cusp / probe), end = std::asin(touch / probe);
      const double step = (end - begin) / kSteps, angle = begin + (i + 0.5) * step;
      if (step <= 0.0) break;
      const double radius = c - probe * std::cos(angle);
      volume += 2 * pi * radius * radius * probe * std::cos(angle) * step;
      toroidal += 4 * pi * radius * probe * step;
    }
    const double height = 1 + distance / 2 - touch;  // of the ball's cap
    volume += 2 * pi * height * height * (3 - height) / 3;
    EXPECT_NEAR(two.volume, volume, 1e-9 * volume);
    EXPECT_NEAR(two.toroidal_area, toroidal, 1e-9 * two.area);
    EXPECT_NEAR(two.convex_area, 4 * pi * height, 1e-12);
    EXPECT_EQ(two.concave_area, 0.0);
  }
}

// Three touching unit balls under a probe so large that it falls through between them, and so small
// that it does not.
TEST(MolecularSurface, OfThreeBallsIsWhatCountingSays) {
  const std::vector<double> centres{0, 0, 0, 2, 0, 0, 1, std::sqrt(3.0), 0};
  for (const double probe : {0.1, 0.5, 1.0, 3.0}) {
    SCOPED_TRACE(probe);
    const MolecularSurface three = surface_of_atoms(centres, {1, 1, 1}, probe);
    std::vector<SolidBall> balls;
    for (std::size_t i = 0; i < 3; ++i) {
      balls.push_back({{centres[3 * i], centres[3 * i + 1], centres[3 * i + 2]}, 1 + probe});
    }
    EXPECT_NEAR(three.volume, volume_by_counting(balls, probe, 60), 1e-3 * three.volume);
    EXPECT_EQ(three.concave_area > 0.0, probe > 0.2);
  }
}

// Few balls at random, in which probes reach through triangles and each other.
TEST(MolecularSurface, OfAnyBallsIsWhatCountingSays) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<double> centres, radii;
    std::vector<SolidBall> balls;
    const double probe = random.uniform(0.2, 1.2);
    for (int i = 0; i < 7; ++i) {
      SolidBall ball{{random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2)},
                     random.uniform(0.1, 0.6)};
      centres.insert(centres.end(), ball.centre.begin(), ball.centre.end());
      radii.push_back(ball.radius);
      ball.radius += probe;
      balls.push_back(ball);
    }
    const MolecularSurface surface = surface_of_atoms(centres, radii, probe);
    EXPECT_NEAR(surface.volume, volume_by_counting(balls, probe, 64), 4e-3 * surface.volume);
    EXPECT_GT(surface.concave_area, 0.0);
  }
}

// On a square two probes rest at one place, one on each triangle, and reach into the pyramid below
// it. Whatever rounding makes of their places, their part counts once.
TEST(MolecularSurface, OfProbesAtOnePlaceCountsThemOnce) {
  for (int turn = 0; turn < 40; ++turn) {
    SCOPED_TRACE(turn);
    const double c = turn == 0 ? 1.0 : std::cos(turn), s = turn == 0 ? 0.0 : std::sin(turn);
    std::vector<double> coordinates{0, 0, -1};
    for (const auto& [x, y] : {std::pair{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}) {
      coordinates.insert(coordinates.end(), {c * x - s * y, s * x + c * y, 0.0});
    }
    for (const double radius : {1.5625, 1.6, 2.0}) {
      const WeightedPoints points(3, coordinates, WeightKind::radius,
                                  std::vector<double>(5, radius));
      const double all = surface_of(points, 0.0).volume;
      EXPECT_NEAR(surface_of(points, 4.0).volume, 0.0, 1e-12 * all);
      EXPECT_NEAR(surface_of(points, 4.0).area, 0.0, 1e-12);
      std::vector<SolidBall> balls;
      for (std::size_t i = 0; i < 5; ++i) {
        balls.push_back(
            {{coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]}, radius});
      }
      if (turn != 0) continue;
      const double volume = surface_of(points, 1.0).volume;
      EXPECT_NEAR(volume, volume_by_counting(balls, 1.0, 60), 4e-3 * volume);
    }
  }
}

// The surface moves inwards at speed 1 where the probe grows and the union does not.
TEST(MolecularSurface, IsTheDerivativeOfTheVolume) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<double> coordinates, radii;
    for (int i = 0; i < 30; ++i) {
      for (int axis = 0; axis < 3; ++axis) coordinates.push_back(random.uniform(0, 3));
      radii.push_back(random.uniform(0.8, 1.2));
    }
    const Filtration<3> filtration(regular_triangulation<3>(
        WeightedPoints(3, std::move(coordinates), WeightKind::radius, std::move(radii))));
    const UnionOfBalls balls = union_of_balls(filtration, filtration.index(0.0), 0.0, {});
    for (const double probe : {0.1, 0.4, 0.7}) {
      constexpr double kStep = 1e-5;
      const double lost = molecular_surface(filtration, balls, probe - kStep).volume -
                          molecular_surface(filtration, balls, probe + kStep).volume;
      const double area = molecular_surface(filtration, balls, probe).area;
      EXPECT_NEAR(lost / (2 * kStep), area, 2e-4 * area) << probe;
    }
  }
}

TEST(MolecularSurface, RefusesAProbeThatIsNone) {
  EXPECT_THROW((void)surface_of(WeightedPoints(3), -1.0), InputError);
  EXPECT_THROW((void)surface_of(WeightedPoints(3), std::numeric_limits<double>::quiet_NaN()),
               InputError);
  EXPECT_THROW((void)surface_of(WeightedPoints(3), std::numeric_limits<double>::infinity()),
               InputError);
}

}  // namespace
}  // namespace orthoball
