// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/insertion_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "generators/point_families.h"

namespace orthoball {
namespace {

using generators::PointFamily;

std::vector<std::uint32_t> numbers(const std::vector<SiteId>& rows) {
  std::vector<std::uint32_t> result;
  for (const SiteId row : rows) result.push_back(row.row());
  return result;
}

// Sum of the distances along the axes between consecutive sites.
std::vector<double> steps(const WeightedPoints& points, const std::vector<SiteId>& rows) {
  const auto axes = static_cast<std::size_t>(points.dimension());
  std::vector<double> lengths;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    double length = 0.0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      length += std::abs(points.coordinates()[axes * rows[i].row() + axis] -
                         points.coordinates()[axes * rows[i - 1].row() + axis]);
    }
    lengths.push_back(length);
  }
  return lengths;
}

TEST(CurveOrder, GoesFromNeighbourToNeighbourInAFullGrid) {
  for (const std::size_t side : {2U, 4U, 8U, 16U, 32U}) {
    const WeightedPoints flat = points_of(PointFamily::grid, 2, side * side, 1);
    EXPECT_EQ(steps(flat, curve_order<2>(flat).rows), std::vector<double>(side * side - 1, 1.0));
  }
  for (const std::size_t side : {2U, 4U, 8U, 16U}) {
    const WeightedPoints solid = points_of(PointFamily::grid, 3, side * side * side, 1);
    EXPECT_EQ(steps(solid, curve_order<3>(solid).rows),
              std::vector<double>(side * side * side - 1, 1.0));
  }
}

TEST(CurveOrder, StaysNearInRandomPoints) {
  const WeightedPoints points = points_of(PointFamily::uniform, 3, 20000, 1);
  const auto lengths = steps(points, curve_order<3>(points).rows);
  const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.0) / 20000;
  EXPECT_LT(mean, 3 * std::cbrt(1.0 / 20000));
}

template <int D>
void check_rows(const WeightedPoints& points) {
  const CurveOrder curve = curve_order<D>(points);
  std::vector<std::uint32_t> rows = numbers(curve.rows);
  for (const Duplicate& duplicate : curve.duplicates) {
    rows.push_back(duplicate.row.row());
    EXPECT_LT(duplicate.representative, duplicate.row);
    EXPECT_EQ(std::count(curve.rows.begin(), curve.rows.end(), duplicate.representative), 1);
  }
  std::sort(rows.begin(), rows.end());
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(rows, all);
  EXPECT_TRUE(std::is_sorted(curve.duplicates.begin(), curve.duplicates.end(),
                             [](auto& a, auto& b) { return a.row < b.row; }));

  // Shuffled rows: the same sites in the same places.
  const auto order = generators::random_permutation(points.size(), 5);
  const WeightedPoints shuffled = generators::with_rows(points, order);
  const CurveOrder other = curve_order<D>(shuffled);
  ASSERT_EQ(other.rows.size(), curve.rows.size());
  for (std::size_t i = 0; i < curve.rows.size(); ++i) {
    const std::uint32_t before = curve.rows[i].row(), after = order[other.rows[i].row()];
    for (std::size_t axis = 0; axis < D; ++axis) {
      EXPECT_EQ(points.coordinates()[D * before + axis], points.coordinates()[D * after + axis]);
    }
    EXPECT_EQ(points.weight(before), points.weight(after));
  }
}

TEST(CurveOrder, HasEveryRowOnceAndDependsOnTheSitesAlone) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      check_rows<2>(points_of(family, 2, 100, seed));
      check_rows<3>(points_of(family, 3, 100, seed));
    }
  }
}

TEST(CurveOrder, TakesEqualRowsForDuplicatesOfTheLowest) {
  const auto curve = curve_order<2>(
      {2, {1, 0, 0, 0, 1, 0, -0.0, 0.0, 1, -0.0, 1, 0}, WeightKind::weight, {2, 0, 2, -0.0, 3, 2}});
  EXPECT_EQ(curve.rows.size(), 3U);
  EXPECT_EQ(curve.duplicates,
            (std::vector<Duplicate>{
                {SiteId(2), SiteId(0)}, {SiteId(3), SiteId(1)}, {SiteId(5), SiteId(0)}}));
}

TEST(CurveOrder, KeepsRowsApartThatDifferInTheLastBit) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(curve_order<2>({2, {1, 0, next, 0}, WeightKind::none, {}}).duplicates.empty());
  EXPECT_TRUE(curve_order<2>({2, {1, 0, 1, 0}, WeightKind::radius, {1, next}}).duplicates.empty());
  EXPECT_TRUE(curve_order<2>({2, {1, 0, 1, 0}, WeightKind::radius, {1, -1}}).duplicates.empty());
  const auto low = WeightedPoints::fixed_point(2, 0, {1, 0, 1, 0}, WeightKind::weight,
                                               {0x1p+60, 0x1p+60}, {1, 2});
  EXPECT_TRUE(curve_order<2>(low).duplicates.empty());
}

TEST(CurveOrder, PutsSitesOfOneCubeInOrderOfPositionAndWeight) {
  // Far smaller than a cube of the curve: by x, then y, then weight.
  const double tiny = 0x1p-60;
  const auto curve = curve_order<2>(
      {2, {1, 1, tiny, 0, 0, tiny, 0, 0, 0, 0}, WeightKind::weight, {0, 0, 0, 5, 4}});
  const auto rows = numbers(curve.rows);
  const auto first = std::find(rows.begin(), rows.end(), 4U);
  ASSERT_LE(rows.end() - first, 5);
  EXPECT_EQ((std::vector<std::uint32_t>(first, first + 4)),
            (std::vector<std::uint32_t>{4, 3, 2, 1}));
}

TEST(CurveOrder, TakesCoordinatesOfAnySize) {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  check_rows<2>({2, {most, -most, -most, most, 0, 0, least, 1}, WeightKind::none, {}});
  check_rows<3>(
      {3, {least, 0, 0, -least, 0, 0, 0, 0, 0, 3 * least, least, 0}, WeightKind::none, {}});
  check_rows<2>(WeightedPoints(2));
  check_rows<3>({3, {1, 2, 3}, WeightKind::none, {}});
}

TEST(InsertionOrder, HasEverySiteOnceInRoundsAlongTheCurve) {
  for (const std::size_t count : {0U, 1U, 2U, 63U, 64U, 65U, 66U, 1000U, 100000U}) {
    InsertionOrder order = insertion_order(count);
    ASSERT_EQ(order.size(), count);
    std::size_t rounds = count == 0 ? 0 : 1;
    for (std::size_t i = 1; i < count; ++i) {
      if (order[i] < order[i - 1]) ++rounds;
    }
    EXPECT_LE(static_cast<double>(rounds), 2 + std::log(static_cast<double>(count) + 1));
    std::sort(order.begin(), order.end());
    for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(order[i], i);
  }
}

TEST(InsertionOrder, LeavesEveryEighthSiteForEarlierRounds) {
  const InsertionOrder order = insertion_order(100000);
  auto end = order.end();
  for (std::uint32_t stride = 8; stride <= 512; stride *= 8) {
    while (*(end - 1) > *(end - 2)) --end;
    --end;
    std::vector<std::uint32_t> earlier(order.begin(), end);
    std::sort(earlier.begin(), earlier.end());
    EXPECT_LT(earlier.front(), stride);
    EXPECT_GE(earlier.back() + stride, 100000U);
    for (std::size_t i = 1; i < earlier.size(); ++i) {
      ASSERT_EQ(earlier[i] - earlier[i - 1], stride);
    }
  }
}

}  // namespace
}  // namespace orthoball
