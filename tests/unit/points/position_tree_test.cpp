// SPDX-License-Identifier: MIT
#include "orthoball/points/position_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "generators/cases.h"
#include "generators/point_families.h"

namespace orthoball {
namespace {

template <int D>
using Position = std::array<double, std::size_t{D}>;

template <int D>
Position<D> position_of(const WeightedPoints& points, std::size_t row) {
  Position<D> x;
  for (std::size_t axis = 0; axis < D; ++axis) x[axis] = points.coordinates()[D * row + axis] + 0.0;
  return x;
}

// All squared distances from a position to the other ones, ascending.
template <int D>
std::vector<double> all_squares(const std::set<Position<D>>& positions, const Position<D>& from) {
  std::vector<double> squares;
  for (const Position<D>& x : positions) {
    if (x == from) continue;
    double square = 0.0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      square += (x[axis] - from[axis]) * (x[axis] - from[axis]);
    }
    squares.push_back(square);
  }
  std::sort(squares.begin(), squares.end());
  return squares;
}

template <int D>
void expect_nearest_of_all(const WeightedPoints& points) {
  const PositionTree<D> tree(points, Threads(3));
  std::set<Position<D>> positions;
  for (std::size_t row = 0; row < points.size(); ++row) {
    positions.insert(position_of<D>(points, row));
  }
  ASSERT_EQ(tree.size(), positions.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    const auto expected = all_squares<D>(positions, position_of<D>(points, row));
    for (const std::size_t count : {std::size_t{1}, std::size_t{4}, expected.size()}) {
      if (count > expected.size()) continue;
      std::vector<double> found(count);
      tree.nearest_squares(tree.position_of_row()[row], found);
      ASSERT_TRUE(std::equal(found.begin(), found.end(), expected.begin())) << "row " << row;
    }
  }
}

TEST(PositionTree, FindsTheNearestOfEveryFamilyAsABruteSearchDoes) {
  for (const auto& one : generators::cases(2, 2, 120)) {
    SCOPED_TRACE(testing::Message() << one);
    const WeightedPoints points = one.points();
    one.dimension == 2 ? expect_nearest_of_all<2>(points) : expect_nearest_of_all<3>(points);
  }
}

TEST(PositionTree, TakesRowsAtOnePositionAsOne) {
  const WeightedPoints points(2, {0.0, 1.0, 5.0, 5.0, -0.0, 1.0, 5.0, 5.0}, WeightKind::none, {});
  const PositionTree<2> tree(points);
  EXPECT_EQ(tree.size(), 2U);
  EXPECT_EQ(tree.position_of_row()[0], tree.position_of_row()[2]);
  EXPECT_NE(tree.position_of_row()[0], tree.position_of_row()[1]);
  std::vector<double> squares(1);
  tree.nearest_squares(tree.position_of_row()[0], squares);
  EXPECT_EQ(squares[0], 41.0);
}

TEST(PositionTree, IsTheSameOnAnyNumberOfThreads) {
  const WeightedPoints points =
      generators::points_of(generators::PointFamily::uniform, 3, 60000, 5);
  const PositionTree<3> one(points, Threads(1)), several(points, Threads(4));
  ASSERT_EQ(one.size(), several.size());
  std::vector<double> of_one(9), of_several(9);
  for (std::size_t row = 0; row < points.size(); row += 7) {
    one.nearest_squares(one.position_of_row()[row], of_one);
    several.nearest_squares(several.position_of_row()[row], of_several);
    ASSERT_EQ(of_one, of_several);
  }
}

TEST(PositionTree, HoldsNoPositionsOfNoPoints) {
  EXPECT_EQ(PositionTree<3>(WeightedPoints(3)).size(), 0U);
}

}  // namespace
}  // namespace orthoball
