// SPDX-License-Identifier: MIT
#include "orthoball/queries/pockets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/error.h"
#include "orthoball/queries/voids.h"
#include "unit/queries/filtration_of.h"

namespace orthoball {
namespace {

// Disks on a circle of radius 5 that touch their neighbours more than well, without those for which
// `is_left_out`.
template <class IsLeftOut>
WeightedPoints ring(const IsLeftOut& is_left_out) {
  std::vector<double> x;
  constexpr int kDisks = 24;
  for (int i = 0; i < kDisks; ++i) {
    if (is_left_out(i)) continue;
    x.push_back(5 * std::cos(2 * std::numbers::pi * i / kDisks));
    x.push_back(5 * std::sin(2 * std::numbers::pi * i / kDisks));
  }
  const std::size_t size = x.size() / 2;
  return {2, std::move(x), WeightKind::radius, std::vector<double>(size, 0.9)};
}

TEST(Pockets, ARingEnclosesAVoid) {
  const auto filtration = filtration_of<2>(ring([](int) { return false; }));
  const std::uint32_t index = filtration.index(0.0);
  const auto found = pockets(filtration, index, 0.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].mouths.empty());
  EXPECT_FALSE(found[0].depth.has_value());
  const auto same = voids(filtration, index, 0.0, VoidsOf::balls);
  ASSERT_EQ(same.size(), 1U);
  EXPECT_EQ(found[0].volume, same[0].volume);
  EXPECT_EQ(found[0].area, same[0].area);
  EXPECT_EQ(found[0].cells, same[0].cells);
}

TEST(Pockets, AnOpenRingIsAPocketWithOneMouth) {
  const auto filtration = filtration_of<2>(ring([](int i) { return i == 0 || i == 1; }));
  const auto found = pockets(filtration, filtration.index(0.0), 0.0);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].mouths.size(), 1U);
  const Mouth& mouth = found[0].mouths[0];
  EXPECT_EQ(mouth.rim, (std::vector<SiteId>{SiteId(0), SiteId(21)}));
  const double gap = 2 * 5 * std::sin(3 * std::numbers::pi / 24);
  EXPECT_NEAR(mouth.area, gap - 2 * 0.9, 1e-14);
  ASSERT_TRUE(found[0].depth.has_value());
  EXPECT_NEAR(*found[0].depth, 25.0 - gap * gap / 4, 1e-12);
  EXPECT_EQ(found[0].lining.size(), 22U);
}

TEST(Pockets, TwoOpeningsMakeAChannel) {
  const auto filtration =
      filtration_of<2>(ring([](int i) { return i == 0 || i == 1 || i == 12 || i == 13; }));
  const auto found = pockets(filtration, filtration.index(0.0), 0.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].mouths.size(), 2U);
}

TEST(Pockets, AWideOpeningIsNone) {
  // Less than half a ring: everything flows out.
  const auto filtration = filtration_of<2>(ring([](int i) { return i < 13; }));
  EXPECT_TRUE(pockets(filtration, filtration.index(0.0), 0.0).empty());
}

TEST(Pockets, HaveMouthsBesideBallsThatOthersCover) {
  // A small disk inside a large one has a power cell but is in no mouth: the mouth of the triangle
  // of large disks is as wide as without it.
  const auto filtration =
      filtration_of<2>({2, {0, 0, 8.9, 0, 25, 0, 12, 25}, WeightKind::radius, {10, 1, 10, 10}});
  ASSERT_EQ(filtration.triangulation().vertex_count(), 4U);
  const auto found = pockets(filtration, filtration.index(0.0), 0.0);
  ASSERT_EQ(found.size(), 1U);
  double narrowest = 1e9;
  for (const Mouth& mouth : found[0].mouths) narrowest = std::min(narrowest, mouth.area);
  EXPECT_NEAR(narrowest, 5.0, 1e-13);
}

TEST(Pockets, OnTheFacetNothingFlows) {
  // A square cell whose orthocentre lies on the diagonal, and on the hull's edges where they are
  // hypotenuses: the right triangle flows nowhere, so its inside is a pocket with mouths.
  const auto filtration =
      filtration_of<2>({2, {0, 0, 4, 0, 0, 4}, WeightKind::radius, std::vector<double>(3, 1.0)});
  const auto found = pockets(filtration, filtration.index(0.0), 0.0);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].mouths.size(), 3U);
  EXPECT_NEAR(found[0].mouths[0].area, std::sqrt(32.0) - 2, 1e-14);
  EXPECT_NEAR(found[0].volume, 8.0 - std::numbers::pi / 2, 1e-14);
}

TEST(Pockets, OfATetrahedronOfBallsHaveOneMouthForEachFacet) {
  const auto filtration = filtration_of<3>({3,
                                            {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1},
                                            WeightKind::radius,
                                            std::vector<double>(4, 1.5)});
  // Balls overlap along the edges of length 2 sqrt(2), so that the facets do not hang together.
  const auto found = pockets(filtration, filtration.index(0.0), 0.0);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].mouths.size(), 4U);
  const double r = 1.5, half = std::sqrt(2.0), circle = std::sqrt(r * r - half * half);
  const double opening = std::atan2(circle, half);
  const double triangle = 2 * std::sqrt(3.0);
  const double free =
      triangle - 3 * half * circle - 3 * r * r / 2 * (std::numbers::pi / 3 - 2 * opening);
  for (const Mouth& mouth : found[0].mouths) {
    EXPECT_NEAR(mouth.area, free, 1e-14);
    EXPECT_EQ(mouth.rim.size(), 3U);
  }
}

TEST(Pockets, AreNoneOfFlatSitesAndOfNone) {
  EXPECT_TRUE(pockets(filtration_of<3>(WeightedPoints(3)), 0, 0.0).empty());
  EXPECT_THROW(static_cast<void>(pockets(filtration_of<3>(WeightedPoints(3)), 1, 0.0)), InputError);
}

template <int D>
using Point = std::array<double, std::size_t{D}>;

// The definition by orthocentres in doubles, for points in general position, and paths one by one.
template <int D>
std::set<SimplexId> cells_of_pockets(const Filtration<D>& filtration, std::uint32_t index) {
  const auto& sites = filtration.triangulation().sites();
  const auto cells = filtration.triangulation().template cells<D>();
  const auto orthocentre = [&](std::uint32_t cell) {
    std::vector<std::vector<double>> rows;
    const auto& first = sites[cells[cell].corners[0]];
    for (std::size_t i = 1; i <= D; ++i) {
      const auto& other = sites[cells[cell].corners[i]];
      std::vector<double> row;
      double value = first.weight - other.weight;
      for (std::size_t axis = 0; axis < D; ++axis) {
        row.push_back(other.x[axis] - first.x[axis]);
        value += other.x[axis] * other.x[axis] - first.x[axis] * first.x[axis];
      }
      row.push_back(value / 2);
      rows.push_back(row);
    }
    for (std::size_t i = 0; i < D; ++i) {  // Gauss and Jordan
      std::size_t best = i;
      for (std::size_t k = i; k < D; ++k) {
        if (std::abs(rows[k][i]) > std::abs(rows[best][i])) best = k;
      }
      std::swap(rows[i], rows[best]);
      for (std::size_t k = 0; k < D; ++k) {
        if (k == i) continue;
        const double factor = rows[k][i] / rows[i][i];
        for (std::size_t j = i; j <= D; ++j) rows[k][j] -= factor * rows[i][j];
      }
    }
    Point<D> x{};
    for (std::size_t i = 0; i < D; ++i) x[i] = rows[i][std::size_t{D}] / rows[i][i];
    return x;
  };
  // Which side of the facet opposite a corner a point is on, like the corner (+) or not.
  const auto side = [&](std::uint32_t cell, std::size_t corner, const Point<D>& x) {
    std::vector<Point<D>> at;
    for (std::size_t i = 0; i <= D; ++i) {
      if (i == corner) continue;
      Point<D> point{};
      std::copy_n(sites[cells[cell].corners[i]].x, std::size_t{D}, point.begin());
      at.push_back(point);
    }
    const auto determinant = [&](const Point<D>& p) {
      if constexpr (D == 2) {
        return (at[1][0] - at[0][0]) * (p[1] - at[0][1]) -
               (at[1][1] - at[0][1]) * (p[0] - at[0][0]);
      } else {
        std::array<std::array<double, 3>, 3> d{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          d[0][axis] = at[1][axis] - at[0][axis];
          d[1][axis] = at[2][axis] - at[0][axis];
          d[2][axis] = p[axis] - at[0][axis];
        }
        return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
               d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
               d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
      }
    };
    Point<D> own{};
    std::copy_n(sites[cells[cell].corners[corner]].x, std::size_t{D}, own.begin());
    return determinant(x) * determinant(own);
  };
  std::map<std::uint32_t, bool> known;
  const auto gets_out = [&](const auto& self, std::uint32_t cell) -> bool {
    if (const auto found = known.find(cell); found != known.end()) return found->second;
    known[cell] = false;
    const auto x = orthocentre(cell);
    bool result = false;
    for (std::size_t corner = 0; corner <= D; ++corner) {
      if (side(cell, corner, x) >= 0.0) continue;
      const std::uint32_t beyond = cells[cell].neighbours[corner];
      result = result || beyond == kOutside || self(self, beyond / 4);
    }
    return known[cell] = result;
  };
  std::set<SimplexId> result;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const SimplexId id(filtration.table().first(D) + cell);
    if (filtration.enters(id) > index && !gets_out(gets_out, cell)) result.insert(id);
  }
  return result;
}

template <int D>
void expect_definition(const WeightedPoints& points) {
  const auto filtration = filtration_of<D>(points);
  for (const double share : {0.0, 0.1, 0.3, 0.5, 0.8}) {
    const auto index =
        static_cast<std::uint32_t>(share * static_cast<double>(filtration.spectrum_size()));
    const double alpha2 = index == 0 ? -1.0 : filtration.alpha2(index);
    const auto found = pockets(filtration, index, alpha2);
    std::set<SimplexId> cells, mouth_facets;
    std::size_t without_mouth = 0;
    for (const Pocket& pocket : found) {
      without_mouth += pocket.mouths.empty() ? 1U : 0U;
      for (const SimplexId cell : pocket.cells) EXPECT_TRUE(cells.insert(cell).second);
      for (const Mouth& mouth : pocket.mouths) {
        for (const SimplexId facet : mouth.facets) {
          EXPECT_GT(filtration.enters(facet), index);
          EXPECT_TRUE(mouth_facets.insert(facet).second);
        }
      }
      EXPECT_GE(pocket.depth.value_or(0.0), 0.0);
    }
    EXPECT_EQ(cells, cells_of_pockets<D>(filtration, index));
    // Without a mouth no flow leads in or out: those are the voids.
    EXPECT_EQ(without_mouth, voids(filtration, index, alpha2, VoidsOf::balls).size());
  }
}

TEST(Pockets, AreWhatTheDefinitionSays) {
  using generators::PointFamily;
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::uniform_balls, PointFamily::gaussian}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      expect_definition<2>(points_of(family, 2, 80, seed));
      expect_definition<3>(points_of(family, 3, 120, seed));
    }
  }
}

}  // namespace
}  // namespace orthoball
