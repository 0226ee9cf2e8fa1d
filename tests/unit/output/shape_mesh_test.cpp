// SPDX-License-Identifier: MIT
#include "orthoball/output/shape_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

// Six times the signed volume that the triangles enclose.
double enclosed(const ShapeMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const double* p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = &mesh.coordinates[3 * std::size_t{t[i]}];
    sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
           p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
           p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }
  return sum;
}

// A cube of 6^3 lattice points moved a little, so that its inside has many shapes.
Shapes<3> blob() {
  std::vector<double> coordinates;
  for (int i = 0; i < 216; ++i) {
    coordinates.push_back(i % 6 + 0.1 * ((i * 7) % 5));
    coordinates.push_back(i / 6 % 6 + 0.1 * ((i * 11) % 7));
    coordinates.push_back(i / 36 + 0.1 * ((i * 13) % 3));
  }
  return Shapes<3>(coordinates);
}

TEST(ShapeMesh, HoldsEveryKindOfBoundarySimplex) {
  const auto shapes = mixed_shapes();
  const auto mesh =
      shape_mesh(AlphaComplex(shapes.filtration, shapes.filtration.index(1.0)), shapes.points);
  EXPECT_EQ(std::count(mesh.triangle_roles.begin(), mesh.triangle_roles.end(), Role::regular), 8);
  EXPECT_EQ(std::count(mesh.triangle_roles.begin(), mesh.triangle_roles.end(), Role::singular), 1);
  EXPECT_EQ(mesh.edges.size(), 1U);
  ASSERT_EQ(mesh.isolated.size(), 1U);
  EXPECT_EQ(mesh.vertex_count(), 12U);
  EXPECT_EQ(mesh.rows[mesh.isolated[0]], SiteId(11));
  EXPECT_EQ(mesh.coordinates[3 * mesh.isolated[0] + 1], 95.0);
}

TEST(ShapeMesh, RegularizedKeepsRegularFacetsAndTheirVerticesOnly) {
  const auto shapes = mixed_shapes();
  const auto mesh = shape_mesh(
      regularized(AlphaComplex(shapes.filtration, shapes.filtration.index(1.0))), shapes.points);
  EXPECT_EQ(mesh.triangles.size(), 8U);
  EXPECT_TRUE(mesh.edges.empty() && mesh.isolated.empty());
  EXPECT_EQ(mesh.vertex_count(), 6U);
}

TEST(ShapeMesh, RegularTrianglesEncloseTheVolumeOfTheTetrahedraInside) {
  const auto shapes = blob();
  const auto& filtration = shapes.filtration;
  const auto& sites = filtration.triangulation().sites();
  for (std::uint32_t index = 1; index <= filtration.spectrum_size(); index += 37) {
    double inside = 0.0;
    for (std::uint32_t c = 0; c < filtration.count(3); ++c) {
      const SimplexId cell(filtration.table().first(3) + c);
      if (filtration.enters(cell) > index) continue;
      ShapeMesh one;  // the cell's own facets, all pointing away from it
      const auto& corners = filtration.triangulation().cells<3>()[c].corners;
      for (const std::uint32_t v : corners) {
        for (int axis = 0; axis < 3; ++axis) {
          one.coordinates.push_back(shapes.points.coordinate(sites.row(v).row(), axis));
        }
      }
      one.triangles = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
      const double volume = enclosed(one);
      EXPECT_GT(volume, 0.0);
      inside += volume;
    }
    const auto mesh = shape_mesh(regularized(AlphaComplex(filtration, index)), shapes.points);
    EXPECT_NEAR(enclosed(mesh), inside, 1e-9);
  }
}

TEST(ShapeMesh, EveryEdgeOfTheRegularBoundaryIsRunThroughEquallyOftenInBothDirections) {
  const auto shapes = blob();
  for (std::uint32_t index = 1; index <= shapes.filtration.spectrum_size(); index += 23) {
    const auto mesh =
        shape_mesh(regularized(AlphaComplex(shapes.filtration, index)), shapes.points);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    for (const auto& [edge, sum] : balance) EXPECT_EQ(sum, 0);
  }
}

TEST(ShapeMesh, SingularTrianglesOfAFlatSetAllTurnTheSameWay) {
  std::vector<double> coordinates;
  for (int i = 0; i < 25; ++i) {
    for (const double x : {1.0 * (i % 5), 1.0 * (i / 5), 2.0}) coordinates.push_back(x);
  }
  const Shapes<3> shapes(coordinates);
  const auto mesh =
      shape_mesh(AlphaComplex(shapes.filtration, shapes.filtration.spectrum_size()), shapes.points);
  ASSERT_EQ(mesh.triangles.size(), 32U);
  int counterclockwise = 0;
  for (const auto& t : mesh.triangles) {
    EXPECT_EQ(mesh.triangle_roles[0], Role::singular);
    const auto x = [&](std::size_t corner, std::size_t axis) {
      return mesh.coordinates[3 * std::size_t{t[corner]} + axis];
    };
    const double area =
        (x(1, 0) - x(0, 0)) * (x(2, 1) - x(0, 1)) - (x(1, 1) - x(0, 1)) * (x(2, 0) - x(0, 0));
    counterclockwise += area > 0.0 ? 1 : 0;
  }
  EXPECT_TRUE(counterclockwise == 0 || counterclockwise == 32) << counterclockwise;
}

TEST(ShapeMesh, RegularEdgesOfThePlaneHaveTheInsideOnTheirLeft) {
  const auto shapes = checkered(5, [](int x, int y) { return x == 2 && y == 2; });
  const auto mesh =
      shape_mesh(AlphaComplex(shapes.filtration, shapes.filtration.index(0.25)), shapes.points);
  EXPECT_EQ(mesh.edges.size(), 24U);
  double twice_area = 0.0;
  for (const auto& [a, b] : mesh.edges) {
    const double *p = &mesh.coordinates[3 * std::size_t{a}],
                 *q = &mesh.coordinates[3 * std::size_t{b}];
    twice_area += p[0] * q[1] - p[1] * q[0];
    EXPECT_EQ(p[2], 0.0);
  }
  EXPECT_EQ(twice_area, 2.0 * 24.0);
}

TEST(ShapeMesh, IsEmptyAtIndexZeroAndWithoutSites) {
  const auto shapes = mixed_shapes();
  EXPECT_EQ(shape_mesh(AlphaComplex(shapes.filtration, 0), shapes.points).vertex_count(), 0U);
  const Shapes<2> none({});
  EXPECT_EQ(shape_mesh(AlphaComplex(none.filtration, 0), none.points).vertex_count(), 0U);
}

}  // namespace
}  // namespace orthoball
