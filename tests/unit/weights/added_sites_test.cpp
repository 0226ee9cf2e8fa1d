// SPDX-License-Identifier: MIT
#include "orthoball/weights/added_sites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "matchers/simplex_rows.h"
#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/weights/enforced_weights.h"
#include "orthoball/weights/linear_program.h"

namespace orthoball {
namespace {

using matchers::plane;
using matchers::simplex;
using Numbers = std::vector<std::size_t>;

// Adds sites, and expects that weights hold all parts, exactly.
template <int D>
AddedSites expect_held(const WeightedPoints& points, const std::vector<SimplexRows>& simplices,
                       double alpha2) {
  AddedSites result = with_added_sites(points, simplices);
  EXPECT_EQ(result.points.size(), points.size() + result.added);
  const auto weights =
      enforced_weights(result.points, result.simplices, alpha2, Threads(1), result.added);
  EXPECT_TRUE(weights.conflict.empty());
  const Filtration<D> filtration(regular_triangulation<D>(weights.points));
  const auto present = are_present<D>(filtration, filtration.index(alpha2), result.simplices);
  EXPECT_EQ(std::count(present.begin(), present.end(), false), 0);
  for (const SiteId row : weights.changed) EXPECT_LT(row.row(), points.size());
  return result;
}

class AddedSitesTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_linear_solver()) GTEST_SKIP() << "built without CLP";
  }
};

TEST_F(AddedSitesTest, AreNoneWhereNoneAreNeeded) {
  const WeightedPoints points = plane({0, 0, 40, 0, 40, 30, 0, 30});
  const std::vector<SimplexRows> edges{simplex({0, 2}), simplex({0, 1})};
  const AddedSites result = expect_held<2>(points, edges, 1.0);
  EXPECT_EQ(result.added, 0U);
  EXPECT_EQ(result.simplices, edges);
  EXPECT_EQ(result.part_of, (Numbers{0, 1}));
}

TEST_F(AddedSitesTest, AreOneForTwoEdgesThatCross) {
  const WeightedPoints points = plane({0, 0, 40, 0, 40, 30, 0, 30});
  const AddedSites result = expect_held<2>(points, {simplex({0, 2}), simplex({1, 3})}, 1.0);
  ASSERT_EQ(result.added, 1U);
  EXPECT_EQ(result.points.coordinate(4, 0), 2.0);
  EXPECT_EQ(result.points.coordinate(4, 1), 1.5);
  EXPECT_EQ(result.simplices, (std::vector<SimplexRows>{simplex({2, 4}), simplex({0, 4}),
                                                        simplex({1, 4}), simplex({3, 4})}));
  EXPECT_EQ(result.part_of, (Numbers{0, 0, 1, 1}));
}

TEST_F(AddedSitesTest, AreNoneWhereACornerLiesOnAnotherSimplex) {
  const WeightedPoints points = plane({0, 0, 40, 0, 20, 0, 20, 30});
  const AddedSites result = expect_held<2>(points, {simplex({0, 1}), simplex({2, 3})}, 1.0);
  EXPECT_EQ(result.added, 0U);
  EXPECT_EQ(result.part_of, (Numbers{0, 0, 1}));
}

TEST_F(AddedSitesTest, CutAllThatShareTheEdge) {
  // Two triangles on both sides of an edge that another edge crosses.
  const WeightedPoints points = plane({0, 0, 40, 0, 20, 30, 20, -30, 23, 90, 17, -91});
  const AddedSites result =
      expect_held<2>(points, {simplex({0, 1, 2}), simplex({0, 1, 3}), simplex({4, 5})}, 100.0);
  EXPECT_GE(result.added, 2U);
  EXPECT_LE(result.added, 4U);
}

TEST_F(AddedSitesTest, StandWhereEdgesOfTrianglesThatOverlapMeet) {
  // A star of two triangles: six crossings, and in the middle the same triangles for both.
  const WeightedPoints points = plane({0, 0, 60, 0, 30, 51, 0, 34, 60, 34, 30, -17});
  const AddedSites result = expect_held<2>(points, {simplex({0, 1, 2}), simplex({3, 4, 5})}, 9.0);
  EXPECT_EQ(result.added, 6U);
  EXPECT_EQ(std::count(result.part_of.begin(), result.part_of.end(), 0U), 7);
  EXPECT_EQ(std::count(result.part_of.begin(), result.part_of.end(), 1U), 7);
}

TEST_F(AddedSitesTest, AreOneWhereAnEdgePassesThroughATriangle) {
  const WeightedPoints points(3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1.5, 1}, WeightKind::none,
                              {});
  const AddedSites result = expect_held<3>(points, {simplex({0, 1, 2}), simplex({3, 4})}, 1.0);
  EXPECT_EQ(result.added, 1U);
  EXPECT_EQ(result.part_of, (Numbers{0, 0, 0, 1, 1}));
}

TEST_F(AddedSitesTest, CutTwoTrianglesThatCrossInSpace) {
  const WeightedPoints points(3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1.5, 1, 5, 5, 0.5},
                              WeightKind::none, {});
  const AddedSites result = expect_held<3>(points, {simplex({0, 1, 2}), simplex({3, 4, 5})}, 4.0);
  EXPECT_EQ(result.added, 2U);
}

// Edges that meet within a millionth of an edge of the site where one of them ends.
TEST_F(AddedSitesTest, CutNextToASite) {
  const WeightedPoints points =
      WeightedPoints::fixed_point(3, 3, {333, 911, 577, 337, 413, 861, 333, 650, 556, 428, 908,
                                         560, 970, 856, 363, 276, 473, 581, 902, 182, 946},
                                  WeightKind::none, {});
  const AddedSites result =
      expect_held<3>(points, {simplex({0, 1, 2}), simplex({1, 3, 4}), simplex({3, 5, 6})}, 1.0);
  EXPECT_EQ(result.added, 3U);
}

// Triangles of a lattice whose parts cross each other again and again, unless the longest edges are
// cut first.
TEST_F(AddedSitesTest, CutTheLongestEdgesFirst) {
  const WeightedPoints points(
      3, {4, 2, 4, 3, 3, 1, 0, 4, 0, 0, 1, 1, 1, 4, 0, 1, 4, 1, 0, 3, 3, 2, 3, 1}, WeightKind::none,
      {});
  const AddedSites result =
      expect_held<3>(points, {simplex({0, 1, 2}), simplex({0, 3, 4}), simplex({5, 6, 7})}, 1.0);
  EXPECT_LE(result.added, 12U);
}

TEST_F(AddedSitesTest, BreakARingInWhichNoTwoMeet) {
  const WeightedPoints points = plane({0, 0, 400, 0, 0, 400, 100, 100, 200, 100, 100, 200});
  const AddedSites result = expect_held<2>(
      points,
      {simplex({3, 4, 5}), simplex({0, 3, 4}), simplex({0, 1, 4}), simplex({1, 4, 5}),
       simplex({1, 2, 5}), simplex({2, 3, 5}), simplex({0, 2, 3})},
      1000.0);
  EXPECT_EQ(result.added, 1U);
}

// Sites with their weights, and the parts, by position; nothing where too many sites were needed.
struct Cut {
  std::set<std::vector<double>> sites;
  std::set<std::set<std::vector<double>>> parts;
  friend bool operator==(const Cut&, const Cut&) = default;
};

std::vector<double> position(const WeightedPoints& points, std::size_t row) {
  std::vector<double> x;
  for (int axis = 0; axis < points.dimension(); ++axis) x.push_back(points.coordinate(row, axis));
  return x;
}

Cut cut(const WeightedPoints& points, const std::vector<SimplexRows>& simplices) {
  Cut result;
  try {
    const AddedSites found = with_added_sites(points, simplices);
    const WeightedPoints held =
        enforced_weights(found.points, found.simplices, 1.0, Threads(1), found.added).points;
    for (std::size_t row = 0; row < held.size(); ++row) {
      std::vector<double> site = position(held, row);
      site.push_back(held.weight(row));
      result.sites.insert(site);
    }
    for (const SimplexRows& rows : found.simplices) {
      std::set<std::vector<double>> part;
      for (const SiteId row : rows) part.insert(position(held, row.row()));
      result.parts.insert(part);
    }
  } catch (const LimitError&) {
  }
  return result;
}

// Points on a small or a fine lattice, and edges between them, which often cross.
struct Crossing {
  int dimension;
  std::vector<std::vector<double>> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

Crossing random_crossing(std::uint64_t seed) {
  generators::Random random(seed);
  Crossing result{random.integer(2, 3), {}, {}};
  const int count = random.integer(6, 12), size = random.coin() ? 3 : 1000;
  for (int row = 0; row < count; ++row) {
    std::vector<double> x;
    for (int axis = 0; axis < result.dimension; ++axis) x.push_back(random.integer(0, size));
    result.points.push_back(x);
  }
  while (result.edges.size() < 4) {
    const auto a = static_cast<std::uint32_t>(random.integer(0, count - 1));
    const auto b = static_cast<std::uint32_t>(random.integer(0, count - 1));
    if (result.points[a] != result.points[b]) result.edges.push_back({a, b});
  }
  return result;
}

// Row i of the input is point `order[i]`.
Cut cut(const Crossing& of, const std::vector<std::uint32_t>& order) {
  std::vector<double> x;
  for (const std::uint32_t point : order) {
    x.insert(x.end(), of.points[point].begin(), of.points[point].end());
  }
  const auto row_of = [&](std::uint32_t point) {
    return static_cast<std::uint32_t>(std::find(order.begin(), order.end(), point) - order.begin());
  };
  std::vector<SimplexRows> simplices;
  for (const auto& [a, b] : of.edges) {
    const auto [low, high] = std::minmax({row_of(a), row_of(b)});
    simplices.push_back(simplex({low, high}));
  }
  std::sort(simplices.begin(), simplices.end());  // another order of these, too
  return cut(WeightedPoints::fixed_point(of.dimension, 0, std::move(x), WeightKind::none, {}),
             simplices);
}

TEST_F(AddedSitesTest, DependOnPositionsAlone) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Crossing crossing = random_crossing(seed);
    const std::size_t count = crossing.points.size();
    const Cut expected = cut(crossing, generators::random_permutation(count, 1));
    EXPECT_EQ(cut(crossing, generators::random_permutation(count, 2)), expected);
    EXPECT_EQ(cut(crossing, generators::random_permutation(count, 3)), expected);
  }
}

}  // namespace
}  // namespace orthoball
