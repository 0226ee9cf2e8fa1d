// SPDX-License-Identifier: MIT
#include "orthoball/weights/simplex_crossings.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>
#include <vector>

namespace orthoball {
namespace {

SimplexRows rows(std::initializer_list<std::uint32_t> numbers) {
  SimplexRows result;
  for (const std::uint32_t number : numbers) result.emplace_back(number);
  return result;
}

WeightedPoints points_of(int dimension, std::vector<double> coordinates) {
  return {dimension, std::move(coordinates), WeightKind::none, {}};
}

// Two crossing diagonals 0-2 and 1-3 of a square, 4 in the middle of the side 0-1, 5 far away.
const WeightedPoints kPlane = points_of(2, {0, 0, 4, 0, 4, 4, 0, 4, 2, 0, 9, 9});

TEST(SimplexCrossings, OfEdgesThatMeetInAFaceOfBothThereAreNone) {
  const SimplexCrossings<2> places(kPlane, 1e-7);
  EXPECT_TRUE(places.meeting({rows({0, 2}), rows({2, 1}), rows({3, 0}), rows({2, 5})}).empty());
  EXPECT_TRUE(places.meeting({rows({0, 1, 2}), rows({0, 2}), rows({0, 2, 3})}).empty());
}

TEST(SimplexCrossings, OfEdgesThatCrossAreToldWithTheirPoint) {
  const SimplexCrossings<2> places(kPlane, 1e-7);
  const auto two = places.meeting({rows({0, 3}), rows({0, 2}), rows({1, 3})});
  EXPECT_EQ(two, (std::vector<SimplexRows>{rows({0, 2}), rows({1, 3})}));
  EXPECT_FALSE(places.corner_on_another(two));
  EXPECT_EQ(places.edge_through_another(two), (Place<2>{2.0, 2.0}));
}

TEST(SimplexCrossings, OfACornerOnAnEdgeAreTold) {
  const SimplexCrossings<2> places(kPlane, 1e-7);
  const auto two = places.meeting({rows({0, 1}), rows({4, 5}), rows({2, 3})});
  EXPECT_EQ(two.size(), 2U);
  EXPECT_EQ(places.corner_on_another(two), SiteId(4));
  EXPECT_EQ(places.face_around(rows({0, 1, 2}), places.at(SiteId(4))), rows({0, 1}));
}

TEST(SimplexCrossings, OfTheLongestEdgesComeFirst) {
  const WeightedPoints points =
      points_of(2, {0, 0, 9, 0, 4, -1, 4, 1, -22, 0, -20, 0, -21, -1, -21, 1});
  const SimplexCrossings<2> places(points, 1e-7);
  const std::vector<SimplexRows> all{rows({4, 5}), rows({6, 7}), rows({2, 3}), rows({0, 1})};
  EXPECT_EQ(places.meeting(all), (std::vector<SimplexRows>{rows({0, 1}), rows({2, 3})}));
}

TEST(SimplexCrossings, OfAnEdgeThroughATriangleOfSpaceAreTold) {
  const WeightedPoints points =
      points_of(3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 3, 5, 5, 3});
  const SimplexCrossings<3> places(points, 1e-7);
  const auto two = places.meeting({rows({0, 1, 2}), rows({3, 4})});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(places.edge_through_another(two), (Place<3>{1.0, 1.0, 0.0}));
  EXPECT_TRUE(places.meeting({rows({0, 1, 2}), rows({4, 5})}).empty());
}

}  // namespace
}  // namespace orthoball
