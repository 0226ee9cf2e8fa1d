// SPDX-License-Identifier: MIT
#include "orthoball/queries/edge_rings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"

namespace orthoball {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Rings = std::vector<std::vector<std::uint32_t>>;

TEST(EdgeRings, AreCutOffWhereAWalkComesBack) {
  // A triangle 0 1 2 and a square 1 3 4 5 with the vertex 1 in common.
  const std::vector<Edge> edges{{1, 2}, {0, 1}, {4, 5}, {0, 2}, {3, 4}, {1, 3}, {1, 5}};
  EXPECT_EQ(edge_rings(edges), (Rings{{0, 1, 2}, {1, 3, 4, 5}}));
  EXPECT_EQ(edge_rings({}), Rings{});
}

TEST(EdgeRings, DoNotDependOnTheOrderOfEdges) {
  std::vector<Edge> edges;  // of an octahedron; four at every vertex
  for (std::uint32_t a = 0; a < 6; ++a) {
    for (std::uint32_t b = a + 1; b < 6; ++b) {
      if (a / 2 != b / 2) edges.push_back({a, b});
    }
  }
  const Rings rings = edge_rings(edges);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Edge> other;
    for (const std::uint32_t place : generators::random_permutation(edges.size(), seed)) {
      const auto [a, b] = edges[place];
      other.push_back(seed % 2 == 0 ? Edge{a, b} : Edge{b, a});
    }
    EXPECT_EQ(edge_rings(other), rings);
  }
}

TEST(EdgeRings, HaveEveryEdgeOnceAndNoVertexTwice) {
  std::set<Edge> edges;  // the sum of some triangles
  generators::Random random(7);
  for (int i = 0; i < 300; ++i) {
    const auto a = static_cast<std::uint32_t>(random.integer(0, 39));
    const auto b = static_cast<std::uint32_t>(random.integer(0, 39));
    const auto c = static_cast<std::uint32_t>(random.integer(0, 39));
    if (a == b || b == c || a == c) continue;
    for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(a, c)}) {
      const Edge edge{std::min(v, w), std::max(v, w)};
      if (edges.erase(edge) == 0) edges.insert(edge);
    }
  }
  ASSERT_GT(edges.size(), 100U);
  std::set<Edge> found;
  for (const auto& ring : edge_rings(std::vector<Edge>(edges.begin(), edges.end()))) {
    EXPECT_GE(ring.size(), 3U);
    EXPECT_EQ(std::set<std::uint32_t>(ring.begin(), ring.end()).size(), ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t v = ring[i], w = ring[(i + 1) % ring.size()];
      EXPECT_TRUE(found.insert({std::min(v, w), std::max(v, w)}).second);
    }
  }
  EXPECT_EQ(found, edges);
}

// What takes the square of their number never ends.
TEST(EdgeRings, OfAMillionEdgesAreFound) {
  constexpr std::uint32_t kCount = 1'000'000;
  std::vector<Edge> edges;
  for (std::uint32_t v = 0; v < kCount; ++v) edges.push_back({v, (v + 1) % kCount});
  const Rings rings = edge_rings(edges);
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(rings[0].size(), kCount);
}

}  // namespace
}  // namespace orthoball
