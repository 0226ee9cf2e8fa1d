// SPDX-License-Identifier: MIT
#include "orthoball/queries/containment.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

WeightedPoints plain(int dimension, std::vector<double> coordinates) {
  return {dimension, std::move(coordinates), WeightKind::none, {}};
}

// The rows of the simplex at each point; empty where there is none.
template <int D>
std::vector<std::vector<std::uint32_t>> rows_at(const WeightedPoints& sites,
                                                const WeightedPoints& points) {
  const auto filtration = filtration_of<D>(sites);
  std::vector<std::vector<std::uint32_t>> result;
  for (const SimplexId simplex : simplices_at(filtration, points)) {
    result.emplace_back();
    if (!simplex.exists()) continue;
    for (const SiteId row : filtration.rows(simplex)) result.back().push_back(row.row());
  }
  return result;
}

using Rows = std::vector<std::vector<std::uint32_t>>;

TEST(SimplicesAt, ATriangleHasAnInsideEdgesAndCorners) {
  const WeightedPoints triangle = plain(2, {0, 0, 4, 0, 0, 4});
  EXPECT_EQ(rows_at<2>(triangle, plain(2, {1, 1, 2, 2, 0, 1, 4, 0, 3, 2, -1, 0, 5, 0})),
            (Rows{{0, 1, 2}, {1, 2}, {0, 2}, {1}, {}, {}, {}}));
}

TEST(SimplicesAt, ATetrahedronHasFacesOfAllDimensions) {
  const WeightedPoints tetrahedron = plain(3, {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4});
  EXPECT_EQ(
      rows_at<3>(tetrahedron, plain(3, {1, 1, 1, 1, 1, 2, 0, 1, 1, 0, 0, 3, 0, 0, 4, 2, 2, 1})),
      (Rows{{0, 1, 2, 3}, {1, 2, 3}, {0, 2, 3}, {0, 3}, {3}, {}}));
}

TEST(SimplicesAt, SitesThatSpanLessThanSpaceContainPointsOfTheirSpanOnly) {
  // In the plane z = x + 2 y, on the line x = 2 y = z, and one site alone.
  const WeightedPoints flat = plain(3, {0, 0, 0, 4, 0, 4, 0, 4, 8});
  EXPECT_EQ(rows_at<3>(flat, plain(3, {1, 1, 3, 1, 1, 4, 2, 0, 2, 0, 4, 8, 5, 5, 15})),
            (Rows{{0, 1, 2}, {}, {0, 1}, {2}, {}}));
  const WeightedPoints upright = plain(3, {3, 0, 0, 3, 4, 0, 3, 0, 4});
  EXPECT_EQ(rows_at<3>(upright, plain(3, {3, 1, 1, 3.5, 1, 1})), (Rows{{0, 1, 2}, {}}));
  const WeightedPoints line = plain(3, {0, 0, 0, 4, 2, 4, 8, 4, 8});
  EXPECT_EQ(rows_at<3>(line, plain(3, {2, 1, 2, 4, 2, 4, 2, 1, 3, 2, 2, 2, 10, 5, 10})),
            (Rows{{0, 1}, {1}, {}, {}, {}}));
  EXPECT_EQ(rows_at<2>(plain(2, {1, 0, 1, 4}), plain(2, {1, 3, 2, 3})), (Rows{{0, 1}, {}}));
  EXPECT_EQ(rows_at<3>(plain(3, {1, 2, 3}), plain(3, {1, 2, 3, 1, 2, 4})), (Rows{{0}, {}}));
  EXPECT_EQ(rows_at<3>(plain(3, {}), plain(3, {1, 2, 3})), (Rows{{}}));
}

TEST(SimplicesAt, OneTenthIsNotTheDoubleNearestToIt) {
  const auto sites = WeightedPoints::fixed_point(2, 1, {0, 0, 1, 0, 0, 1}, WeightKind::none, {});
  // 0.1 as a double is above one tenth; 0.3 - 0.2 is below.
  EXPECT_EQ(rows_at<2>(sites, plain(2, {0.1, 0, 0.3 - 0.2, 0})), (Rows{{}, {0, 1}}));
  EXPECT_EQ(rows_at<2>(sites, WeightedPoints::fixed_point(2, 3, {100, 0, 99, 0, 101, 0},
                                                          WeightKind::none, {})),
            (Rows{{1}, {0, 1}, {}}));
  // And the other way round.
  const WeightedPoints doubles = plain(2, {0, 0, 0.1, 0, 0, 0.1});
  EXPECT_EQ(rows_at<2>(doubles, WeightedPoints::fixed_point(2, 1, {1, 0}, WeightKind::none, {})),
            (Rows{{0, 1}}));
}

// The orientation of three points of [0, 64)^2 whose coordinates are multiples of 2^-53.
__extension__ using Int128 = __int128;
int orientation(const std::array<double, 6>& p) {
  std::array<Int128, 6> x;
  for (std::size_t i = 0; i < 6; ++i) x[i] = static_cast<std::int64_t>(std::ldexp(p[i], 53));
  const Int128 det = (x[2] - x[0]) * (x[5] - x[1]) - (x[3] - x[1]) * (x[4] - x[0]);
  return (det > 0) - (det < 0);
}

TEST(SimplicesAt, TheLastBitDecidesOnWhichSideOfAnEdgeAPointIs) {
  generators::Random random(7);
  std::array<int, 3> seen{};
  for (int i = 0; i < 2000; ++i) {
    const double t = random.uniform(0.2, 0.8);
    std::array<double, 6> p{};  // two corners, and a point near the edge between them
    for (std::size_t k = 0; k < 4; ++k) p[k] = random.uniform() * (k < 2 ? 1 : 64);
    for (std::size_t k = 0; k < 2; ++k) {
      const double x = p[k] + t * (p[k + 2] - p[k]);
      p[k + 4] = std::ldexp(std::nearbyint(std::ldexp(x, 53)), -53);
    }
    // On the side of the third corner?
    const int side = orientation(p) * orientation({p[0], p[1], p[2], p[3], 1.25, 60});
    ++seen[static_cast<std::size_t>(side + 1)];
    const WeightedPoints triangle = plain(2, {p[0], p[1], p[2], p[3], 1.25, 60});
    const Rows expected{side > 0    ? std::vector<std::uint32_t>{0, 1, 2}
                        : side == 0 ? std::vector<std::uint32_t>{0, 1}
                                    : std::vector<std::uint32_t>{}};
    EXPECT_EQ(rows_at<2>(triangle, plain(2, {p[4], p[5]})), expected) << i;
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[2], 100);
}

TEST(SimplicesAt, PointsOfAnotherDimensionAreRefused) {
  EXPECT_THROW((void)simplices_at(filtration_of<2>(plain(2, {0, 0})), plain(3, {0, 0, 0})),
               InputError);
}

TEST(SimplicesAt, EverySiteIsAtItsVertex) {
  const auto check = []<int D>(const WeightedPoints& points) {
    const auto filtration = filtration_of<D>(points);
    const auto& sites = filtration.triangulation().sites();
    const auto found = simplices_at(filtration, points);
    for (std::uint32_t v = 0; v < sites.size(); ++v) {
      EXPECT_EQ(found[sites.row(v).row()], SimplexId(v));
    }
    // Every site, hidden or not, is in the hull.
    for (const SimplexId simplex : found) EXPECT_TRUE(simplex.exists());
  };
  for (const auto family : generators::point_families()) {
    SCOPED_TRACE(generators::name(family));
    check.operator()<2>(generators::points_of(family, 2, 60, 3));
    check.operator()<3>(generators::points_of(family, 3, 60, 3));
  }
}

// det of the rows 1..D, each a corner less corner 0, in integers.
std::int64_t determinant(const std::array<std::array<std::int64_t, 2>, 3>& p) {
  return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
}
std::int64_t determinant(const std::array<std::array<std::int64_t, 3>, 4>& p) {
  const auto at = [&](std::size_t i, std::size_t j) { return p[i][j] - p[0][j]; };
  return at(1, 0) * (at(2, 1) * at(3, 2) - at(2, 2) * at(3, 1)) -
         at(1, 1) * (at(2, 0) * at(3, 2) - at(2, 2) * at(3, 0)) +
         at(1, 2) * (at(2, 0) * at(3, 1) - at(2, 1) * at(3, 0));
}

// By looking at all cells: the corners that a point is not opposite to.
template <int D>
std::vector<std::uint32_t> by_brute_force(const Filtration<D>& filtration,
                                          const WeightedPoints& points,
                                          const std::array<std::int64_t, std::size_t{D}>& query) {
  const auto position = [&](std::uint32_t row) {
    std::array<std::int64_t, std::size_t{D}> x{};
    for (int axis = 0; axis < D; ++axis) {
      x[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(points.coordinate(row, axis));
    }
    return x;
  };
  for (const auto& cell : filtration.triangulation().template cells<D>()) {
    std::set<std::uint32_t> rows;
    bool contains = true;
    for (std::size_t i = 0; i <= D; ++i) {
      std::array<std::array<std::int64_t, std::size_t{D}>, std::size_t{D} + 1> corners;
      for (std::size_t j = 0; j <= D; ++j) {
        const std::uint32_t row = filtration.triangulation().sites().row(cell.corners[j]).row();
        corners[j] = i == j ? query : position(row);
        if (i == j) rows.insert(row);
      }
      const std::int64_t side = determinant(corners);
      contains &= side >= 0;
      if (side == 0) {
        rows.erase(filtration.triangulation().sites().row(cell.corners[i]).row());
      }
    }
    if (contains) return {rows.begin(), rows.end()};
  }
  return {};
}

template <int D>
void agrees_with_brute_force(std::uint64_t seed) {
  generators::Random random(seed);
  std::vector<double> sites, queries;
  for (int i = 0; i < 25 * D; ++i) sites.push_back(random.integer(-4, 4));
  for (int i = 0; i < 80 * D; ++i) queries.push_back(random.integer(-5, 5));
  const WeightedPoints points = plain(D, sites);
  const auto filtration = filtration_of<D>(points);
  if (filtration.triangulation().affine_dimension() < D) return;
  const Rows found = rows_at<D>(points, plain(D, queries));
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::array<std::int64_t, std::size_t{D}> query{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      query[axis] = static_cast<std::int64_t>(queries[D * i + axis]);
    }
    EXPECT_EQ(found[i], by_brute_force(filtration, points, query)) << "seed " << seed << ", " << i;
  }
}

TEST(SimplicesAt, AgreesWithBruteForceOnLattices) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    agrees_with_brute_force<2>(seed);
    agrees_with_brute_force<3>(seed);
  }
}

TEST(SimplicesAt, IsTheSameOnAnyNumberOfThreads) {
  const WeightedPoints sites = generators::points_of(generators::PointFamily::uniform, 3, 500, 1);
  const WeightedPoints points = generators::points_of(generators::PointFamily::uniform, 3, 5000, 2);
  const auto filtration = filtration_of<3>(sites);
  EXPECT_EQ(simplices_at(filtration, points, Threads(1)),
            simplices_at(filtration, points, Threads(4)));
}

}  // namespace
}  // namespace orthoball
