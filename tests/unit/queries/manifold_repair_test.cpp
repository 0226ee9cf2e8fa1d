// SPDX-License-Identifier: MIT
#include "orthoball/queries/manifold_repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// The cells looked at for each cell around a vertex, of a random half of all cells.
double work(const WeightedPoints& points) {
  const Filtration<3> filtration(regular_triangulation<3>(points));
  const ScaledBalls<3> balls(filtration, filtration.spectrum_size(),
                             -std::numeric_limits<double>::infinity());
  generators::Random random(1);
  std::vector<bool> solid(filtration.count(3));
  for (std::size_t cell = 0; cell < solid.size(); ++cell) solid[cell] = random.coin();
  ManifoldRepair<3> repair(filtration, balls, solid);
  EXPECT_GT(repair.offending().size(), filtration.count(0) / 10);
  repair.run();
  EXPECT_TRUE(repair.offending().empty());
  return static_cast<double>(repair.work()) / (4.0 * static_cast<double>(solid.size()));
}

// Every vertex has about count / 2 cells: an edge joins nearly any two sites of such a curve.
WeightedPoints curve(std::size_t count) {
  std::vector<double> coordinates;
  for (std::size_t row = 0; row < count; ++row) {
    const double angle = 3.0 * static_cast<double>(row) / static_cast<double>(count);
    coordinates.insert(coordinates.end(), {std::cos(angle), std::sin(angle), angle});
  }
  return {3, coordinates, WeightKind::none, {}};
}

// Around the origin, which all cells have.
WeightedPoints cone(std::size_t count) {
  const WeightedPoints sphere =
      generators::points_of(generators::PointFamily::near_sphere, 3, count, 1);
  std::vector<double> coordinates(3, 0.0);
  for (std::size_t row = 0; row < count; ++row) {
    for (int axis = 0; axis < 3; ++axis) coordinates.push_back(sphere.coordinate(row, axis));
  }
  return {3, coordinates, WeightKind::none, {}};
}

TEST(ManifoldRepair, LooksAtEveryCellAsOftenWhereOneVertexHasAllCells) {
  const double few = work(cone(200)), many = work(cone(6400));
  EXPECT_LT(many, 3.0 * few);  // ten times and more if the work grew with the square
}

TEST(ManifoldRepair, LooksAtEveryCellAsOftenWhereAllVerticesHaveManyCells) {
  const double few = work(curve(50)), many = work(curve(200));
  EXPECT_LT(many, 3.0 * few);
}

}  // namespace
}  // namespace orthoball
