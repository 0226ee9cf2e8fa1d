// SPDX-License-Identifier: MIT
//
// Triangulations are taken apart, broken in one way and put together again: the fault must be
// named.
#include "orthoball/triangulation/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
typename RegularTriangulation<D>::Parts parts_of(const RegularTriangulation<D>& triangulation) {
  typename RegularTriangulation<D>::Parts parts;
  parts.affine_dimension = triangulation.affine_dimension();
  parts.sites = triangulation.sites();
  const auto copy = [](auto& to, auto from) { to.assign(from.begin(), from.end()); };
  copy(parts.segments, triangulation.template cells<1>());
  copy(parts.triangles, triangulation.template cells<2>());
  if constexpr (D == 3) copy(parts.tetrahedra, triangulation.template cells<3>());
  copy(parts.hidden, triangulation.hidden());
  copy(parts.duplicates, triangulation.duplicates());
  return parts;
}

using Parts3 = RegularTriangulation<3>::Parts;
using Parts2 = RegularTriangulation<2>::Parts;

std::string joined(const std::vector<std::string>& faults) {
  std::string text;
  for (const std::string& fault : faults) text += fault + '\n';
  return text;
}

// Sites in space with hidden and duplicate rows and a hull.
WeightedPoints spread() {
  return {
      3,
      {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8, 2, 2, 2, 5, 5, 5, 2, 2, 2, 0, 0, 0, 1, 1, 0, 9, 9, 9},
      WeightKind::weight,
      {0, 0, 0, 0, 1, 0, 0, 0, -20, 0}};
}

// What verify says when `damage` was done to the triangulation of spread().
std::string faults_after(const std::function<void(Parts3&)>& damage) {
  const WeightedPoints points = spread();
  Parts3 parts = parts_of(regular_triangulation<3>(points));
  damage(parts);
  return joined(verify(RegularTriangulation<3>(std::move(parts)), points));
}

void expect_fault(const std::string& part, const std::function<void(Parts3&)>& damage) {
  const std::string faults = faults_after(damage);
  EXPECT_NE(faults.find(part), std::string::npos) << "looked for: " << part << "\nin:\n" << faults;
}

TEST(Verify, FindsNoFaultWhereThereIsNone) {
  EXPECT_EQ(faults_after([](Parts3&) {}), "");
  const auto parts = parts_of(regular_triangulation<3>(spread()));
  ASSERT_EQ(parts.hidden, (std::vector<SiteId>{SiteId(6), SiteId(8)}));
  ASSERT_EQ(parts.duplicates, (std::vector<Duplicate>{{SiteId(7), SiteId(0)}}));
  ASSERT_GT(parts.tetrahedra.size(), 4U);
}

TEST(Verify, MissesRows) {
  expect_fault("row 6 is listed 0 times",
               [](Parts3& parts) { parts.hidden.erase(parts.hidden.begin()); });
  expect_fault("row 7 is listed 0 times", [](Parts3& parts) { parts.duplicates.clear(); });
  expect_fault("row 7 is listed 2 times", [](Parts3& parts) { parts.hidden.push_back(SiteId(7)); });
  expect_fault("row 99 does not exist", [](Parts3& parts) { parts.hidden.push_back(SiteId(99)); });
}

TEST(Verify, SeesHiddenRowsOutOfOrder) {
  expect_fault("hidden rows do not ascend",
               [](Parts3& parts) { std::swap(parts.hidden[0], parts.hidden[1]); });
}

TEST(Verify, SeesDuplicatesThatAreNone) {
  expect_fault("row 7 is not a duplicate of 1",
               [](Parts3& parts) { parts.duplicates[0].representative = SiteId(1); });
  // Equal centres, other weights.
  expect_fault("row 6 is not a duplicate of 4", [](Parts3& parts) {
    parts.hidden.erase(parts.hidden.begin());
    parts.duplicates.insert(parts.duplicates.begin(), {SiteId(6), SiteId(4)});
  });
  // The representative must be the earlier row.
  expect_fault("row 0 is not a duplicate of 7", [](Parts3& parts) {
    parts.duplicates[0] = {SiteId(0), SiteId(7)};
  });
}

TEST(Verify, SeesCornersThatAreNoVertices) {
  expect_fault("cell 1 has corners that are no vertices or repeat",
               [](Parts3& parts) { parts.tetrahedra[1].corners[3] = 1000; });
  expect_fault("cell 0 has corners that are no vertices or repeat", [](Parts3& parts) {
    parts.tetrahedra[0].corners[1] = parts.tetrahedra[0].corners[0];
  });
}

TEST(Verify, SeesCornersOutOfOrder) {
  expect_fault("cell 2 has its corners out of order", [](Parts3& parts) {
    std::swap(parts.tetrahedra[2].corners[0], parts.tetrahedra[2].corners[1]);
  });
}

TEST(Verify, SeesCellsOutOfOrder) {
  expect_fault("cell 2 is out of order",
               [](Parts3& parts) { std::swap(parts.tetrahedra[1], parts.tetrahedra[2]); });
  // The same cell twice.
  expect_fault("cell 2 is out of order",
               [](Parts3& parts) { parts.tetrahedra[2].corners = parts.tetrahedra[1].corners; });
}

TEST(Verify, SeesNeighboursThatAreNotMutual) {
  const auto each = [](const std::function<void(CellRecord<3>&, std::size_t)>& change) {
    return [change](Parts3& parts) {
      for (auto& record : parts.tetrahedra) {
        for (std::size_t i = 0; i < 4; ++i) {
          if (record.neighbours[i] != kOutside) return change(record, i);
        }
      }
    };
  };
  expect_fault("is not mutual",
               each([](CellRecord<3>& record, std::size_t i) { record.neighbours[i] = kOutside; }));
  expect_fault("is not mutual",
               each([](CellRecord<3>& record, std::size_t i) { record.neighbours[i] = 4 * 1000; }));
  expect_fault("is not mutual",
               each([](CellRecord<3>& record, std::size_t i) { record.neighbours[i] ^= 1U; }));
}

TEST(Verify, SeesNeighboursWithoutACommonFacet) {
  expect_fault("shares no facet with a neighbour", [](Parts3& parts) {
    // Two pairs of neighbours exchange partners.
    auto& cells = parts.tetrahedra;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t at = 0; at < 4 * cells.size(); ++at) {
      const std::uint32_t other = cells[at / 4].neighbours[at % 4];
      if (other != kOutside && at < other) pairs.emplace_back(at, other);
    }
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
      cells[a / 4].neighbours[a % 4] = b;
      cells[b / 4].neighbours[b % 4] = a;
    };
    join(pairs.front().first, pairs.back().second);
    join(pairs.back().first, pairs.front().second);
  });
}

TEST(Verify, SeesANegativeCell) {
  expect_fault("cell 3 is negatively oriented", [](Parts3& parts) {
    auto& cells = parts.tetrahedra;
    std::swap(cells[3].corners[2], cells[3].corners[3]);
    std::swap(cells[3].neighbours[2], cells[3].neighbours[3]);
    for (std::uint32_t i = 2; i < 4; ++i) {
      const std::uint32_t other = cells[3].neighbours[i];
      if (other != kOutside) cells[other / 4].neighbours[other % 4] = 4 * 3 + i;
    }
  });
}

TEST(Verify, SeesAFlatCell) {
  // Three sites on a line and one beside it, cut into a flat triangle and another.
  const WeightedPoints points(2, {0, 0, 1, 0, 2, 0, 0, 1}, WeightKind::none, {});
  Parts2 parts = parts_of(regular_triangulation<2>(points));
  std::vector<std::uint32_t> line;
  std::uint32_t beside = 0;
  for (std::uint32_t vertex = 0; vertex < 4; ++vertex) {
    if (parts.sites.row(vertex).row() < 3) line.push_back(vertex);
    if (parts.sites.row(vertex).row() == 3) beside = vertex;
  }
  std::sort(line.begin(), line.end());
  ASSERT_EQ(parts.triangles.size(), 2U);
  CellRecord<2> flat{{line[0], line[1], line[2]}, {kOutside, kOutside, kOutside}};
  CellRecord<2> other{{line[0], line[2], beside}, {kOutside, kOutside, kOutside}};
  std::sort(other.corners.begin(), other.corners.end());
  parts.triangles = {flat, other};
  std::sort(parts.triangles.begin(), parts.triangles.end(),
            [](auto& a, auto& b) { return a.corners < b.corners; });
  EXPECT_NE(joined(verify(RegularTriangulation<2>(std::move(parts)), points)).find("is flat"),
            std::string::npos);
}

// The cell that is last in the order is taken away, with nobody the wiser but the hull.
TEST(Verify, SeesAHoleInTheHull) {
  const std::string faults = faults_after([](Parts3& parts) {
    auto& cells = parts.tetrahedra;
    for (const std::uint32_t other : cells.back().neighbours) {
      if (other != kOutside) cells[other / 4].neighbours[other % 4] = kOutside;
    }
    cells.pop_back();
  });
  EXPECT_NE(faults, "");
}

TEST(Verify, SeesAHullThatIsNotClosed) {
  // The sides of one facet inside no longer know each other: hull triangles meet four at an edge.
  const std::string faults = faults_after([](Parts3& parts) {
    auto& cells = parts.tetrahedra;
    for (std::uint32_t at = 0; at < 4 * cells.size(); ++at) {
      const std::uint32_t other = cells[at / 4].neighbours[at % 4];
      if (other == kOutside) continue;
      cells[at / 4].neighbours[at % 4] = cells[other / 4].neighbours[other % 4] = kOutside;
      return;
    }
  });
  EXPECT_NE(faults.find("hull"), std::string::npos) << faults;
}

// The square of four sites with the wrong one of its two diagonals.
TEST(Verify, SeesAConflictAcrossAFacet) {
  const WeightedPoints points(2, {0, 0, 4, 0, 5, 5, 0, 4}, WeightKind::none, {});
  const auto right = regular_triangulation<2>(points);
  Parts2 parts = parts_of(right);
  std::vector<std::uint32_t> vertex(4);  // [row]
  for (std::uint32_t v = 0; v < 4; ++v) vertex[parts.sites.row(v).row()] = v;
  // The right cells share one diagonal; the wrong ones share the other.
  const auto has_first_diagonal = [&] {
    return std::all_of(parts.triangles.begin(), parts.triangles.end(), [&](const auto& cell) {
      const auto& corners = cell.corners;
      return std::count(corners.begin(), corners.end(), vertex[0]) +
                 std::count(corners.begin(), corners.end(), vertex[2]) ==
             2;
    });
  }();
  const std::size_t from = has_first_diagonal ? 1 : 0;
  const auto record = [&](std::size_t third) {
    // Rows go counterclockwise around the square.
    std::array<std::uint32_t, 3> cell{vertex[from], vertex[from + 2], vertex[third]};
    if (third == (from + 1) % 4) std::swap(cell[0], cell[1]);
    std::rotate(cell.begin(), std::min_element(cell.begin(), cell.end()), cell.end());
    return CellRecord<2>{cell, {kOutside, kOutside, kOutside}};
  };
  parts.triangles = {record((from + 1) % 4), record((from + 3) % 4)};
  const auto sorted = [](std::array<std::uint32_t, 3> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  if (sorted(parts.triangles[1].corners) < sorted(parts.triangles[0].corners)) {
    std::swap(parts.triangles[0], parts.triangles[1]);
  }
  std::array<std::uint32_t, 2> opposite{};  // the corner beside the diagonal
  for (std::uint32_t cell = 0; cell < 2; ++cell) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t corner = parts.triangles[cell].corners[i];
      if (corner != vertex[from] && corner != vertex[from + 2]) opposite[cell] = i;
    }
  }
  parts.triangles[0].neighbours[opposite[0]] = 4 + opposite[1];
  parts.triangles[1].neighbours[opposite[1]] = opposite[0];
  const std::string faults = joined(verify(RegularTriangulation<2>(std::move(parts)), points));
  EXPECT_NE(faults.find("is in conflict with vertex"), std::string::npos) << faults;
}

// A triangulation of some of the sites; the last one is said to be hidden but is not.
TEST(Verify, SeesAHiddenSiteThatShouldBeAVertex) {
  const std::vector<double> coordinates{0, 0, 8, 0, 0, 8, 8, 8, 3, 4};
  const WeightedPoints all(2, coordinates, WeightKind::none, {});
  const WeightedPoints some(2, {coordinates.begin(), coordinates.end() - 2}, WeightKind::none, {});
  Parts2 parts = parts_of(regular_triangulation<2>(some));
  parts.hidden = {SiteId(4)};
  EXPECT_EQ(joined(verify(RegularTriangulation<2>(std::move(parts)), all)),
            "row 4 is not hidden\n");
}

// Two triangulations side by side: each of them is regular.
TEST(Verify, SeesPiecesThatAreNotConnected) {
  const WeightedPoints points(2, {0, 0, 1, 0, 0, 1, 9, 9, 8, 9, 9, 8}, WeightKind::none, {});
  Parts2 parts = parts_of(regular_triangulation<2>(points));
  CellArray<2> kept;
  for (const auto& cell : parts.triangles) {
    const auto side = [&](std::uint32_t vertex) { return parts.sites.row(vertex).row() < 3; };
    if (side(cell.corners[0]) != side(cell.corners[1]) ||
        side(cell.corners[0]) != side(cell.corners[2])) {
      continue;
    }
    kept.push_back({cell.corners, {kOutside, kOutside, kOutside}});
  }
  ASSERT_EQ(kept.size(), 2U);
  parts.triangles = kept;
  EXPECT_EQ(joined(verify(RegularTriangulation<2>(std::move(parts)), points)),
            "the cells are not connected\n");
}

TEST(Verify, SeesTheWrongDimension) {
  expect_fault("a vertex has no cell", [](Parts3& parts) {
    parts.affine_dimension = 2;
    parts.tetrahedra.clear();
  });
  expect_fault("row 0 is listed 0 times", [](Parts3& parts) { parts = Parts3(); });
  const WeightedPoints line(2, {0, 0, 1, 1, 2, 2, 3, 3}, WeightKind::none, {});
  Parts2 parts = parts_of(regular_triangulation<2>(line));
  parts.affine_dimension = 0;
  parts.segments.clear();
  EXPECT_EQ(joined(verify(RegularTriangulation<2>(std::move(parts)), line)),
            "more than one vertex at one centre\n");
  // Triangles over sites that span a line.
  Parts2 flat = parts_of(regular_triangulation<2>(line));
  flat.affine_dimension = 2;
  flat.segments.clear();
  flat.triangles = {{{0, 1, 2}, {kOutside, kOutside, kOutside}},
                    {{1, 2, 3}, {kOutside, kOutside, kOutside}}};
  EXPECT_EQ(joined(verify(RegularTriangulation<2>(std::move(flat)), line)),
            "the sites span dimension 1\n");
}

TEST(Verify, NamesAtMostTwentyFaults) {
  const WeightedPoints points = points_of(generators::PointFamily::uniform, 3, 100, 1);
  Parts3 parts = parts_of(regular_triangulation<3>(points));
  for (auto& cell : parts.tetrahedra) cell.neighbours = {0, 0, 0, 0};
  EXPECT_EQ(verify(RegularTriangulation<3>(std::move(parts)), points).size(), 20U);
}

}  // namespace
}  // namespace orthoball
