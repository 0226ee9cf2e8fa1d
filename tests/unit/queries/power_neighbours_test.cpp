// SPDX-License-Identifier: MIT
#include "orthoball/queries/power_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// [row]: the rows of its neighbours.
template <int D>
std::vector<std::vector<std::uint32_t>> neighbours_by_row(std::vector<double> coordinates,
                                                          std::vector<double> weights = {}) {
  const WeightKind kind = weights.empty() ? WeightKind::none : WeightKind::weight;
  const WeightedPoints points(D, std::move(coordinates), kind, std::move(weights));
  const Filtration<D> filtration(regular_triangulation<D>(points));
  const auto& sites = filtration.triangulation().sites();
  const PowerNeighbours<D> neighbours(filtration, Threads(1));
  std::vector<std::vector<std::uint32_t>> result(points.size());
  for (std::uint32_t vertex = 0; vertex < sites.size(); ++vertex) {
    auto& rows = result[sites.row(vertex).row()];
    for (const VertexId other : neighbours.of(VertexId(vertex))) {
      rows.push_back(sites.row(other.row()).row());
    }
    std::sort(rows.begin(), rows.end());
    EXPECT_TRUE(neighbours.has_inside(VertexId(vertex)) || rows.empty());
  }
  return result;
}

using Rows = std::vector<std::uint32_t>;

TEST(PowerNeighbours, OfASquareAreNotThoseAcrossADiagonal) {
  const auto square = neighbours_by_row<2>({0, 0, 1, 0, 0, 1, 1, 1});
  EXPECT_EQ(square[0], (Rows{1, 2}));
  EXPECT_EQ(square[3], (Rows{1, 2}));
  const auto plane = neighbours_by_row<3>({0, 0, 5, 1, 0, 5, 0, 1, 5, 1, 1, 5});
  EXPECT_EQ(plane, square);
}

TEST(PowerNeighbours, OfACubeAreNotThoseAcrossDiagonals) {
  std::vector<double> coordinates;
  for (unsigned i = 0; i < 8; ++i) {
    coordinates.insert(coordinates.end(), {i % 2 + 0.0, i / 2 % 2 + 0.0, i / 4 + 0.0});
  }
  const auto cube = neighbours_by_row<3>(coordinates);
  for (unsigned i = 0; i < 8; ++i) {
    Rows expected{i ^ 1U, i ^ 2U, i ^ 4U};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(cube[i], expected);
  }
}

TEST(PowerNeighbours, OfPointsOnALineAreThoseBesideThem) {
  EXPECT_EQ(neighbours_by_row<3>({0, 0, 0, 2, 2, 2, 5, 5, 5, 6, 6, 6}),
            (std::vector<Rows>{{1}, {0, 2}, {1, 3}, {2}}));
  EXPECT_EQ(neighbours_by_row<2>({0, 0}), std::vector<Rows>{Rows{}});
  EXPECT_TRUE(neighbours_by_row<2>({}).empty());
}

// Weights that lift all rows but the ends to the segment between these.
TEST(PowerNeighbours, AreFoundBehindFlatCells) {
  EXPECT_EQ(neighbours_by_row<3>({0, 0, 0, 1, 0, 0, 2, 0, 0, 4, 0, 0}, {0, -3, -4, 0}),
            (std::vector<Rows>{{3}, {}, {}, {0}}));
  // The same with others around.
  EXPECT_EQ(neighbours_by_row<2>({0, 0, 1, 0, 2, 0, 4, 0, 2, 5, 2, -5}, {0, -3, -4, 0, 0, 0}),
            (std::vector<Rows>{{3, 4, 5}, {}, {}, {0, 4, 5}, {0, 3}, {0, 3}}));
  EXPECT_EQ(neighbours_by_row<2>({0, 0, 1, 0, 2, 0, 4, 0, 2, 5}, {0, -3, -4, 0, 0}),
            (std::vector<Rows>{{3, 4}, {}, {}, {0, 4}, {0, 3}}));
}

}  // namespace
}  // namespace orthoball
