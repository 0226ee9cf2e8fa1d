// SPDX-License-Identifier: MIT
#include "orthoball/weights/enforced_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "matchers/simplex_rows.h"
#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/weights/linear_program.h"

namespace orthoball {
namespace {

using matchers::plane;
using matchers::simplex;
using Numbers = std::vector<std::size_t>;

template <int D>
std::vector<bool> present(const WeightedPoints& points, double alpha2,
                          const std::vector<SimplexRows>& simplices) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  return are_present<D>(filtration, filtration.index(alpha2), simplices);
}

class EnforcedWeightsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_linear_solver()) GTEST_SKIP() << "built without CLP";
  }
};

TEST(SimplexPresence, TellsFacesOfLargerOnesDuplicatesAndHiddenRows) {
  // A right triangle, its first corner twice, and one that its corner hides.
  const WeightedPoints points(2, {0, 0, 2, 0, 0, 2, 0, 0, 0.5, 0}, WeightKind::weight,
                              {1, 1, 1, 1, -9});
  const std::vector<SimplexRows> simplices{simplex({0, 1}), simplex({1, 2}), simplex({0, 1, 2}),
                                           simplex({1, 2, 3}), simplex({0, 4})};
  EXPECT_EQ(present<2>(points, -0.5, simplices),
            (std::vector<bool>{false, false, false, false, false}));
  EXPECT_EQ(present<2>(points, 0.0, simplices),
            (std::vector<bool>{true, false, false, false, false}));
  // The longest edge comes with the triangle.
  EXPECT_EQ(present<2>(points, 1.0, simplices), (std::vector<bool>{true, true, true, true, false}));
}

TEST_F(EnforcedWeightsTest, LetAnAddedSiteHaveAnyWeightAtNoCost) {
  // Half of a diagonal, from a corner to the added middle, passes between two sites: either the
  // middle becomes heavy, or they give.
  const WeightedPoints points = plane({0, 0, 400, 0, 400, 300, 0, 300, 20, 19, 20, 11, 200, 150});
  const std::vector<SimplexRows> halves{simplex({0, 6}), simplex({2, 6})};
  EXPECT_NE(present<2>(points, 1e5, halves), (std::vector<bool>{true, true}));
  const EnforcedWeights free = enforced_weights(points, halves, 1e5, Threads(1), 1);
  EXPECT_EQ(present<2>(free.points, 1e5, halves), (std::vector<bool>{true, true}));
  EXPECT_EQ(free.total_change, 0.0);
  EXPECT_TRUE(free.changed.empty());
  EXPECT_GT(enforced_weights(points, halves, 1e5, Threads(1), 0).total_change, 0.0);
}

TEST_F(EnforcedWeightsTest, ChangeTheLeastInTotal) {
  // The edge from (-1, 0) to (1, 0) beside (0, 0.1), at alpha2 = 1. To lower the third by d and
  // raise one end by s moves the witness; the least total is less than 0.99, that of the middle.
  const WeightedPoints points = plane({-10, 0, 10, 0, 0, 1});
  const std::vector<SimplexRows> edge{simplex({0, 1})};
  EXPECT_EQ(present<2>(points, 1.0, edge), (std::vector<bool>{false}));
  const EnforcedWeights result = enforced_weights(points, edge, 1.0);
  EXPECT_EQ(present<2>(result.points, 1.0, edge), (std::vector<bool>{true}));
  EXPECT_LT(result.total_change, 0.99);
  EXPECT_GT(result.total_change, 0.9);
  EXPECT_EQ(result.changed.empty(), false);
}

TEST_F(EnforcedWeightsTest, ChangeNothingWhereAllIsThere) {
  // With room below alpha2 the witness can be far from the third.
  const WeightedPoints points = plane({-10, 0, 10, 0, 0, 1});
  const std::vector<SimplexRows> edge{simplex({0, 1})};
  const EnforcedWeights result = enforced_weights(points, edge, 100.0);
  EXPECT_TRUE(result.changed.empty());
  EXPECT_EQ(result.total_change, 0.0);
  EXPECT_EQ(result.points.weight_kind(), WeightKind::none);
}

TEST_F(EnforcedWeightsTest, LeaveTheWeightOfWhatNeedNotMove) {
  // Both ends by 1 in square put the witness so far below that the fifth need not move.
  const WeightedPoints points = plane({0, 0, 40, 0, 40, 30, 0, 30, 20, 10});
  const std::vector<SimplexRows> edge{simplex({0, 1})};
  const EnforcedWeights result = enforced_weights(points, edge, 4.0);
  EXPECT_EQ(result.changed, simplex({0, 1}));
  EXPECT_NEAR(result.total_change, 2.0, 2e-4);
}

TEST_F(EnforcedWeightsTest, FlipAnEdgeAndLeaveWhatIsFar) {
  // A rhombus whose short diagonal is there, far from a second one.
  const WeightedPoints points =
      plane({0, 0, 10, 6, 20, 0, 10, -6, 500, 0, 510, 6, 520, 0, 510, -6});
  const std::vector<SimplexRows> diagonals{simplex({0, 2})};
  const EnforcedWeights result = enforced_weights(points, diagonals, 4.0);
  EXPECT_EQ(present<2>(result.points, 4.0, diagonals), (std::vector<bool>{true}));
  ASSERT_FALSE(result.changed.empty());
  EXPECT_LT(result.changed.back().row(), 4U);
  for (std::size_t row = 4; row < 8; ++row) EXPECT_EQ(result.points.weights()[row], 0.0);
}

TEST_F(EnforcedWeightsTest, DependOnTheSetsOfSitesAndSimplicesAlone) {
  const WeightedPoints points = plane({0, 0, 10, 6, 20, 0, 10, -6, 31, 4});
  const WeightedPoints other = plane({31, 4, 10, -6, 20, 0, 10, 6, 0, 0});
  const std::vector<SimplexRows> one{simplex({0, 2}), simplex({0, 4})};
  const std::vector<SimplexRows> two{simplex({0, 4}), simplex({2, 4})};
  const EnforcedWeights first = enforced_weights(points, one, 5.0);
  const EnforcedWeights second = enforced_weights(other, two, 5.0);
  for (std::size_t row = 0; row < 5; ++row) {
    EXPECT_EQ(first.points.weights()[row], second.points.weights()[4 - row]);
  }
}

TEST_F(EnforcedWeightsTest, HideAPointInsideATriangle) {
  const WeightedPoints points = plane({0, 0, 40, 0, 0, 40, 10, 10});
  const std::vector<SimplexRows> triangle{simplex({0, 1, 2})};
  const EnforcedWeights result = enforced_weights(points, triangle, 10.0);
  EXPECT_EQ(present<2>(result.points, 10.0, triangle), (std::vector<bool>{true}));
  EXPECT_EQ(result.hidden, simplex({3}));
}

TEST_F(EnforcedWeightsTest, NameEdgesThatCross) {
  const WeightedPoints points = plane({0, 0, 40, 0, 40, 30, 0, 30, 20, 90, 100, 90});
  const std::vector<SimplexRows> simplices{simplex({4, 5}), simplex({0, 2}), simplex({0, 1}),
                                           simplex({1, 3})};
  const EnforcedWeights result = enforced_weights(points, simplices, 100.0);
  EXPECT_EQ(result.conflict, (Numbers{1, 3}));
  EXPECT_TRUE(result.changed.empty());
}

TEST_F(EnforcedWeightsTest, NameAnEdgeThroughATriangle) {
  const WeightedPoints points(3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 1, 9, 8, -9},
                              WeightKind::none, {});
  const std::vector<SimplexRows> simplices{simplex({0, 5}), simplex({0, 1, 2}), simplex({3, 4})};
  EXPECT_EQ(enforced_weights(points, simplices, 9.0).conflict, (Numbers{1, 2}));
}

TEST_F(EnforcedWeightsTest, NameACornerOnAnEdge) {
  const WeightedPoints points = plane({0, 0, 40, 0, 20, 0, 20, 30});
  const std::vector<SimplexRows> simplices{simplex({0, 1}), simplex({2, 3})};
  EXPECT_EQ(enforced_weights(points, simplices, 100.0).conflict, (Numbers{0, 1}));
}

// An edge, and one from beside its middle, `off` units away, upwards: of a thousand million.
EnforcedWeights with_a_corner_beside_an_edge(double off) {
  const WeightedPoints points =
      WeightedPoints::fixed_point(2, 9, {0, 0, 1e9, 0, 5e8, off, 5e8, 6e8}, WeightKind::none, {});
  const std::vector<SimplexRows> simplices{simplex({0, 1}), simplex({2, 3})};
  EnforcedWeights result = enforced_weights(points, simplices, 1.0);
  if (result.conflict.empty()) {
    EXPECT_EQ(present<2>(result.points, 1.0, simplices), (std::vector<bool>{true, true}));
  }
  return result;
}

TEST_F(EnforcedWeightsTest, TellACornerOnAnEdgeFromOneBesideIt) {
  EXPECT_EQ(with_a_corner_beside_an_edge(0).conflict, (Numbers{0, 1}));
  EXPECT_EQ(with_a_corner_beside_an_edge(-1).conflict, (Numbers{0, 1}));
  EXPECT_EQ(with_a_corner_beside_an_edge(1).conflict, Numbers());
  EXPECT_EQ(with_a_corner_beside_an_edge(1000).conflict, Numbers());
}

// Triangles that meet at a rounded point of their planes: weights hold them, but a margin of a
// millionth of their size needs weights of 10^5 times that, one of a thousand millionth of 1 time.
TEST_F(EnforcedWeightsTest, HoldWhatHasHardlyAnyRoom) {
  const WeightedPoints points(
      3, {6, 8, 8, 6, 0, 8, 4, 6, 8, 8, 4, 2, 0,          0,          0,
          6, 4, 0, 0, 0, 6, 6, 3, 3, 6, 5, 5, 4.23529412, 5.64705882, 7.41176471},
      WeightKind::none, {});
  const std::vector<SimplexRows> simplices{
      simplex({0, 5, 8}), simplex({5, 7, 8}), simplex({0, 1, 8}), simplex({1, 7, 8}),
      simplex({1, 5, 7}), simplex({3, 7, 8}), simplex({7, 8, 9}), simplex({2, 8, 9}),
      simplex({6, 7, 9}), simplex({2, 6, 9}), simplex({4, 6}),    simplex({0, 1, 9}),
      simplex({1, 6, 9})};
  const EnforcedWeights result = enforced_weights(points, simplices, 1.0);
  ASSERT_EQ(result.conflict, Numbers());
  const auto are_there = present<3>(result.points, 1.0, simplices);
  EXPECT_EQ(std::count(are_there.begin(), are_there.end(), false), 0);
  EXPECT_LT(result.total_change, 1e4);
}

TEST_F(EnforcedWeightsTest, NameARingInWhichEachStandsBeforeTheNext) {
  // A triangle within a triangle of the same centre, and the three diagonals that turn one way: no
  // two cross, and no weights hold all. (The smallest triangulation that is not regular.)
  const WeightedPoints points = plane({0, 0, 400, 0, 0, 400, 100, 100, 200, 100, 100, 200});
  std::vector<SimplexRows> simplices{simplex({3, 4, 5}), simplex({0, 3, 4}), simplex({0, 1, 4}),
                                     simplex({1, 4, 5}), simplex({1, 2, 5}), simplex({2, 3, 5}),
                                     simplex({0, 2, 3})};
  const Numbers conflict = enforced_weights(points, simplices, 1e6).conflict;
  ASSERT_GE(conflict.size(), 3U);
  for (const std::size_t left_out : conflict) {
    std::vector<SimplexRows> others;
    for (const std::size_t i : conflict) {
      if (i != left_out) others.push_back(simplices[i]);
    }
    EXPECT_TRUE(enforced_weights(points, others, 1e6).conflict.empty()) << left_out;
  }
}

TEST_F(EnforcedWeightsTest, RefuseWhatIsNoSimplex) {
  const WeightedPoints points = plane({0, 0, 10, 0, 20, 0, 20, 30, 0, 0});
  const auto refusal = [&](const SimplexRows& rows) -> std::string {
    const std::vector<SimplexRows> simplices{simplex({0, 1}), rows};
    try {
      (void)enforced_weights(points, simplices, 1.0);
    } catch (const InputError& error) {
      EXPECT_EQ(error.row(), 1U);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(simplex({0, 1, 2})),
            "simplex 1: its corners lie on one line; they must span it");
  EXPECT_EQ(refusal(simplex({0, 4})),
            "simplex 1: its corners lie at one position; they must span it");
  EXPECT_EQ(refusal(simplex({0})), "simplex 1: 1 rows; there must be 2 to 3");
  EXPECT_EQ(refusal(simplex({0, 7})), "simplex 1: row 7 of 5; rows are counted from 0");
}

}  // namespace
}  // namespace orthoball
