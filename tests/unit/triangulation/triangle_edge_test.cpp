// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/triangle_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/exact/orient.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<RegularTriangulation<3>> triangulations() {
  std::vector<RegularTriangulation<3>> all;
  for (const auto& [family, count] : {std::pair{PointFamily::uniform, 150},
                                      {PointFamily::grid, 64},
                                      {PointFamily::lattice, 60},
                                      {PointFamily::cospherical, 40},
                                      {PointFamily::hidden_heavy, 80}}) {
    all.push_back(regular_triangulation<3>(
        generators::points_of(family, 3, static_cast<std::size_t>(count), 1)));
  }
  return all;
}

// Calls `check(steps, at)` for all 24 positions in every cell.
template <class Check>
void for_each_position(const RegularTriangulation<3>& triangulation, const Check& check) {
  const TriangleEdges steps(triangulation);
  std::array<std::uint8_t, 4> order{0, 1, 2, 3};
  for (std::uint32_t cell = 0; cell < triangulation.cell_count(); ++cell) {
    do {
      check(steps, TriangleEdge{cell, order[0], order[1], order[2], order[3]});
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

Edge edge_of(const TriangleEdges& steps, const TriangleEdge& at) {
  const auto vertices = steps.vertices(at);
  return std::minmax(vertices[0], vertices[1]);
}

TEST(TriangleEdges, ComeBackFromWhereTheyGo) {
  for (const auto& triangulation : triangulations()) {
    for_each_position(triangulation, [](const TriangleEdges& steps, const TriangleEdge& at) {
      const auto next = TriangleEdges::next_edge(at);
      EXPECT_EQ(TriangleEdges::next_edge(TriangleEdges::next_edge(next)), at);
      EXPECT_EQ(TriangleEdges::reversed(TriangleEdges::reversed(at)), at);
      EXPECT_EQ(TriangleEdges::other_triangle(TriangleEdges::other_triangle(at)), at);
      if (const auto other = steps.other_side(at); other.exists()) {
        EXPECT_EQ(steps.other_side(other), at);
      }
    });
  }
}

TEST(TriangleEdges, KeepWhatAStepDoesNotChange) {
  for (const auto& triangulation : triangulations()) {
    for_each_position(triangulation, [&](const TriangleEdges& steps, const TriangleEdge& at) {
      const auto [a, b, c, d] = steps.vertices(at);
      using Vertices = std::array<std::uint32_t, 4>;
      EXPECT_EQ(steps.vertices(TriangleEdges::next_edge(at)), (Vertices{b, c, a, d}));
      EXPECT_EQ(steps.vertices(TriangleEdges::reversed(at)), (Vertices{b, a, c, d}));
      EXPECT_EQ(steps.vertices(TriangleEdges::other_triangle(at)), (Vertices{a, b, d, c}));
      const auto other = steps.other_side(at);
      const auto beyond = triangulation.cells<3>()[at.cell].neighbours[at.apex];
      ASSERT_EQ(other.exists(), beyond != kOutside);
      if (!other.exists()) return;
      EXPECT_EQ(other.cell, beyond / 4);
      EXPECT_NE(steps.vertices(other)[3], d);
      const auto same = steps.vertices(other);
      EXPECT_EQ((std::array{same[0], same[1], same[2]}), (std::array{a, b, c}));
      const auto next = steps.next_triangle(TriangleEdges::other_triangle(at));
      EXPECT_EQ(next, other);
    });
  }
}

TEST(TriangleEdges, AreCounterclockwiseFromOutsideTheirCell) {
  const auto triangulation = triangulations()[0];
  const TriangleEdges steps(triangulation);
  for (std::uint32_t cell = 0; cell < triangulation.cell_count(); ++cell) {
    for (std::uint32_t facet = 0; facet < 4; ++facet) {
      const auto at = TriangleEdges::triangle(cell, facet);
      EXPECT_EQ(at.apex, facet);
      EXPECT_EQ((orient<3, 3>(triangulation.sites(), steps.vertices(at))), Sign::negative);
    }
  }
}

TEST(TriangleEdgesRing, HasEveryCellAtTheEdgeOnce) {
  for (const auto& triangulation : triangulations()) {
    std::map<Edge, std::size_t> cells_at;
    const TriangleEdges steps(triangulation);
    for_each_position(triangulation, [&](const TriangleEdges&, const TriangleEdge& at) {
      if (at.from < at.to && at.third < at.apex) ++cells_at[edge_of(steps, at)];
    });
    for_each_position(triangulation, [&](const TriangleEdges&, const TriangleEdge& at) {
      if (at.from > at.to) return;
      const auto ring = steps.ring(at);
      std::set<std::uint32_t> cells;
      for (const TriangleEdge& one : ring) {
        EXPECT_EQ(steps.vertices(one)[0], steps.vertices(at)[0]);
        EXPECT_EQ(steps.vertices(one)[1], steps.vertices(at)[1]);
        cells.insert(one.cell);
      }
      EXPECT_EQ(cells.size(), ring.size());
      EXPECT_EQ(ring.size(), cells_at[edge_of(steps, at)]);
      for (std::size_t i = 1; i < ring.size(); ++i) {
        EXPECT_EQ(steps.next_triangle(ring[i - 1]), ring[i]);
      }
      const auto after = steps.next_triangle(ring.back());
      if (after.exists()) {
        EXPECT_EQ(after, ring.front());
        EXPECT_EQ(ring.front(), at);
      } else {
        EXPECT_FALSE(steps.other_side(ring.front()).exists());
      }
    });
  }
}

// Vertices less edges plus triangles of a surface given by its triangles.
long euler_number(const TriangleEdges& steps, const std::vector<TriangleEdge>& triangles) {
  std::set<std::uint32_t> vertices;
  std::set<Edge> edges;
  for (TriangleEdge at : triangles) {
    for (int i = 0; i < 3; ++i, at = TriangleEdges::next_edge(at)) {
      vertices.insert(steps.vertices(at)[0]);
      edges.insert(edge_of(steps, at));
    }
  }
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(triangles.size());
}

TEST(TriangleEdgesHull, IsASphereThatIsWalkedFromTriangleToTriangle) {
  for (const auto& triangulation : triangulations()) {
    const TriangleEdges steps(triangulation);
    const auto hull = steps.hull();
    EXPECT_EQ(euler_number(steps, hull), 2);
    for (TriangleEdge at : hull) {
      for (int i = 0; i < 3; ++i, at = TriangleEdges::next_edge(at)) {
        EXPECT_FALSE(steps.other_side(at).exists());
        const auto next = steps.next_on_hull(at);
        EXPECT_FALSE(steps.other_side(next).exists());
        EXPECT_EQ(steps.vertices(next)[0], steps.vertices(at)[1]);
        EXPECT_EQ(steps.vertices(next)[1], steps.vertices(at)[0]);
        EXPECT_NE(next, at);
        EXPECT_EQ(steps.next_on_hull(next), at);
        // Also counterclockwise from outside.
        EXPECT_EQ((orient<3, 3>(triangulation.sites(), steps.vertices(next))), Sign::negative);
      }
    }
  }
}

TEST(TriangleEdgesLink, IsASphereInsideAndADiscOnTheHull) {
  for (const auto& triangulation : triangulations()) {
    const TriangleEdges steps(triangulation);
    std::set<std::uint32_t> on_hull;
    for (const TriangleEdge& at : steps.hull()) {
      for (std::size_t i = 0; i < 3; ++i) on_hull.insert(steps.vertices(at)[i]);
    }
    std::map<std::uint32_t, std::size_t> cells_at;
    for (const auto& cell : triangulation.cells<3>()) {
      for (const std::uint32_t vertex : cell.corners) ++cells_at[vertex];
    }
    for_each_position(triangulation, [&](const TriangleEdges&, const TriangleEdge& at) {
      if (at.to > at.third || at.third > at.apex) return;
      const std::uint32_t vertex = steps.vertices(at)[0];
      const auto link = steps.link(at);
      EXPECT_EQ(link.size(), cells_at[vertex]);
      EXPECT_EQ(euler_number(steps, link), on_hull.count(vertex) != 0 ? 1 : 2);
      for (const TriangleEdge& triangle : link) EXPECT_EQ(steps.vertices(triangle)[3], vertex);
    });
  }
}

TEST(TriangleEdges, AreNoneWhereTheSitesDoNotSpanSpace) {
  const auto triangulation =
      regular_triangulation<3>({3, {0, 0, 0, 1, 0, 0, 0, 1, 0}, WeightKind::none, {}});
  EXPECT_TRUE(TriangleEdges(triangulation).hull().empty());
}

}  // namespace
}  // namespace orthoball
