// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "generators/random.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Random;

template <int D>
UnionOfBalls union_of(std::vector<double> coordinates, std::vector<double> radii) {
  const WeightedPoints points(D, std::move(coordinates), WeightKind::radius, std::move(radii));
  const Filtration<D> filtration(regular_triangulation<D>(points));
  return union_of_balls(filtration, filtration.index(0.0), 0.0, {.derivatives = true});
}

// General balls that overlap much; some are inside the union.
struct Balls {
  std::vector<double> coordinates, radii;
};
Balls random_balls(int dimension, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Balls balls;
  for (std::size_t i = 0; i < count; ++i) {
    for (int axis = 0; axis < dimension; ++axis) balls.coordinates.push_back(random.uniform());
    balls.radii.push_back(random.uniform(0.15, 0.3));
  }
  return balls;
}

// Central differences, of fourth order. A step over an event, where second derivatives jump or have
// a pole, spoils one number in hundreds: what is compared is the most of them.
template <int D>
void expect_derivatives() {
  constexpr double kStep = 1e-4;
  int all = 0, near = 0;
  const auto compare = [&](double found, const auto& change) {
    const double slope =
        (8 * (change(kStep) - change(-kStep)) - (change(2 * kStep) - change(-2 * kStep))) /
        (12 * kStep);
    ++all;
    if (std::abs(found - slope) < 1e-8) ++near;
    EXPECT_NEAR(found, slope, 0.05);
  };
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Balls balls = random_balls(D, 16, seed);
    const UnionOfBalls found = union_of<D>(balls.coordinates, balls.radii);
    for (std::size_t row = 0; row < balls.radii.size(); ++row) {
      const auto with_radius = [&](double step) {
        std::vector<double> radii = balls.radii;
        radii[row] += step;
        return union_of<D>(balls.coordinates, radii);
      };
      compare(found.areas[row], [&](double step) { return with_radius(step).volume; });
      compare(found.derivatives.area_by_radius[row],
              [&](double step) { return with_radius(step).area; });
      for (std::size_t axis = 0; axis < D; ++axis) {
        const auto with_centre = [&](double step) {
          std::vector<double> coordinates = balls.coordinates;
          coordinates[D * row + axis] += step;
          return union_of<D>(coordinates, balls.radii);
        };
        compare(found.derivatives.volume_by_centre[D * row + axis],
                [&](double step) { return with_centre(step).volume; });
        compare(found.derivatives.area_by_centre[D * row + axis],
                [&](double step) { return with_centre(step).area; });
      }
    }
  }
  EXPECT_GE(near, all * 95 / 100) << all;
}

TEST(UnionDerivatives, AreThoseOfVolumeAndArea) {
  expect_derivatives<2>();
  expect_derivatives<3>();
}

// Moving all balls changes nothing.
TEST(UnionDerivatives, ByCentresAddUpToNothing) {
  const auto expect = []<int D>() {
    const Balls balls = random_balls(D, 400, 7);
    const UnionDerivatives found = union_of<D>(balls.coordinates, balls.radii).derivatives;
    for (std::size_t axis = 0; axis < D; ++axis) {
      double volume = 0.0, area = 0.0, size = 0.0;
      for (std::size_t row = 0; row < balls.radii.size(); ++row) {
        volume += found.volume_by_centre[D * row + axis];
        area += found.area_by_centre[D * row + axis];
        size += std::abs(found.area_by_centre[D * row + axis]);
      }
      EXPECT_GT(size, 0.1);
      EXPECT_NEAR(volume, 0.0, 1e-13);
      EXPECT_NEAR(area, 0.0, 1e-11);
    }
  };
  expect.template operator()<2>();
  expect.template operator()<3>();
}

}  // namespace
}  // namespace orthoball
