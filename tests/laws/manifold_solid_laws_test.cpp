// SPDX-License-Identifier: MIT
// Surfaces to be printed, of any sites, judged by the files that are written of them.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "generators/cases.h"
#include "generators/point_families.h"
#include "generators/random.h"
#include "matchers/describe.h"
#include "oracles/closed_manifold.h"
#include "orthoball/output/mesh.h"
#include "orthoball/queries/manifold_solid.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;

template <int D>
oracles::MeshFile written(const Filtration<D>& filtration, const WeightedPoints& points,
                          std::uint32_t index, const std::vector<bool>& contains) {
  std::ostringstream out;
  ByteSink sink(out, "0");
  ManifoldSolid<D> solid;
  solid.contains = contains;
  const AlphaComplex<D> complex = complex_of(solid, AlphaComplex<D>(filtration, index));
  write_mesh(sink, shape_mesh(complex, points), {MeshFormat::ply, false, 0.0});
  sink.flush();
  return oracles::mesh_file(out.str(), D);
}

template <int D>
std::vector<bool> cells_at(const Filtration<D>& filtration, std::uint32_t index) {
  std::vector<bool> cells(filtration.triangulation().template cells<D>().size());
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    cells[cell] = filtration.enters(SimplexId(filtration.table().first(D) + cell)) <= index;
  }
  return cells;
}

// Calls `check(filtration, points, index)` for some indices of every case.
template <class Check>
void for_each_shape(std::size_t largest, const Check& check) {
  const auto visit = [&]<int D>(const Case& one) {
    SCOPED_TRACE(::testing::Message() << one);
    const WeightedPoints points = one.points();
    const Filtration<D> filtration(regular_triangulation<D>(points));
    const std::uint32_t last = filtration.spectrum_size();
    for (std::uint32_t part = 1; part <= 6; ++part) {
      const auto index = static_cast<std::uint32_t>(std::uint64_t{last} * part / 6);
      SCOPED_TRACE(::testing::Message() << "index " << index);
      check(filtration, points, index, one);
    }
  };
  for (const Case& one : generators::cases(3, 1, largest)) {
    if (one.dimension == 2) visit.template operator()<2>(one);
    if (one.dimension == 3) visit.template operator()<3>(one);
    if (::testing::Test::HasFailure()) return;  // one case tells enough
  }
}

TEST(ManifoldSolid, IsWrittenAsAnOrientedClosedManifoldOfAnySites) {
  for_each_shape(90, [&]<int D>(const Filtration<D>& filtration, const WeightedPoints& points,
                                std::uint32_t index, const Case& one) {
    const ManifoldSolid<D> solid = manifold_solid(AlphaComplex(filtration, index));
    const auto file = written(filtration, points, index, solid.contains);
    EXPECT_TRUE(file.faults.empty()) << matchers::described(file.faults);
    if (generators::is_extreme(one.family)) return;
    EXPECT_NEAR(file.volume, solid.volume, 1e-9 * std::abs(solid.volume) + 1e-12);
  });
}

TEST(ManifoldSolid, ChangesCellsExactlyWhereTheSurfaceIsNoManifold) {
  std::size_t offending = 0, manifold = 0;
  for_each_shape(60, [&]<int D>(const Filtration<D>& filtration, const WeightedPoints& points,
                                std::uint32_t index, const Case&) {
    const ManifoldSolid<D> solid = manifold_solid(AlphaComplex(filtration, index));
    const std::vector<bool> before = cells_at(filtration, index);
    const bool is_manifold = written(filtration, points, index, before).faults.empty();
    EXPECT_EQ(solid.offending.empty(), is_manifold);
    EXPECT_EQ(solid.changes.empty(), is_manifold);
    ++(is_manifold ? manifold : offending);
    std::vector<bool> after = before;
    for (const SolidChange<D>& change : solid.changes) {
      for (const SimplexId cell : change.cells) {
        const std::uint32_t number = cell.row() - filtration.table().first(D);
        EXPECT_EQ(before[number], !change.is_added);
        after[number] = change.is_added;
      }
    }
    EXPECT_EQ(after, solid.contains);
  });
  EXPECT_GT(offending, 100U);  // both happen
  EXPECT_GT(manifold, 100U);
}

TEST(ManifoldSolid, HasNoCellThatCouldBeChangedBack) {
  for_each_shape(40, [&]<int D>(const Filtration<D>& filtration, const WeightedPoints& points,
                                std::uint32_t index, const Case&) {
    ManifoldSolid<D> solid = manifold_solid(AlphaComplex(filtration, index));
    for (const SolidChange<D>& change : solid.changes) {
      for (const SimplexId cell : change.cells) {
        const std::uint32_t number = cell.row() - filtration.table().first(D);
        solid.contains[number] = !solid.contains[number];
        EXPECT_FALSE(written(filtration, points, index, solid.contains).faults.empty());
        solid.contains[number] = !solid.contains[number];
      }
    }
  });
}

// Sites on a sphere or circle, then its centre, which all cells have; of these a random half.
struct Cone {
  WeightedPoints points;
  std::vector<bool> cells;
};

template <int D>
Cone cone(std::size_t count, std::uint64_t seed) {
  const WeightedPoints sphere =
      generators::points_of(generators::PointFamily::near_sphere, D, count, seed);
  std::vector<double> coordinates;
  for (std::size_t row = 0; row < count; ++row) {
    for (int axis = 0; axis < D; ++axis) coordinates.push_back(sphere.coordinate(row, axis));
  }
  coordinates.insert(coordinates.end(), D, 0.0);
  Cone cone{WeightedPoints(D, coordinates, WeightKind::none, {}), std::vector<bool>(3 * count)};
  generators::Random random(seed);
  for (std::size_t cell = 0; cell < cone.cells.size(); ++cell) cone.cells[cell] = random.coin();
  return cone;
}

template <int D>
AlphaComplex<D> complex_of(const Filtration<D>& filtration, const std::vector<bool>& cells) {
  std::vector<SimplexId> chosen;
  for (std::uint32_t cell = 0; cell < filtration.count(D); ++cell) {
    if (cells[cell]) chosen.emplace_back(filtration.table().first(D) + cell);
  }
  return {filtration, filtration.spectrum_size(), chosen};
}

// Takes minutes if the work grows with more than the number of cells around the vertex.
template <int D>
void check_cone(std::size_t count, bool tries_all) {
  const Cone one = cone<D>(count, count);
  const Filtration<D> filtration(regular_triangulation<D>(one.points));
  const std::uint32_t last = filtration.spectrum_size();
  ManifoldSolid<D> solid = manifold_solid(complex_of(filtration, one.cells));
  EXPECT_GT(solid.offending.size(), D == 3 ? count / 5 : 0);
  EXPECT_FALSE(solid.changes.empty());
  const auto file = written(filtration, one.points, last, solid.contains);
  EXPECT_TRUE(file.faults.empty()) << matchers::described(file.faults);
  EXPECT_NEAR(file.volume, solid.volume, 1e-9);
  for (const SolidChange<D>& change : solid.changes) {
    if (!tries_all) break;
    for (const SimplexId cell : change.cells) {
      const std::uint32_t number = cell.row() - filtration.table().first(D);
      solid.contains[number] = !solid.contains[number];
      EXPECT_FALSE(written(filtration, one.points, last, solid.contains).faults.empty());
      solid.contains[number] = !solid.contains[number];
    }
  }
}

TEST(ManifoldSolid, IsFoundAroundOneVertexOfHighDegree) {
  check_cone<3>(300, true);
  check_cone<2>(300, true);
  check_cone<3>(10'000, false);
  check_cone<2>(10'000, false);
}

TEST(ManifoldSolid, DoesNotDependOnTheOrderOfRows) {
  for (const Case& one : generators::cases(1, 10, 80)) {
    SCOPED_TRACE(::testing::Message() << one);
    if (one.dimension != 3) continue;
    const WeightedPoints points = one.points();
    const auto rows = generators::random_permutation(one.count, one.seed);
    const Filtration<3> one_way(regular_triangulation<3>(points));
    const Filtration<3> other_way(regular_triangulation<3>(generators::with_rows(points, rows)));
    const std::uint32_t index = one_way.spectrum_size() / 3;
    const auto a = manifold_solid(AlphaComplex(one_way, index)),
               b = manifold_solid(AlphaComplex(other_way, index));
    EXPECT_EQ(a.contains, b.contains);
    EXPECT_EQ(a.added, b.added);
    EXPECT_EQ(a.removed, b.removed);
  }
  const Cone one = cone<3>(500, 1);
  const auto rows = generators::random_permutation(one.points.size(), 1);
  const Filtration<3> one_way(regular_triangulation<3>(one.points));
  const Filtration<3> other_way(regular_triangulation<3>(generators::with_rows(one.points, rows)));
  EXPECT_EQ(manifold_solid(complex_of(one_way, one.cells)).contains,
            manifold_solid(complex_of(other_way, one.cells)).contains);
}

}  // namespace
}  // namespace orthoball
