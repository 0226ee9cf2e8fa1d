// SPDX-License-Identifier: MIT
#include "orthoball/output/region_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/queries/pockets.h"
#include "orthoball/queries/voids.h"
#include "unit/output/shapes.h"

namespace orthoball {
namespace {

std::vector<std::span<const SimplexId>> cells_of(const auto& holes) {
  std::vector<std::span<const SimplexId>> cells;
  for (const auto& hole : holes) cells.push_back(hole.cells);
  return cells;
}

// Balls on the corners of `n` unit cubes in a row, each with a void in its middle.
Shapes<3> cubes(int n) {
  std::vector<double> coordinates;
  for (int x = 0; x <= n; ++x) {
    for (const auto& [y, z] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
      coordinates.insert(coordinates.end(), {double(x), double(y), double(z)});
    }
  }
  return Shapes<3>(std::move(coordinates));
}

// The boundary of every region is closed, has no vertex of another, and encloses `volume`.
TEST(RegionMesh, HasAClosedSetOfTrianglesForEveryVoid) {
  constexpr double kAlpha2 = 0.6;  // the squares are filled, the cubes are not
  const Shapes<3> shapes = cubes(3);
  const std::uint32_t index = shapes.filtration.index(kAlpha2);
  const auto holes = voids<3>(shapes.filtration, index, kAlpha2, VoidsOf::shape);
  ASSERT_EQ(holes.size(), 3U);
  const auto mesh = region_mesh<3>(shapes.filtration, shapes.points, index, cells_of(holes));
  EXPECT_EQ(mesh.rows.size(), 24U);
  EXPECT_EQ(mesh.facets.size(), 36U);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  std::map<std::uint32_t, std::uint32_t> region_of_vertex;
  std::vector<double> volumes(holes.size());
  const auto x = [&](std::uint32_t v) { return &mesh.coordinates[3 * std::size_t{v}]; };
  for (std::size_t i = 0; i < mesh.facets.size(); ++i) {
    EXPECT_FALSE(mesh.are_open[i]);
    const auto& [a, b, c] = mesh.facets[i];
    for (const auto& side : {std::pair{a, b}, {b, c}, {c, a}}) ++sides[side];
    for (const std::uint32_t v : mesh.facets[i]) {
      EXPECT_EQ(region_of_vertex.try_emplace(v, mesh.regions[i]).first->second, mesh.regions[i]);
    }
    volumes[mesh.regions[i]] += (x(a)[0] * (x(b)[1] * x(c)[2] - x(b)[2] * x(c)[1]) -
                                 x(a)[1] * (x(b)[0] * x(c)[2] - x(b)[2] * x(c)[0]) +
                                 x(a)[2] * (x(b)[0] * x(c)[1] - x(b)[1] * x(c)[0])) /
                                6;
  }
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(sides.count({side.second, side.first}), 1U);
  }
  for (const double volume : volumes) EXPECT_NEAR(volume, 1.0, 1e-12);
  for (std::size_t v = 0; v < mesh.rows.size(); ++v) {
    EXPECT_EQ(mesh.coordinates[3 * v], shapes.points.coordinate(mesh.rows[v].row(), 0));
  }
}

TEST(RegionMesh, TellsTheMouthsOfPockets) {
  const Shapes<3> shapes = cubes(1);
  const std::uint32_t index = shapes.filtration.index(0.25);  // edges of the cube, no squares
  const auto found = pockets<3>(shapes.filtration, index, 0.25);
  ASSERT_EQ(found.size(), 1U);
  const auto mesh = region_mesh<3>(shapes.filtration, shapes.points, index, cells_of(found));
  std::size_t open = 0;
  for (const bool is_open : mesh.are_open) open += is_open ? 1 : 0;
  std::size_t facets = 0;
  for (const Mouth& mouth : found[0].mouths) facets += mouth.facets.size();
  EXPECT_EQ(open, facets);
  EXPECT_EQ(open, 12U);
}

TEST(RegionMesh, IsMadeOfEdgesInThePlane) {
  const Shapes<2> shapes = checkered(3, [](int x, int y) { return x == 1 && y == 1; });
  const double alpha2 = 0.26;
  const std::uint32_t index = shapes.filtration.index(alpha2);
  const auto holes = voids<2>(shapes.filtration, index, alpha2, VoidsOf::shape);
  ASSERT_EQ(holes.size(), 1U);
  const auto mesh = region_mesh<2>(shapes.filtration, shapes.points, index, cells_of(holes));
  ASSERT_EQ(mesh.facets.size(), 4U);
  double twice_area = 0.0;
  for (const auto& [a, b] : mesh.facets) {
    twice_area += mesh.coordinates[3 * a] * mesh.coordinates[3 * b + 1] -
                  mesh.coordinates[3 * b] * mesh.coordinates[3 * a + 1];
  }
  EXPECT_NEAR(twice_area, 2.0, 1e-12);
}

TEST(RegionMesh, IsWrittenAsPly) {
  RegionMesh<3> mesh;
  mesh.coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0.5};
  mesh.rows = {SiteId(4), SiteId(5), SiteId(9)};
  mesh.facets = {{0, 1, 2}};
  mesh.regions = {1};
  mesh.are_open = {true};
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment some pockets\n"
      "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "property uint row\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property int pocket\n";
  const std::string text = written([&](ByteSink& s) {
    write_region_ply(s, mesh, {"some pockets", "pocket", true});
  });
  EXPECT_EQ(text.substr(0, header.size()), header);
  const std::string end = "property uchar mouth\nend_header\n";
  EXPECT_EQ(text.substr(header.size(), end.size()), end);
  ASSERT_EQ(text.size(), header.size() + end.size() + 3 * 28 + 13 + 5);
  EXPECT_EQ(text.substr(text.size() - 5), std::string("\2\0\0\0\1", 5));
  const std::string shorter = written([&](ByteSink& s) {
    write_region_ply(s, mesh, {"some voids", "void", false});
  });
  EXPECT_EQ(shorter.find("mouth"), std::string::npos);
}

}  // namespace
}  // namespace orthoball
