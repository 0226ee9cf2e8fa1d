// SPDX-License-Identifier: MIT
#include "orthoball/weights/added_sites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

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

TEST_F(AddedSitesTest, BreakARingInWhichNoTwoMeet) {
  const WeightedPoints points = plane({0, 0, 400, 0, 0, 400, 100, 100, 200, 100, 100, 200});
  const AddedSites result = expect_held<2>(
      points,
      {simplex({3, 4, 5}), simplex({0, 3, 4}), simplex({0, 1, 4}), simplex({1, 4, 5}),
       simplex({1, 2, 5}), simplex({2, 3, 5}), simplex({0, 2, 3})},
      1000.0);
  EXPECT_EQ(result.added, 1U);
}

// The added sites and the parts, by position, in the order of neither; nothing where too many
// sites were needed.
struct Cut {
  std::set<std::vector<double>> sites;
  std::set<std::set<std::vector<double>>> parts;
  friend bool operator==(const Cut&, const Cut&) = default;
};

Cut cut(const WeightedPoints& points, const std::vector<SimplexRows>& simplices) {
  const auto position = [](const WeightedPoints& of, std::size_t row) {
    std::vector<double> x;
    for (int axis = 0; axis < of.dimension(); ++axis) x.push_back(of.coordinate(row, axis));
    return x;
  };
  Cut result;
  try {
    const AddedSites found = with_added_sites(points, simplices);
    for (std::size_t row = points.size(); row < found.points.size(); ++row) {
      result.sites.insert(position(found.points, row));
    }
    for (const SimplexRows& rows : found.simplices) {
      std::set<std::vector<double>> part;
      for (const SiteId row : rows) part.insert(position(found.points, row.row()));
      result.parts.insert(part);
    }
  } catch (const LimitError&) {
  }
  return result;
}

TEST_F(AddedSitesTest, DependOnPositionsAlone) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    generators::Random random(seed);
    const int dimension = random.integer(2, 3), count = random.integer(6, 12);
    const int size = random.coin() ? 3 : 1000;
    std::vector<double> x;
    for (int i = 0; i < dimension * count; ++i) x.push_back(random.integer(0, size));
    std::vector<std::vector<int>> edges;
    while (edges.size() < 4) {
      const int a = random.integer(0, count - 1), b = random.integer(0, count - 1);
      const auto at = [&](int row) { return x.begin() + dimension * row; };
      if (!std::equal(at(a), at(a) + dimension, at(b))) edges.push_back({a, b});
    }
    const auto cut_of = [&](const std::vector<int>& row_of) {
      std::vector<double> moved(x.size());
      for (int row = 0; row < count; ++row) {
        std::copy_n(x.begin() + dimension * row, dimension,
                    moved.begin() + dimension * row_of[static_cast<std::size_t>(row)]);
      }
      std::vector<SimplexRows> simplices;
      for (const auto& edge : edges) {
        SimplexRows rows;
        for (const int row : edge) {
          rows.emplace_back(static_cast<std::uint32_t>(row_of[static_cast<std::size_t>(row)]));
        }
        std::sort(rows.begin(), rows.end());
        simplices.push_back(rows);
      }
      return cut(WeightedPoints::fixed_point(dimension, 0, std::move(moved), WeightKind::none, {}),
                 simplices);
    };
    std::vector<int> rows(static_cast<std::size_t>(count));
    std::iota(rows.begin(), rows.end(), 0);
    const Cut as_given = cut_of(rows);
    for (int i = 0; i < 3; ++i) {
      for (std::size_t row = rows.size(); row-- > 1;) {
        std::swap(rows[row], rows[static_cast<std::size_t>(random.integer(0, static_cast<int>(row)))]);
      }
      EXPECT_EQ(cut_of(rows), as_given);
      std::swap(edges.front(), edges.back());
    }
  }
}

}  // namespace
}  // namespace orthoball
