// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "matchers/same_bytes.h"
#include "oracles/brute_force.h"
#include "orthoball/error.h"
#include "orthoball/triangulation/verify.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using Rows = std::vector<std::uint32_t>;

// Built, and found without faults.
template <int D>
RegularTriangulation<D> verified(const WeightedPoints& points) {
  auto triangulation = regular_triangulation<D>(points);
  EXPECT_EQ(verify(triangulation, points), std::vector<std::string>{});
  EXPECT_EQ(triangulation.site_count(), points.size());
  return triangulation;
}

template <int D>
Rows hidden_rows(const RegularTriangulation<D>& triangulation) {
  Rows rows;
  for (const SiteId row : triangulation.hidden()) rows.push_back(row.row());
  return rows;
}

WeightedPoints unweighted(int dimension, std::vector<double> coordinates) {
  return {dimension, std::move(coordinates), WeightKind::none, {}};
}

TEST(RegularTriangulation, OfNoSitesIsEmpty) {
  const auto flat = verified<2>(WeightedPoints(2));
  EXPECT_EQ(flat.affine_dimension(), -1);
  EXPECT_EQ(flat.cell_count(), 0U);
  EXPECT_EQ(verified<3>(WeightedPoints(3)).vertex_count(), 0U);
}

TEST(RegularTriangulation, OfOneCentreIsItsHeaviestSite) {
  const auto one = verified<3>(unweighted(3, {4, 5, 6}));
  EXPECT_EQ(one.affine_dimension(), 0);
  EXPECT_EQ(one.vertex_count(), 1U);
  EXPECT_EQ(one.cell_count(), 1U);
  const auto nested = verified<2>({2, {1, 1, 1, 1, 1, 1, 1, 1}, WeightKind::radius, {2, -3, 5, 5}});
  EXPECT_EQ(nested.affine_dimension(), 0);
  EXPECT_EQ(nested.sites().row(0), SiteId(2));
  EXPECT_EQ(hidden_rows(nested), (Rows{0, 1}));
  ASSERT_EQ(nested.duplicates().size(), 1U);
  EXPECT_EQ(nested.duplicates()[0], (Duplicate{SiteId(3), SiteId(2)}));
}

TEST(RegularTriangulation, OfALineIsAChain) {
  std::vector<double> flat, solid;
  for (const int i : {5, 3, 9, 0, 1, 7}) {
    flat.insert(flat.end(), {1.0 + i, 2.0 - 3 * i});
    solid.insert(solid.end(), {4.0, 0.5 * i, -1.0 * i});
  }
  const auto in_plane = verified<2>(unweighted(2, flat));
  EXPECT_EQ(in_plane.affine_dimension(), 1);
  EXPECT_EQ(in_plane.cell_count(), 5U);
  const auto in_space = verified<3>(unweighted(3, solid));
  EXPECT_EQ(in_space.affine_dimension(), 1);
  EXPECT_EQ(in_space.cells<1>().size(), 5U);
  EXPECT_TRUE(in_space.cells<2>().empty());
  EXPECT_TRUE(in_space.cells<3>().empty());
  const auto ends = std::count_if(
      in_space.cells<1>().begin(), in_space.cells<1>().end(),
      [](auto& cell) { return cell.neighbours[0] == kOutside || cell.neighbours[1] == kOutside; });
  EXPECT_EQ(ends, 2);
}

TEST(RegularTriangulation, OfAPlaneInSpaceHasTriangles) {
  std::vector<double> coordinates;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      coordinates.insert(coordinates.end(),
                         {static_cast<double>(i + j), static_cast<double>(i), 3.0 * j});
    }
  }
  const auto triangulation = verified<3>(unweighted(3, coordinates));
  EXPECT_EQ(triangulation.affine_dimension(), 2);
  EXPECT_EQ(triangulation.cell_count(), 18U);
  EXPECT_EQ(triangulation.cells<2>().size(), 18U);
}

// By the perturbation every square is cut beside its largest corner, every cube alike in six.
TEST(RegularTriangulation, CutsEveryCubeOfAGridIntoSix) {
  for (const std::size_t side : {2U, 3U, 5U, 9U}) {
    const auto flat = verified<2>(points_of(PointFamily::grid, 2, side * side, 1));
    EXPECT_EQ(flat.cell_count(), 2 * (side - 1) * (side - 1));
    const auto solid = verified<3>(points_of(PointFamily::grid, 3, side * side * side, 1));
    EXPECT_EQ(solid.cell_count(), 6 * (side - 1) * (side - 1) * (side - 1));
    EXPECT_TRUE(solid.hidden().empty());
  }
}

TEST(RegularTriangulation, CutsTheUnitSquareBesideItsLargestCorner) {
  const auto triangulation = verified<2>(unweighted(2, {0, 0, 1, 0, 1, 1, 0, 1}));
  std::vector<Rows> cells;
  for (const auto& cell : triangulation.cells<2>()) {
    Rows rows;
    for (const std::uint32_t vertex : cell.corners) {
      rows.push_back(triangulation.sites().row(vertex).row());
    }
    std::sort(rows.begin(), rows.end());
    cells.push_back(rows);
  }
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(cells, (std::vector<Rows>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(RegularTriangulation, ListsHiddenSitesAndDuplicatesByRow) {
  // A tetrahedron; at its first corner a lighter and an equal site; inside one that is too light.
  const auto triangulation =
      verified<3>({3,
                   {0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 1, 1, 1, 1, 1, 1},
                   WeightKind::weight,
                   {1, 0, 1, 1, 1, 1, -60, -60}});
  EXPECT_EQ(triangulation.cell_count(), 1U);
  EXPECT_EQ(triangulation.vertex_count(), 4U);
  EXPECT_EQ(hidden_rows(triangulation), (Rows{1, 6}));
  ASSERT_EQ(triangulation.duplicates().size(), 2U);
  EXPECT_EQ(triangulation.duplicates()[0], (Duplicate{SiteId(5), SiteId(0)}));
  EXPECT_EQ(triangulation.duplicates()[1], (Duplicate{SiteId(7), SiteId(6)}));
  EXPECT_EQ(triangulation.distinct_site_count(), 6U);
}

// A power cell that is a single point still makes a vertex; anything less hides the site.
TEST(RegularTriangulation, KeepsASiteWhosePowerCellIsAPoint) {
  const auto with = [](double weight) {
    return verified<2>(
        {2, {0, 0, 2, 0, 0, 2, 2, 2, 1, 1}, WeightKind::weight, {0, 0, 0, 0, weight}});
  };
  EXPECT_EQ(hidden_rows(with(-2)), Rows{});
  EXPECT_EQ(with(-2).cell_count(), 4U);
  EXPECT_EQ(hidden_rows(with(-2.25)), Rows{4});
}

// Whichever comes first: light sites that a heavy one swallows, or that find it there.
TEST(RegularTriangulation, HidesWhatAHeavySiteSwallowsLater) {
  std::size_t hidden = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    std::vector<double> coordinates, weights;
    for (int i = 0; i < 16; ++i) {
      for (int axis = 0; axis < 3; ++axis) coordinates.push_back(random.uniform(-1, 1));
      weights.push_back(i % 8 == 5 ? 3.0 : 0.0);
    }
    const WeightedPoints points(3, coordinates, WeightKind::weight, weights);
    const auto triangulation = verified<3>(points);
    EXPECT_EQ(hidden_rows(triangulation), oracles::sites_without_power_cell(points));
    hidden += triangulation.hidden().size();
  }
  EXPECT_GT(hidden, 40U);
}

TEST(RegularTriangulation, HidesAllBehindOneVeryHeavySite) {
  Random random(3);
  std::vector<double> coordinates{0.5, 0.5, 0.5}, weights{1e6};
  for (int i = 0; i < 500; ++i) {
    for (int axis = 0; axis < 3; ++axis) coordinates.push_back(random.uniform());
    weights.push_back(0);
  }
  const auto triangulation = verified<3>({3, coordinates, WeightKind::weight, weights});
  // The heavy one stays, and those it cannot hide: the corners of the hull.
  EXPECT_GT(triangulation.vertex_count(), 4U);
  EXPECT_LT(triangulation.vertex_count(), 150U);
  EXPECT_EQ(triangulation.sites().row(triangulation.vertex_count() - 1).exists(), true);
  for (const auto& cell : triangulation.cells<3>()) {
    EXPECT_TRUE(std::any_of(cell.corners.begin(), cell.corners.end(), [&](std::uint32_t vertex) {
      return triangulation.sites().row(vertex) == SiteId(0);
    }));
  }
}

// The centre's cavity has thousands of boundary vertices: facets are joined by sorting there.
TEST(RegularTriangulation, JoinsTheCellsOfALargeCavity) {
  constexpr std::uint32_t kCount = 5000;
  Random random(9);
  std::vector<double> coordinates{0, 0, 0};
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const std::array<double, 3> x{random.normal(), random.normal(), random.normal()};
    const double length = std::hypot(x[0], x[1], x[2]);
    for (const double part : x) coordinates.push_back(part / length);
  }
  const auto with_centre = verified<3>(unweighted(3, coordinates));
  EXPECT_EQ(with_centre.cell_count(), 2 * kCount - 4U);  // one for each triangle of the hull
  // Several sites near the centre, and one that is heavy and swallows them.
  std::vector<double> weights(kCount + 1, 0.0);
  for (const double at : {1e-3, -1e-3, 2e-3}) {
    coordinates.insert(coordinates.end(), {at, 0.5 * at, -at});
    weights.push_back(at == 2e-3 ? 0.5 : 0.0);
  }
  const auto swallowed = verified<3>({3, coordinates, WeightKind::weight, weights});
  EXPECT_EQ(hidden_rows(swallowed), (Rows{0, kCount + 1, kCount + 2}));
}

// A spoke of the fan of a circle's centre in the plane.
TEST(RegularTriangulation, JoinsTheCellsOfALargeCavityInThePlane) {
  std::vector<double> coordinates{0, 0};
  for (int i = 0; i < 1000; ++i) {
    coordinates.insert(coordinates.end(), {std::cos(0.001 * i * 6.28), std::sin(0.001 * i * 6.28)});
  }
  EXPECT_EQ(verified<2>(unweighted(2, coordinates)).cell_count(), 1000U);
}

TEST(RegularTriangulation, HasVerticesAndCellsInTheirOneOrder) {
  for (const PointFamily family : {PointFamily::uniform_balls, PointFamily::grid,
                                   PointFamily::cospherical, PointFamily::duplicated}) {
    const WeightedPoints points = points_of(family, 3, 120, 2);
    const auto triangulation = verified<3>(points);  // which checks the order
    const auto order = generators::random_permutation(points.size(), 3);
    const auto shuffled = verified<3>(generators::with_rows(points, order));
    EXPECT_TRUE(matchers::same_bytes(triangulation.cells<3>(), shuffled.cells<3>()))
        << name(family);
    EXPECT_EQ(matchers::renaming_faults(triangulation, shuffled, order),
              std::vector<std::string>{});
  }
}

TEST(RegularTriangulation, VerifiesOnEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      const bool is_slow = family == PointFamily::mixed_scales;
      verified<2>(points_of(family, 2, is_slow ? 30 : 150, seed));
      verified<3>(points_of(family, 3, is_slow ? 15 : 150, seed));
    }
  }
}

TEST(RegularTriangulation, RefusesPointsOfAnotherDimension) {
  EXPECT_THROW((void)regular_triangulation<2>(WeightedPoints(3)), InputError);
  EXPECT_THROW((void)regular_triangulation<3>(WeightedPoints(2)), InputError);
}

TEST(RegularTriangulation, WithoutSitesIsTheDefault) {
  const RegularTriangulation<3> none;
  EXPECT_EQ(none.affine_dimension(), -1);
  EXPECT_EQ(none.cell_count(), 0U);
  EXPECT_EQ(none.site_count(), 0U);
}

}  // namespace
}  // namespace orthoball
