// SPDX-License-Identifier: MIT
#include "orthoball/queries/largest_ball.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "orthoball/queries/voids.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// Balls of very different radii around a chamber: `large` along one side, `small` along the others,
// and as many large ones beside them as hide the chamber from whoever looks for large orthoballs.
WeightedPoints walls_around_a_chamber() {
  std::vector<double> coordinates, radii;
  const auto add = [&](double x, double y, double radius) {
    coordinates.insert(coordinates.end(), {x, y});
    radii.push_back(radius);
  };
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 8; ++k) add(10.5 + 21 * i, 10.5 + 21 * k, 10.0);
  }
  const double right = 188.0;
  for (double x = -1.0; x <= right; x += 0.8) {
    add(x, -1.0, 0.5);
    add(x, 169.0, 0.5);
  }
  for (double y = -0.2; y < 169.0; y += 0.8) {
    add(-1.0, y, 0.5);
    add(right, y, 0.5);
  }
  return {2, coordinates, WeightKind::radius, radii};
}

TEST(LargestBall, IsInTheChamberAndNotBetweenLargeBalls) {
  const Filtration<2> filtration(regular_triangulation<2>(walls_around_a_chamber()));
  const auto holes = voids(filtration, filtration.index(0.0), 0.0, VoidsOf::balls, Threads(1));
  ASSERT_EQ(holes.size(), 1U);
  // It touches two of the disks at x = 157.5, and nearly the line x = 187.5.
  EXPECT_NEAR(holes[0].largest_ball_radius, 910.25 / 80, 0.01);
  EXPECT_GT(holes[0].largest_ball_centre[0], 165.0);
}

// The largest gap over points spread through all cells of a void.
template <int D>
double sampled(const Filtration<D>& filtration, const WeightedPoints& points, const Void<D>& hole,
               std::mt19937_64& random) {
  std::exponential_distribution<double> share(1.0);
  double largest = 0.0;
  for (const SimplexId cell : hole.cells) {
    const auto rows = filtration.rows(cell);
    for (int turn = 0; turn < 200; ++turn) {
      std::array<double, std::size_t{D}> x{};
      double sum = 0.0;
      for (const SiteId row : rows) {
        const double part = share(random);
        sum += part;
        for (int axis = 0; axis < D; ++axis) {
          x[static_cast<std::size_t>(axis)] += part * points.coordinate(row.row(), axis);
        }
      }
      double gap = INFINITY;
      for (const LiningBall& ball : hole.lining) {
        double square = 0.0;
        for (int axis = 0; axis < D; ++axis) {
          const double way =
              x[static_cast<std::size_t>(axis)] / sum - points.coordinate(ball.row.row(), axis);
          square += way * way;
        }
        gap = std::min(gap, std::sqrt(square) - std::sqrt(points.weight(ball.row.row())));
      }
      largest = std::max(largest, gap);
    }
  }
  return largest;
}

template <int D>
std::size_t expect_no_larger_ball_in_samples(std::uint64_t seed, double most_radius) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<double> coordinates, radii;
  for (int i = 0; i < (D == 2 ? 150 : 400); ++i) {
    for (int axis = 0; axis < D; ++axis) coordinates.push_back(10 * share(random));
    radii.push_back(0.05 + most_radius * std::pow(share(random), 6));
  }
  const WeightedPoints points(D, coordinates, WeightKind::radius, radii);
  const Filtration<D> filtration(regular_triangulation<D>(points));
  // Larger balls close voids; their squared radii stay what the program says.
  const double alpha2 = D == 2 ? 0.25 : 0.4;
  std::vector<double> larger(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) larger[row] = points.weight(row) + alpha2;
  const WeightedPoints grown(D, coordinates, WeightKind::weight, larger);
  std::size_t found = 0;
  for (const Void<D>& hole :
       voids(filtration, filtration.index(alpha2), alpha2, VoidsOf::balls, Threads(1))) {
    const double sample = sampled(filtration, grown, hole, random);
    double least = INFINITY;
    for (const LiningBall& ball : hole.lining) {
      least = std::min(least, std::sqrt(grown.weight(ball.row.row())));
    }
    const double found_radius = hole.largest_ball_radius;
    EXPECT_GE(found_radius + std::max(found_radius / 128, least / 1024), sample) << "seed " << seed;
    found += hole.largest_ball_radius > 0.0 ? 1 : 0;
  }
  return found;
}

TEST(LargestBall, IsAsLargeAsAnyOfManySamples) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    found += expect_no_larger_ball_in_samples<2>(seed, 2.0);
    found += expect_no_larger_ball_in_samples<3>(seed, 2.0);
  }
  EXPECT_GT(found, 20U);
}

TEST(LargestBall, IsNoneWithoutCells) {
  const std::vector<Sphere<2>> balls{{{0, 0}, 1, 1}, {{3, 0}, 1, 1}, {{0, 3}, 1, 1}};
  EXPECT_LT(largest_ball<2>({}, balls).radius, 0.0);
  EXPECT_LT(largest_ball<3>({}, {}).radius, 0.0);
}

}  // namespace
}  // namespace orthoball
