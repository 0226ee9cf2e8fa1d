// SPDX-License-Identifier: MIT
// Small filtrations that other programs' documentation prints, value by value.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// alpha2 of every simplex, by its rows.
template <int D>
std::map<std::vector<std::uint32_t>, double> values_of(const Filtration<D>& filtration) {
  std::map<std::vector<std::uint32_t>, double> values;
  for (std::uint32_t i = 0; i < filtration.size(); ++i) {
    const SimplexId simplex(i);
    std::vector<std::uint32_t> rows;
    for (const SiteId row : filtration.rows(simplex)) rows.push_back(row.row());
    values[rows] = filtration.alpha2(filtration.enters(simplex));
  }
  return values;
}

TEST(PublishedFiltration, OfSevenPointsInGudhisManual) {
  const Filtration<2> filtration(regular_triangulation<2>(
      WeightedPoints(2, {1, 1, 7, 0, 4, 6, 9, 6, 0, 14, 2, 19, 9, 17}, WeightKind::none, {})));
  const std::vector<std::pair<std::vector<std::uint32_t>, double>> expected{{{0}, 0},
                                                                            {{1}, 0},
                                                                            {{2}, 0},
                                                                            {{3}, 0},
                                                                            {{4}, 0},
                                                                            {{5}, 0},
                                                                            {{6}, 0},
                                                                            {{2, 3}, 6.25},
                                                                            {{4, 5}, 7.25},
                                                                            {{0, 2}, 8.5},
                                                                            {{0, 1}, 9.25},
                                                                            {{1, 3}, 10},
                                                                            {{1, 2}, 11.25},
                                                                            {{1, 2, 3}, 12.5},
                                                                            {{0, 1, 2}, 12.9959},
                                                                            {{5, 6}, 13.25},
                                                                            {{2, 4}, 20},
                                                                            {{4, 6}, 22.7367},
                                                                            {{4, 5, 6}, 22.7367},
                                                                            {{3, 6}, 30.25},
                                                                            {{2, 6}, 36.5},
                                                                            {{2, 3, 6}, 36.5},
                                                                            {{2, 4, 6}, 37.2449},
                                                                            {{0, 4}, 59.7107},
                                                                            {{0, 2, 4}, 59.7107}};
  const auto values = values_of(filtration);
  ASSERT_EQ(values.size(), expected.size());
  for (const auto& [rows, value] : expected) {
    ASSERT_TRUE(values.contains(rows));
    EXPECT_NEAR(values.at(rows), value, 5e-5);
  }
  std::vector<std::vector<std::uint32_t>> attached;
  for (const SimplexId simplex : Filter<2>(filtration).by_rows()) {
    if (!filtration.is_attached(simplex)) continue;
    auto& rows = attached.emplace_back();
    for (const SiteId row : filtration.rows(simplex)) rows.push_back(row.row());
  }
  // Edge 26 is the hypotenuse of a right triangle: a tie, which is unattached.
  EXPECT_EQ(attached, (std::vector<std::vector<std::uint32_t>>{{4, 6}, {0, 4}}));
}

TEST(PublishedFiltration, OfFiveWeightedPointsInCgalsAndGudhisManuals) {
  const auto values = values_of(Filtration<3>(regular_triangulation<3>(
      WeightedPoints(3, {1, -1, -1, -1, 1, -1, -1, -1, 1, 1, 1, 1, 2, 2, 2}, WeightKind::weight,
                     {4, 4, 4, 4, 1}))));
  ASSERT_EQ(values.size(), 29U);
  for (const auto& [rows, value] : values) {
    const bool has_4 = rows.back() == 4,
               has_3 = rows.front() == 3 || (rows.size() > 1 && rows[rows.size() - 2] == 3);
    const double among_first[] = {-4, -2, -4.0 / 3.0, -1};
    const double at_corner_3[] = {-1, -1, 23, 95};  // one side of the fourth ball
    const double elsewhere[] = {-1, 23, 95, 95};
    const std::size_t k = rows.size() - 1;
    EXPECT_EQ(value, !has_4 ? among_first[k] : has_3 ? at_corner_3[k] : elsewhere[k]);
  }
}

TEST(PublishedFiltration, OfASmallBallInsideALargeOneOnALine) {
  // In the plane, for the library has no sets on a line of their own. The small ball's power cell
  // is not empty, but far away.
  const auto values = values_of(Filtration<2>(regular_triangulation<2>(
      WeightedPoints(2, {0, 0, 0.1, 0}, WeightKind::weight, {100, 0.01}))));
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values.at({0}), -100);
  EXPECT_GT(values.at({1}), 1e5);
  EXPECT_EQ(values.at({1}), values.at({0, 1}));
}

}  // namespace
}  // namespace orthoball
