// SPDX-License-Identifier: MIT
#include "orthoball/output/polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "unit/output/shapes.h"

namespace orthoball {
namespace {

double area(const Shapes<2>& shapes, const std::vector<VertexId>& ring) {
  const auto& sites = shapes.filtration.triangulation().sites();
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t a = sites.row(ring[i].row()).row();
    const std::size_t b = sites.row(ring[(i + 1) % ring.size()].row()).row();
    twice += shapes.points.coordinate(a, 0) * shapes.points.coordinate(b, 1) -
             shapes.points.coordinate(a, 1) * shapes.points.coordinate(b, 0);
  }
  return twice / 2.0;
}

std::vector<Polygon> polygons_of(const Shapes<2>& shapes, double alpha2) {
  auto found = polygons(AlphaComplex(shapes.filtration, shapes.filtration.index(alpha2)));
  for (const Polygon& polygon : found) {
    for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
      const auto& ring = polygon.rings[r];
      EXPECT_EQ(std::set<VertexId>(ring.begin(), ring.end()).size(), ring.size());
      EXPECT_EQ(area(shapes, ring) > 0.0, r == 0);
    }
  }
  return found;
}

TEST(Polygons, AHoleIsAClockwiseRingOfItsPolygon) {
  const auto shapes = checkered(5, [](int x, int y) { return x == 2 && y == 2; });
  const auto found = polygons_of(shapes, 0.25);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].rings.size(), 2U);
  EXPECT_EQ(area(shapes, found[0].rings[0]), 25.0);
  EXPECT_EQ(area(shapes, found[0].rings[1]), -1.0);
}

TEST(Polygons, PartsThatTouchInAVertexArePolygonsOfTheirOwn) {
  const auto shapes = checkered(2, [](int x, int y) { return x == y; });
  const auto found = polygons_of(shapes, 0.25);
  ASSERT_EQ(found.size(), 2U);
  for (const Polygon& polygon : found) {
    ASSERT_EQ(polygon.rings.size(), 1U);
    EXPECT_EQ(area(shapes, polygon.rings[0]), 1.0);
  }
}

TEST(Polygons, AHoleThatTouchesTheOutsideInAVertexStaysAHole) {
  // The corner cell (0, 0) is missing and the hole (1, 1) touches that gap in one vertex.
  const auto shapes =
      checkered(4, [](int x, int y) { return (x == 0 && y == 0) || (x == 1 && y == 1); });
  const auto found = polygons_of(shapes, 0.25);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].rings.size(), 2U);
  EXPECT_EQ(area(shapes, found[0].rings[0]), 15.0);
  EXPECT_EQ(area(shapes, found[0].rings[1]), -1.0);
}

TEST(Polygons, HolesThatTouchEachOtherInAVertexAreTwoRings) {
  const auto shapes = checkered(5, [](int x, int y) { return x == y && (x == 1 || x == 2); });
  const auto found = polygons_of(shapes, 0.25);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].rings.size(), 3U);
}

TEST(Polygons, AnIslandInAHoleIsAPolygonOfItsOwn) {
  const auto shapes = checkered(
      7, [](int x, int y) { return x > 0 && x < 6 && y > 0 && y < 6 && !(x == 3 && y == 3); });
  const auto found = polygons_of(shapes, 0.25);
  ASSERT_EQ(found.size(), 2U);
  std::vector<std::size_t> rings{found[0].rings.size(), found[1].rings.size()};
  std::sort(rings.begin(), rings.end());
  EXPECT_EQ(rings, (std::vector<std::size_t>{1, 2}));
}

TEST(Polygons, AChessboardIsOnePolygonAField) {
  const auto shapes = checkered(6, [](int x, int y) { return (x + y) % 2 == 1; });
  EXPECT_EQ(polygons_of(shapes, 0.25).size(), 18U);
}

TEST(Polygons, RingsEncloseTheTrianglesOfEveryShape) {
  std::vector<double> coordinates;
  for (int i = 0; i < 150; ++i) {
    coordinates.push_back((i * 7919) % 101);
    coordinates.push_back((i * 104729) % 97);
  }
  const Shapes<2> shapes(coordinates);
  const auto& filtration = shapes.filtration;
  for (std::uint32_t index = 1; index <= filtration.spectrum_size(); index += 5) {
    double inside = 0.0, enclosed = 0.0;
    for (std::uint32_t c = 0; c < filtration.count(2); ++c) {
      if (filtration.enters(SimplexId(filtration.table().first(2) + c)) > index) continue;
      std::vector<VertexId> corners;
      for (const auto v : filtration.triangulation().cells<2>()[c].corners) {
        corners.emplace_back(v);
      }
      inside += area(shapes, corners);
    }
    for (const Polygon& polygon : polygons_of(shapes, filtration.alpha2(index))) {
      for (const auto& ring : polygon.rings) enclosed += area(shapes, ring);
    }
    EXPECT_EQ(enclosed, inside) << index;
  }
}

TEST(Polygons, ThereAreNoneWithoutTriangles) {
  EXPECT_TRUE(polygons_of(Shapes<2>({}), 1.0).empty());
  EXPECT_TRUE(polygons_of(Shapes<2>({0, 0, 1, 1, 2, 2}), 9.0).empty());
}

}  // namespace
}  // namespace orthoball
