// SPDX-License-Identifier: MIT
#include "orthoball/queries/manifold_solid.h"

#include <gtest/gtest.h>

#include <vector>

#include "orthoball/error.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

std::vector<SiteId> rows(std::vector<std::uint32_t> numbers) {
  std::vector<SiteId> result;
  for (const std::uint32_t number : numbers) result.emplace_back(number);
  return result;
}

// Two squares with the corner (1, 1) in common, each of four triangles around its middle.
Shapes<2> two_squares() {
  return checkered(2, [](int x, int y) { return x != y; });
}

TEST(ManifoldSolid, JoinsSquaresThatTouchInACorner) {
  const Shapes<2> shapes = two_squares();
  const auto solid = manifold_solid(AlphaComplex(shapes.filtration, shapes.filtration.index(0.3)));
  ASSERT_EQ(solid.offending.size(), 1U);
  EXPECT_EQ(shapes.points.coordinate(solid.offending[0].row(), 0), 1.0);
  EXPECT_EQ(shapes.points.coordinate(solid.offending[0].row(), 1), 1.0);
  // Of what is as large, the fewest cells: the triangle between them, not two of a square's.
  ASSERT_EQ(solid.changes.size(), 1U);
  EXPECT_TRUE(solid.changes[0].is_added);
  EXPECT_EQ(solid.changes[0].volume, 0.5);
  EXPECT_EQ(solid.changes[0].cells.size(), 1U);
  EXPECT_EQ(solid.changes[0].rows.size(), 3U);
  EXPECT_EQ(solid.added, 0.5);
  EXPECT_EQ(solid.removed, 0.0);
  EXPECT_EQ(solid.volume, 2.5);
  EXPECT_EQ(solid.surface_count, 1U);
  EXPECT_EQ(solid.euler, 0);
}

// Two cubes with a common edge, each with its middle.
Shapes<3> two_cubes() {
  std::vector<double> coordinates;
  for (const int z : {0, 1}) {
    for (const auto& [x, y] :
         std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 2}, {2, 2}}) {
      coordinates.insert(coordinates.end(), {double(x), double(y), double(z)});
    }
  }
  coordinates.insert(coordinates.end(), {0.5, 0.5, 0.5, 1.5, 1.5, 0.5});
  return Shapes<3>(coordinates);
}

TEST(ManifoldSolid, JoinsOrPartsCubesThatTouchInAnEdge) {
  const Shapes<3> shapes = two_cubes();
  const auto solid = manifold_solid(AlphaComplex(shapes.filtration, shapes.filtration.index(0.6)));
  EXPECT_EQ(solid.offending_edges, 1U);
  EXPECT_EQ(solid.offending, rows({3, 10}));
  EXPECT_GT(solid.added + solid.removed, 0.0);
  EXPECT_LE(solid.added + solid.removed, 0.5);  // one of the gaps between them
  EXPECT_NEAR(solid.volume, 2.0 + solid.added - solid.removed, 1e-15);
  EXPECT_EQ(solid.euler, 2 * std::int64_t{solid.surface_count});
}

TEST(ManifoldSolid, LeavesASurfaceThatIsAManifoldAsItIs) {
  const Shapes<3> shapes = two_cubes();
  const auto solid = manifold_solid(
      AlphaComplex(shapes.filtration, shapes.filtration.spectrum_size()));  // the convex hull
  EXPECT_TRUE(solid.offending.empty());
  EXPECT_TRUE(solid.changes.empty());
  EXPECT_EQ(solid.cell_count, shapes.filtration.count(3));
  EXPECT_EQ(solid.volume, 3.0);
  EXPECT_EQ(solid.surface_count, 1U);
  EXPECT_EQ(solid.euler, 2);
}

TEST(ManifoldSolid, HasNoSingularSimplices) {
  const Shapes<3> shapes = mixed_shapes();
  const auto solid = manifold_solid(AlphaComplex(shapes.filtration, shapes.filtration.index(0.6)));
  EXPECT_EQ(solid.cell_count, 0U);
  EXPECT_EQ(solid.area, 0.0);
  const auto octahedron =
      manifold_solid(AlphaComplex(shapes.filtration, shapes.filtration.index(1.0)));
  EXPECT_EQ(octahedron.cell_count, 4U);
  EXPECT_EQ(octahedron.surface_count, 1U);
  EXPECT_NEAR(octahedron.volume, 4.0 / 3, 1e-15);
}

TEST(ManifoldSolid, IsEmptyWhereTheSitesSpanNoSpace) {
  for (const auto& coordinates : {std::vector<double>{}, std::vector<double>{1, 2, 3},
                                  std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}}) {
    const Shapes<3> shapes(coordinates);
    const auto solid =
        manifold_solid(AlphaComplex(shapes.filtration, shapes.filtration.spectrum_size()));
    EXPECT_EQ(solid.cell_count, 0U);
    EXPECT_TRUE(solid.offending.empty());
  }
}

TEST(ManifoldSolid, RefusesAnIndexBeyondTheSpectrum) {
  const Shapes<3> shapes = two_cubes();
  EXPECT_THROW((void)manifold_solid(AlphaComplex(shapes.filtration, shapes.filtration.never())),
               InputError);
}

}  // namespace
}  // namespace orthoball
