// SPDX-License-Identifier: MIT
#include "orthoball/queries/power_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/queries/power_neighbours.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(std::vector<double> coordinates, std::vector<double> weights = {}) {
  const WeightKind kind = weights.empty() ? WeightKind::none : WeightKind::weight;
  return Filtration<D>(regular_triangulation<D>(
      WeightedPoints(D, std::move(coordinates), kind, std::move(weights))));
}

template <int D>
Box<D> box(double lower, double upper) {
  Box<D> result;
  result.lower.fill(lower);
  result.upper.fill(upper);
  return result;
}

const PowerCellOptions kOneThread{.threads = Threads(1)};

template <int D>
std::vector<PowerCell<D>> cells_of(const Filtration<D>& filtration, const Box<D>& in) {
  return power_cells(filtration, in, kOneThread);
}

// [row]: those with a facet in common.
template <int D>
std::set<std::uint32_t> neighbours(const PowerCell<D>& cell) {
  std::set<std::uint32_t> rows;
  for (const PowerFacet& facet : cell.facets) {
    if (facet.neighbour.exists()) rows.insert(facet.neighbour.row());
  }
  EXPECT_EQ(rows.size(), cell.facet_count);
  return rows;
}

TEST(PowerCells, OfAGridAreCubes) {
  std::vector<double> coordinates;
  for (int i = 0; i < 64; ++i) {
    coordinates.insert(coordinates.end(), {i % 4 + 0.1, i / 4 % 4 + 0.1, i / 16 + 0.1});
  }
  const auto cells = cells_of(filtration_of<3>(coordinates), box<3>(-0.4, 3.6));
  ASSERT_EQ(cells.size(), 64U);
  for (const PowerCell<3>& cell : cells) {
    EXPECT_NEAR(cell.volume, 1.0, 1e-14);
    EXPECT_NEAR(cell.area, 6.0, 1e-14);
    EXPECT_EQ(cell.facets.size(), 6U);
    EXPECT_EQ(cell.corners.size(), 8U);
    EXPECT_NEAR(cell.exposed_area, 6.0 - static_cast<double>(neighbours(cell).size()), 1e-14);
    EXPECT_EQ(cell.is_clipped, cell.facet_count < 6);
  }
  EXPECT_EQ(neighbours(cells[21]), (std::set<std::uint32_t>{5, 17, 20, 22, 25, 37}));
  EXPECT_EQ(neighbours(cells[0]), (std::set<std::uint32_t>{1, 4, 16}));
}

// Close packing: corners in which four facets meet.
TEST(PowerCells, OfACloseSpherePackingAreRhombicDodecahedra) {
  std::vector<double> coordinates;
  for (int i = 0; i < 125; ++i) {
    const int x = i % 5, y = i / 5 % 5, z = i / 25;
    if ((x + y + z) % 2 == 0) coordinates.insert(coordinates.end(), {0.3 * x, 0.3 * y, 0.3 * z});
  }
  const auto cells = cells_of(filtration_of<3>(coordinates), box<3>(-1, 2));
  std::size_t inner = 0;
  for (const PowerCell<3>& cell : cells) {
    if (cell.is_clipped) continue;
    ++inner;
    EXPECT_NEAR(cell.volume, 2 * 0.027, 1e-15);
    EXPECT_EQ(cell.facet_count, 12U);
    EXPECT_EQ(cell.facets.size(), 12U);
    EXPECT_EQ(cell.corners.size(), 14U);
  }
  EXPECT_EQ(inner, 13U);
}

TEST(PowerCells, OfATriangularLatticeAreHexagons) {
  std::vector<double> coordinates;
  for (int y = -3; y <= 3; ++y) {
    for (int x = -3; x <= 3; ++x) {
      coordinates.insert(coordinates.end(), {x + 0.5 * y, y * std::sqrt(0.75)});
    }
  }
  const auto cells = cells_of(filtration_of<2>(coordinates), box<2>(-9, 9));
  const PowerCell<2>& middle = cells[24];
  EXPECT_NEAR(middle.volume, std::sqrt(0.75), 1e-14);
  EXPECT_NEAR(middle.area, 2 * std::sqrt(3.0), 1e-14);
  EXPECT_EQ(middle.corners.size(), 6U);
  EXPECT_EQ(neighbours(middle), (std::set<std::uint32_t>{17, 18, 23, 25, 30, 31}));
  EXPECT_FALSE(middle.is_clipped);
}

TEST(PowerCells, AreHalvesOfTheBoxForTwoBalls) {
  // Radii 2 and 1 at distance 3: equal power at 2 from the first.
  const auto filtration = filtration_of<3>({0, 0, 0, 3, 0, 0}, {4, 1});
  const auto cells = cells_of(filtration, box<3>(-5, 5));
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_NEAR(cells[0].volume, 700.0, 1e-12);
  EXPECT_NEAR(cells[1].volume, 300.0, 1e-12);
  EXPECT_NEAR(cells[0].area, 480.0, 1e-12);
  EXPECT_NEAR(cells[0].exposed_area, 380.0, 1e-12);
  for (const PowerCell<3>& cell : cells) {
    EXPECT_TRUE(cell.is_clipped);
    EXPECT_EQ(cell.facets.size(), 6U);
    for (const PowerFacet& facet : cell.facets) {
      if (facet.neighbour.exists()) continue;
      for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
        EXPECT_EQ(cell.corners[cell.loops[i]][facet.side / 2], facet.side % 2 == 0 ? -5.0 : 5.0);
      }
    }
  }
}

TEST(PowerCells, MayLieBeyondTheBoxOrFarFromTheirSites) {
  // The small ball's cell begins beyond the large ball.
  const auto filtration = filtration_of<2>({0, 0, 1, 0}, {9, 0});
  const auto cells = cells_of(filtration, box<2>(-2, 2));
  EXPECT_EQ(cells[0].volume, 16.0);
  EXPECT_EQ(cells[1].volume, 0.0);
  EXPECT_TRUE(cells[0].is_clipped && cells[1].is_clipped);
  EXPECT_TRUE(cells[1].facets.empty());
  const auto wide = cells_of(filtration, box<2>(-8, 8));
  EXPECT_EQ(wide[1].volume, 16.0 * 3);
}

TEST(PowerCells, AreNoneOfHiddenSitesAndDuplicates) {
  const auto filtration = filtration_of<2>({0, 0, 0, 0, 0.1, 0, 4, 0, 0, 4}, {4, 4, 0, 1, 1});
  const auto cells = cells_of(filtration, box<2>(-9, 9));
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[0].row.row(), 0U);
  EXPECT_EQ(cells[1].row.row(), 3U);
  EXPECT_EQ(cells[2].row.row(), 4U);
  EXPECT_NEAR(cells[0].volume + cells[1].volume + cells[2].volume, 324.0, 1e-12);
}

TEST(PowerCells, OfOneSiteIsTheBox) {
  const auto cells = cells_of(filtration_of<3>({1, 2, 3}), box<3>(-5, 5));
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].volume, 1000.0);
  EXPECT_EQ(cells[0].exposed_area, 600.0);
  EXPECT_EQ(cells[0].facet_count, 0U);
  EXPECT_TRUE(cells_of(filtration_of<3>({}), box<3>(0, 1)).empty());
}

TEST(PowerCells, OfSitesInAPlaneOrOnALineReachThroughTheBox) {
  const auto plane = filtration_of<3>({0, 0, 1, 2, 0, 1, 0, 2, 1, 2, 2, 1, 1, 1, 1});
  const auto cells = cells_of(plane, box<3>(-1, 3));
  ASSERT_EQ(cells.size(), 5U);
  EXPECT_NEAR(cells[4].volume, 2.0 * 4, 1e-14);
  EXPECT_EQ(neighbours(cells[4]), (std::set<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_NEAR(cells[0].volume, 3.5 * 4, 1e-14);
  const auto line = filtration_of<3>({0, 0, 0, 1, 1, 1, 3, 3, 3});
  double sum = 0.0;
  for (const PowerCell<3>& cell : cells_of(line, box<3>(-1, 4))) sum += cell.volume;
  EXPECT_NEAR(sum, 125.0, 1e-12);
}

// A site whose lifted point is between those of two others has a cell without an inside.
TEST(PowerCells, ThatAreFlatHaveNoFacetsAndJoinTheirSides) {
  for (const bool is_on_a_line : {true, false}) {
    std::vector<double> coordinates{-1, 0, 0, 0, 1, 0}, weights{0, -1, 0};
    if (!is_on_a_line) {
      coordinates.insert(coordinates.end(), {0, 3, 0, -3});
      weights.insert(weights.end(), {0, 0});
    }
    const auto filtration = filtration_of<2>(coordinates, weights);
    const auto cells = cells_of(filtration, box<2>(-5, 5));
    ASSERT_EQ(cells.size(), is_on_a_line ? 3U : 5U);
    EXPECT_EQ(cells[1].volume, 0.0);
    EXPECT_TRUE(cells[1].facets.empty());
    EXPECT_FALSE(cells[1].is_clipped);
    EXPECT_TRUE(neighbours(cells[0]).count(2));
    EXPECT_FALSE(neighbours(cells[0]).count(1));
    EXPECT_NEAR(cells[0].volume, cells[2].volume, 1e-13);
    double sum = 0.0;
    for (const PowerCell<2>& cell : cells) sum += cell.volume;
    EXPECT_NEAR(sum, 100.0, 1e-12);
  }
}

// The middle of an edge, of a triangle and of a tetrahedron, lifted to their planes.
TEST(PowerCells, MayBeFlatInSpaceToo) {
  const std::vector<double> corners{0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4};
  for (const auto& [middle, weight] : {std::pair{std::array{1.0, 0.0, 0.0}, -3.0},
                                       {std::array{1.0, 1.0, 0.0}, -6.0},
                                       {std::array{1.0, 1.0, 1.0}, -9.0}}) {
    std::vector<double> coordinates = corners;
    coordinates.insert(coordinates.end(), middle.begin(), middle.end());
    const auto filtration = filtration_of<3>(coordinates, {0, 0, 0, 0, weight});
    const auto cells = cells_of(filtration, box<3>(-3, 7));
    ASSERT_EQ(cells.size(), 5U);
    EXPECT_EQ(cells[4].volume, 0.0);
    EXPECT_TRUE(cells[4].facets.empty());
    const auto plain = cells_of(filtration_of<3>(corners), box<3>(-3, 7));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(cells[i].volume, plain[i].volume);
      EXPECT_EQ(neighbours(cells[i]), neighbours(plain[i]));
    }
  }
}

TEST(PowerCells, BoxIsMovedOutByATenthOfTheLongestSide) {
  const auto filtration = filtration_of<2>({0, 0, 6, 0}, {4, -1});
  const Box<2> with_balls = box_around(filtration, 0.0);
  EXPECT_EQ(with_balls.lower, (std::array{-2 - 0.8, -2 - 0.8}));
  EXPECT_EQ(with_balls.upper, (std::array{6 + 0.8, 2 + 0.8}));
  const Box<2> larger = box_around(filtration, 5.0);
  EXPECT_NEAR(larger.upper[0], 8 + 1.1, 1e-14);
  const Box<2> point = box_around(filtration_of<2>({3, 4}), 0.0);
  EXPECT_EQ(point.lower, (std::array{2.5, 3.5}));
  const Box<2> far = box_around(filtration_of<2>({1e20, 4e20}), 0.0);
  EXPECT_LT(far.lower[0], far.upper[0]);
  EXPECT_THROW((void)box_around(filtration, std::nan("")), InputError);
}

TEST(PowerCells, RefuseABoxWithoutAnInside) {
  const auto filtration = filtration_of<2>({0, 0, 6, 0});
  for (const Box<2>& bad : {box<2>(1, 1), box<2>(1, 0), box<2>(0, HUGE_VAL),
                            box<2>(std::nan(""), 1), box<2>(0, 1e300)}) {
    EXPECT_THROW((void)power_cells(filtration, bad, kOneThread), InputError);
  }
}

TEST(PowerCellsInBalls, HaveTheNumbersOfTheUnion) {
  const auto filtration = filtration_of<3>({0, 0, 0, 1, 0, 0, 9, 0, 0, 20, 0, 0}, {1, 1, 1, -1});
  const std::uint32_t index = filtration.index(0.0);
  const UnionOfBalls balls =
      union_of_balls(filtration, index, 0.0, {.contacts = true, .threads = Threads(1)});
  const auto cells = power_cells_in_balls(filtration, balls, kOneThread);
  ASSERT_EQ(cells.size(), 3U);
  const double contact = 0.75 * std::numbers::pi;
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(cells[row].volume, balls.volumes[row]);
    EXPECT_EQ(cells[row].exposed_area, balls.areas[row]);
    EXPECT_DOUBLE_EQ(cells[row].area, balls.areas[row] + contact);
    EXPECT_EQ(neighbours(cells[row]), (std::set{1 - static_cast<std::uint32_t>(row)}));
    EXPECT_TRUE(cells[row].is_clipped);
  }
  EXPECT_EQ(neighbours(cells[2]).size(), 0U);
}

}  // namespace
}  // namespace orthoball
