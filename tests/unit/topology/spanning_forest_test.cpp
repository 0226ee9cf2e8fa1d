// SPDX-License-Identifier: MIT
#include "orthoball/topology/spanning_forest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

struct Edge {
  std::uint32_t a, b, weight;
};

struct Graph {
  std::uint32_t nodes;
  std::vector<Edge> edges;
  std::uint32_t light;

  [[nodiscard]] std::uint32_t node_count() const { return nodes; }
  [[nodiscard]] std::uint32_t edge_count() const {
    return static_cast<std::uint32_t>(edges.size());
  }
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t i) const {
    return {edges[i].a, edges[i].b};
  }
  [[nodiscard]] std::uint32_t weight(std::uint32_t i) const { return edges[i].weight; }
  [[nodiscard]] std::uint32_t light_weight() const { return light; }
};

std::vector<std::uint32_t> forest(const Graph& graph, unsigned threads = 1) {
  std::vector<std::vector<std::uint32_t>> of_parts(threads);
  mark_spanning_forest(graph, Threads(threads), [&](std::size_t part, std::uint32_t edge) {
    of_parts[part].push_back(edge);
  });
  std::vector<std::uint32_t> marked;
  for (const auto& part : of_parts) marked.insert(marked.end(), part.begin(), part.end());
  std::sort(marked.begin(), marked.end());
  return marked;
}

// One edge after the other by (weight, number), each taken that joins two components.
std::vector<std::uint32_t> forest_by_weight(const Graph& graph) {
  std::vector<std::uint32_t> order(graph.edges.size()), taken;
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return graph.edges[i].weight < graph.edges[j].weight;
  });
  UnionFind components(graph.nodes);
  for (const std::uint32_t i : order) {
    if (components.unite(graph.edges[i].a, graph.edges[i].b)) taken.push_back(i);
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

TEST(SpanningForest, OfNoEdgesIsEmpty) {
  EXPECT_TRUE(forest({0, {}, 0}).empty());
  EXPECT_TRUE(forest({3, {}, 0}).empty());
  EXPECT_TRUE(forest({2, {{1, 1, 5}}, 9}).empty());
}

TEST(SpanningForest, TakesTheFirstOfEqualEdges) {
  EXPECT_EQ(forest({2, {{0, 1, 4}, {1, 0, 4}}, 9}), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(forest({3, {{0, 1, 1}, {1, 2, 1}, {2, 0, 1}}, 9}), (std::vector<std::uint32_t>{0, 1}));
}

TEST(SpanningForest, IsThatOfTakingEdgesByWeight) {
  std::mt19937 random(3);
  const auto below = [&](std::uint32_t bound) {
    return static_cast<std::uint32_t>(random() % bound);
  };
  for (int round = 0; round < 400; ++round) {
    const std::uint32_t nodes = 1 + below(60);
    const std::uint32_t largest = below(2) == 0 ? 4 : 1000;  // many ties, or few
    Graph graph{nodes, {}, below(largest + 1)};
    for (std::uint32_t i = below(4 * nodes); i-- > 0;) {
      graph.edges.push_back({below(nodes), below(nodes), below(largest)});
    }
    ASSERT_EQ(forest(graph), forest_by_weight(graph)) << round;
    ASSERT_EQ(forest(graph, 3), forest_by_weight(graph)) << round;
  }
}

TEST(SpanningForest, OfManyThreadsIsTheSame) {
  std::mt19937 random(5);
  const std::uint32_t nodes = 20000;
  Graph graph{nodes, {}, 300};
  for (std::uint32_t i = 0; i < 5 * nodes; ++i) {  // mostly between neighbours, with many ties
    const auto a = static_cast<std::uint32_t>(random() % nodes);
    const auto b = static_cast<std::uint32_t>((a + random() % 50) % nodes);
    graph.edges.push_back({a, b, static_cast<std::uint32_t>(random() % 1000)});
  }
  const auto expected = forest_by_weight(graph);
  for (const unsigned threads : {1U, 2U, 5U, 16U}) ASSERT_EQ(forest(graph, threads), expected);
}

}  // namespace
}  // namespace orthoball
