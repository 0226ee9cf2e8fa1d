// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/canonical_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::points_of;

// The cells of a triangulation with vertex v called v * stride, in random slots with dead ones
// between, corners in any order or, where cells are oriented, a random one first; hull facets lead
// to a dead cell.
template <int A>
CellStore<A> scattered(std::span<const CellRecord<A>> cells, std::uint32_t vertices,
                       std::uint32_t stride, bool is_oriented, std::mt19937& random) {
  CellStore<A> store(std::size_t{vertices} * stride, 0);
  std::vector<std::uint32_t> slots(2 * cells.size() + 1);
  std::iota(slots.begin(), slots.end(), 0U);
  std::shuffle(slots.begin(), slots.end(), random);
  (void)store.add(static_cast<std::uint32_t>(slots.size()));
  std::vector<std::array<std::uint32_t, 4>> corner_of(cells.size());  // [cell][corner before]
  for (auto& turned : corner_of) {
    turned = {0, 1, 2, 3};
    if (is_oriented) {
      std::rotate(turned.begin(), turned.begin() + random() % 3, turned.begin() + 3);  // even
    } else {
      std::shuffle(turned.begin(), turned.begin() + A + 1, random);
    }
  }
  const std::uint32_t dead = slots.back();
  for (const std::uint32_t slot : slots) {
    store[slot] = {};
    store.kill(slot);
  }
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    CellRecord<A>& record = store[slots[cell]];
    for (std::size_t corner = 0; corner <= A; ++corner) {
      const std::uint32_t to = corner_of[cell][corner];
      const std::uint32_t facet = cells[cell].neighbours[corner];
      record.corners[to] = cells[cell].corners[corner] * stride;
      record.neighbours[to] =
          facet == kOutside ? 4 * dead : 4 * slots[facet / 4] + corner_of[facet / 4][facet % 4];
    }
  }
  return store;
}

template <int A, int D>
void check(const WeightedPoints& points) {
  const RegularTriangulation<D> triangulation = regular_triangulation<D>(points);
  ASSERT_EQ(triangulation.affine_dimension(), A);
  const auto cells = triangulation.template cells<A>();
  const auto vertices = static_cast<std::uint32_t>(triangulation.vertex_count());
  std::mt19937 random(1);
  // With the last, corners of a cell differ by more than fits one key.
  for (const std::uint32_t stride : {1U, 7U, (1U << 22U) / vertices}) {
    const std::vector<bool> none_hidden(std::size_t{vertices} * stride, false);
    for (const unsigned threads : {1U, 3U}) {
      const CellArray<A> found =
          canonical_cells<A>(scattered<A>(cells, vertices, stride, A == D, random), none_hidden,
                             A == D, Threads(threads));
      ASSERT_EQ(found.size(), cells.size());
      for (std::size_t cell = 0; cell < found.size(); ++cell) {
        for (std::size_t corner = 0; corner <= A; ++corner) {
          ASSERT_EQ(found[cell].corners[corner], cells[cell].corners[corner] * stride);
          ASSERT_EQ(found[cell].neighbours[corner], cells[cell].neighbours[corner]);
        }
      }
    }
  }
}

TEST(CanonicalCells, DoNotDependOnSlotsOrFirstCorners) {
  check<2, 2>(points_of(PointFamily::uniform, 2, 300, 1));
  check<3, 3>(points_of(PointFamily::uniform, 3, 300, 2));
}

TEST(CanonicalCells, OnALineOrInAPlaneHaveNoOrientation) {
  std::vector<double> line, plane;
  for (int i = 0; i < 200; ++i) {
    line.insert(line.end(), {3.0 * i, 1.0 - i});
    plane.insert(plane.end(), {1.0 * (i % 13), 2.0 * (i % 29), 1.0 * (i % 13) + 4.0 * (i % 29)});
  }
  check<1, 2>(WeightedPoints(2, line, WeightKind::none, {}));
  check<2, 3>(WeightedPoints(3, plane, WeightKind::none, {}));
}

TEST(CanonicalCells, AreTheSameOnSeveralThreads) {
  check<2, 2>(points_of(PointFamily::uniform, 2, 40'000, 1));  // enough for them
  check<3, 3>(points_of(PointFamily::uniform, 3, 12'000, 2));
}

TEST(CanonicalCells, AreOrderedWhereManyShareTheirFirstCorner) {
  // The curve begins at the origin, the centre of a sphere in an eighth of which all others lie:
  // most cells have it as their smallest corner.
  std::vector<double> coordinates;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 400; ++i) {
    const std::array<double, 3> x{std::abs(normal(random)), std::abs(normal(random)),
                                  std::abs(normal(random))};
    const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (const double one : x) coordinates.push_back(one / length);
  }
  coordinates.insert(coordinates.end(), {0.0, 0.0, 0.0});
  const WeightedPoints points(3, coordinates, WeightKind::none, {});
  const RegularTriangulation<3> triangulation = regular_triangulation<3>(points);
  const auto cells = triangulation.cells<3>();
  EXPECT_GT(std::count_if(cells.begin(), cells.end(),
                          [](const CellRecord<3>& cell) { return cell.corners[0] == 0; }),
            100);
  check<3, 3>(points);
}

}  // namespace
}  // namespace orthoball
