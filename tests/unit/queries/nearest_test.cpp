// SPDX-License-Identifier: MIT
#include "orthoball/queries/nearest.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

TEST(NearestOnBoundary, OfATetrahedronIsOnFacesEdgesAndCorners) {
  const auto filtration = filtration_of<3>(
      WeightedPoints(3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4}, WeightKind::none, {}));
  const WeightedPoints points(3, {1, 1, -2, 2, -3, -4, -1, -2, -2, 0.5, 1, 1, 4, 4, 4},
                              WeightKind::none, {});
  const auto found =
      nearest_on_boundary(AlphaComplex(filtration, filtration.spectrum_size()), points);
  ASSERT_EQ(found.size(), 5U);
  using Point = std::array<double, 3>;
  EXPECT_EQ(found[0].point, (Point{1, 1, 0}));
  EXPECT_EQ(found[0].distance, 2.0);
  EXPECT_EQ(filtration.dimension(found[0].simplex), 2);
  EXPECT_EQ(found[1].point, (Point{2, 0, 0}));
  EXPECT_EQ(found[1].distance, 5.0);
  EXPECT_EQ(found[2].point, (Point{0, 0, 0}));
  EXPECT_EQ(found[2].distance, 3.0);
  EXPECT_EQ(found[3].distance, 0.5);  // from inside
  EXPECT_NEAR(found[4].distance, 8 / std::sqrt(3.0), 1e-14);
  for (const double x : found[4].point) EXPECT_NEAR(x, 4.0 / 3, 1e-14);
}

TEST(NearestOnBoundary, SingularSimplicesCountUnlessRegularized) {
  // A triangle, an edge and a point.
  const auto filtration = filtration_of<2>(
      WeightedPoints(2, {0, 0, 1, 0, 0, 1, 10, 0, 11, 0, 20, 0}, WeightKind::none, {}));
  const std::uint32_t index = filtration.index(0.5);
  const WeightedPoints points(2, {10.5, 3, 20, 4}, WeightKind::none, {});
  const auto all = nearest_on_boundary(AlphaComplex(filtration, index), points);
  EXPECT_EQ(all[0].distance, 3.0);
  EXPECT_EQ(filtration.dimension(all[0].simplex), 1);
  EXPECT_EQ(all[1].distance, 4.0);
  EXPECT_EQ(filtration.dimension(all[1].simplex), 0);
  const auto solid = nearest_on_boundary(regularized(AlphaComplex(filtration, index)), points);
  EXPECT_EQ(solid[0].point, (std::array<double, 2>{1, 0}));
  EXPECT_EQ(solid[0].distance, std::hypot(9.5, 3.0));
}

TEST(NearestOnBoundary, PointsSoFarThatSquaresOverflowHaveTheirDistance) {
  for (const double size : {1.0, 0x1p-900, 0x1p600}) {
    const auto filtration =
        filtration_of<2>(WeightedPoints(2, {0, 0, size, 0, 0, size}, WeightKind::none, {}));
    const WeightedPoints points(2, {0x1p1000, 0, -0x1.8p900, 0x1p901, 3 * size, 4 * size},
                                WeightKind::none, {});
    const auto found =
        nearest_on_boundary(AlphaComplex(filtration, filtration.spectrum_size()), points);
    EXPECT_TRUE(found[0].simplex.exists());
    EXPECT_EQ(found[0].distance, 0x1p1000);
    EXPECT_EQ(found[1].distance, 0x1.4p901);
    EXPECT_NEAR(found[2].distance / size, std::sqrt(18.0), 1e-15 * 18);
  }
}

TEST(NearestOnBoundary, WithoutBoundaryThereIsNone) {
  const auto filtration = filtration_of<2>(WeightedPoints(2, {0, 0, 1, 0}, WeightKind::none, {}));
  const WeightedPoints points(2, {0, 0}, WeightKind::none, {});
  const auto found = nearest_on_boundary(AlphaComplex(filtration, 0), points);
  EXPECT_FALSE(found[0].simplex.exists());
  EXPECT_TRUE(std::isinf(found[0].distance));
  EXPECT_THROW((void)nearest_on_boundary(AlphaComplex(filtration, filtration.never()), points),
               InputError);
}

template <int D>
using Point = std::array<double, std::size_t{D}>;

template <int D>
double distance(const Point<D>& a, const Point<D>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < D; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

// Random points of random simplices of the boundary are no nearer than what was found, and that is
// a point of its simplex: the corners see it in no smaller a simplex.
template <int D>
void is_nearest(const WeightedPoints& points, std::uint64_t seed) {
  const auto filtration = filtration_of<D>(points);
  const std::uint32_t index = filtration.spectrum_size() / 2;
  std::vector<SimplexId> boundary;
  for (std::uint32_t row = 0; row < filtration.size(); ++row) {
    const Role role = filtration.role(SimplexId(row), index);
    const bool is_facet = filtration.dimension(SimplexId(row)) == D - 1;
    if (role == Role::singular || (is_facet && role == Role::regular)) {
      boundary.emplace_back(row);
    }
  }
  if (boundary.empty()) return;
  generators::Random random(seed);
  const auto position = [&](VertexId vertex) {
    const std::uint32_t row = filtration.triangulation().sites().row(vertex.row()).row();
    Point<D> x;
    for (int axis = 0; axis < D; ++axis) {
      x[static_cast<std::size_t>(axis)] = points.coordinate(row, axis);
    }
    return x;
  };
  const auto random_point_of = [&](SimplexId simplex) {
    Point<D> sum{};
    double total = 0.0;
    for (const VertexId vertex : filtration.vertices(simplex)) {
      const double weight = random.uniform();
      total += weight;
      for (std::size_t i = 0; i < D; ++i) sum[i] += weight * position(vertex)[i];
    }
    for (double& x : sum) x /= total;
    return sum;
  };
  std::vector<double> queries;
  for (int i = 0; i < 40; ++i) {
    const auto row =
        static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1));
    for (int axis = 0; axis < D; ++axis) {
      queries.push_back(points.coordinate(row, axis) * random.uniform(0.5, 1.5));
    }
  }
  const auto found = nearest_on_boundary(AlphaComplex(filtration, index),
                                         WeightedPoints(D, queries, WeightKind::none, {}));
  for (std::size_t i = 0; i < found.size(); ++i) {
    Point<D> query;
    for (std::size_t axis = 0; axis < D; ++axis) query[axis] = queries[D * i + axis];
    const double size = 1e-12 * (found[i].distance + distance<D>(query, {}) + 1e-300);
    EXPECT_NEAR(distance<D>(query, found[i].point), found[i].distance, size);
    const auto vertices = filtration.vertices(found[i].simplex);
    if (vertices.size() == 1) {
      EXPECT_NEAR(distance<D>(found[i].point, position(vertices[0])), 0.0, size);
    } else if (vertices.size() == 2) {
      const Point<D> a = position(vertices[0]), b = position(vertices[1]);
      EXPECT_NEAR(distance<D>(a, found[i].point) + distance<D>(found[i].point, b),
                  distance<D>(a, b), size);
    }
    for (int sample = 0; sample < 200; ++sample) {
      const int last = static_cast<int>(boundary.size()) - 1;
      const Point<D> other =
          random_point_of(boundary[static_cast<std::size_t>(random.integer(0, last))]);
      EXPECT_GE(distance<D>(query, other), found[i].distance - size);
    }
  }
}

TEST(NearestOnBoundary, NothingOfTheBoundaryIsNearer) {
  for (const auto family : generators::point_families()) {
    if (generators::is_extreme(family)) continue;
    SCOPED_TRACE(generators::name(family));
    is_nearest<2>(generators::points_of(family, 2, 60, 2), 1);
    is_nearest<3>(generators::points_of(family, 3, 60, 2), 1);
  }
}

}  // namespace
}  // namespace orthoball
