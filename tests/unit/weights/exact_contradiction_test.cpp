// SPDX-License-Identifier: MIT
#include "orthoball/weights/exact_contradiction.h"

#include <gtest/gtest.h>

#include <vector>

namespace orthoball {
namespace {

using Numbers = std::vector<std::size_t>;

// The corners of a square and one beside its middle, by position: sites 0 to 4.
DistinctSites<2> square(double off) {
  return DistinctSites<2>(
      WeightedPoints(2, {0, 0, 0, 2, 1, 1 + off, 2, 0, 2, 2}, WeightKind::none, {}));
}

const std::vector<SiteTuple> kDiagonals{{0, 4}, {1, 3}};
const std::vector<WitnessCondition> kCrossing{{0, 0, -1}, {0, 4, -1}, {0, 1, 1}, {0, 3, 1},
                                              {1, 1, -1}, {1, 3, -1}, {1, 0, 1}, {1, 4, 1}};

TEST(ExactContradiction, ProvesThatDiagonalsExcludeEachOther) {
  EXPECT_EQ(exact_contradiction<2>(square(0), kDiagonals, kCrossing), (Numbers{0, 1}));
}

TEST(ExactContradiction, FindsFactorsNearToThoseThatWereTold) {
  std::vector<WitnessCondition> rounded = kCrossing;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    rounded[i].factor *= 1.0 + 1e-10 * static_cast<double>(i);
  }
  rounded.push_back({1, 2, 1e-14});  // a condition of no part in it
  EXPECT_EQ(exact_contradiction<2>(square(0), kDiagonals, rounded), (Numbers{0, 1}));
}

TEST(ExactContradiction, ProvesNothingWhereThereIsNone) {
  // Sides of the square do not exclude each other: factors that make a sum of 0 are negative for
  // some of the others, whatever is told.
  const std::vector<SiteTuple> sides{{0, 1}, {3, 4}};
  std::vector<WitnessCondition> told = kCrossing;
  for (WitnessCondition& one : told) one.factor = 1.0;
  EXPECT_EQ(exact_contradiction<2>(square(0), sides, told), Numbers());
  // Without one of the conditions there is no sum.
  const std::vector<WitnessCondition> fewer(kCrossing.begin(), kCrossing.end() - 1);
  EXPECT_EQ(exact_contradiction<2>(square(0), kDiagonals, fewer), Numbers());
  EXPECT_EQ(exact_contradiction<2>(square(0), kDiagonals, {}), Numbers());
}

TEST(ExactContradiction, TellsACornerOnAnEdgeFromOneBesideIt) {
  // A diagonal, and the edge from its middle to a corner: twice the middle is the sum of the ends.
  const std::vector<SiteTuple> edges{{0, 4}, {1, 2}};
  const std::vector<WitnessCondition> on{{0, 0, -1}, {0, 4, -1}, {0, 2, 2},
                                         {1, 2, -2}, {1, 0, 1},  {1, 4, 1}};
  EXPECT_EQ(exact_contradiction<2>(square(0), edges, on), (Numbers{0, 1}));
  EXPECT_EQ(exact_contradiction<2>(square(0x1p-52), edges, on), Numbers());
}

}  // namespace
}  // namespace orthoball
