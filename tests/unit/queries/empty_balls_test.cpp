// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "orthoball/queries/free_space.h"
#include "orthoball/queries/pockets.h"
#include "unit/queries/filtration_of.h"

namespace orthoball {
namespace {

TEST(EmptyBalls, LieBetweenTheBallsAroundAndShowEveryPocketOnce) {
  constexpr std::size_t kBalls = 300;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0.0, 10.0), radius(0.5, 1.0);
  std::vector<double> x(3 * kBalls), radii(kBalls);
  for (double& one : x) one = coordinate(random);
  for (double& one : radii) one = radius(random);
  const WeightedPoints points(3, x, WeightKind::radius, radii);
  const auto filtration = filtration_of<3>(points);
  const std::uint32_t index = filtration.index(0.0);
  const FreeSpace<3> space(filtration, index, 0.0);
  const auto distance = [](const double* a, const double* b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  std::size_t count = 0;
  for (const Pocket& pocket : pockets<3>(filtration, index, 0.0)) {
    const auto balls = space.empty_balls(pocket.cells);
    count += balls.size();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      EXPECT_GT(balls[i].radius, 0.0);
      if (i > 0) {
        EXPECT_LE(balls[i].radius, balls[i - 1].radius);
      }
      double gap = 1e9;
      for (const LiningBall& ball : pocket.lining) {
        const std::size_t row = ball.row.row();
        gap = std::min(gap, distance(balls[i].centre.data(), &x[3 * row]) - radii[row]);
      }
      EXPECT_NEAR(balls[i].radius, gap, 1e-12);
    }
  }
  EXPECT_GT(count, 50U);
  EXPECT_TRUE(space.empty_balls({}).empty());
}

}  // namespace
}  // namespace orthoball
