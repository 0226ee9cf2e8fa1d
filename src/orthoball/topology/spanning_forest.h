// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace orthoball {

namespace spanning_forest_detail {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// The least edge of every component so far.
struct LeastEdges {
  std::vector<std::uint32_t> weight, edge;  // [component]; kNone for none

  explicit LeastEdges(std::size_t components)
      : weight(components, kNone), edge(components, kNone) {}

  void offer(std::uint32_t component, std::uint32_t candidate, std::uint32_t candidate_weight) {
    const bool is_less = candidate_weight < weight[component];
    weight[component] = is_less ? candidate_weight : weight[component];
    edge[component] = is_less ? candidate : edge[component];
  }
};

// Joins every component with the one across its least edge. Returns the new number of each.
// Following least edges ends at two components that share theirs, for weights only fall.
template <class OtherEnd, class Mark>
std::vector<std::uint32_t> joined(LeastEdges least, std::uint32_t& component_count,
                                  const OtherEnd& other_end, const Mark& mark) {
  constexpr std::uint32_t kIsRoot = std::uint32_t{1} << 31U;  // then the rest is its new number
  std::vector<std::uint32_t>& parent = least.weight;
  component_count = 0;
  for (std::uint32_t c = 0; c < parent.size(); ++c) {
    const std::uint32_t edge = least.edge[c];
    const std::uint32_t other = edge == kNone ? c : other_end(edge, c);
    const bool is_root = other == c || (least.edge[other] == edge && c < other);
    parent[c] = is_root ? kIsRoot | component_count++ : other;
    if (!is_root) mark(edge);
  }
  std::vector<std::uint32_t>& label = least.edge;
  for (std::uint32_t c = 0; c < parent.size(); ++c) {
    std::uint32_t root = c;
    while ((parent[root] & kIsRoot) == 0) {
      const std::uint32_t next = parent[root];
      if ((parent[next] & kIsRoot) == 0) parent[root] = parent[next];
      root = next;
    }
    label[c] = parent[root] & ~kIsRoot;
  }
  return std::move(label);
}

// An edge between two components.
struct Joint {
  std::uint32_t a, b, edge;
};

// The steps of mark_spanning_forest.
template <class Graph, class Mark>
class Builder {
 public:
  Builder(const Graph& graph, const Mark& mark) : graph_(graph), mark_(mark) {}

  void build() {
    const std::uint32_t light = graph_.light_weight();
    join_nodes(light);
    gather_joints(0, light);
    join_joints();
    if (component_count_ == 1 || light == kNone) return;
    gather_joints(light + 1, kNone);
    join_joints();
  }

 private:
  // The first round, among the edges up to a weight.
  void join_nodes(std::uint32_t light) {
    LeastEdges least(graph_.node_count());
    for (std::uint32_t edge = 0; edge < graph_.edge_count(); ++edge) {
      const std::uint32_t weight = graph_.weight(edge);
      if (weight > light) continue;
      const auto [a, b] = graph_.ends(edge);
      if (a == b) continue;
      least.offer(a, edge, weight);
      least.offer(b, edge, weight);
    }
    const auto other_end = [&](std::uint32_t edge, std::uint32_t node) {
      const auto [a, b] = graph_.ends(edge);
      return a == node ? b : a;
    };
    component_ = joined(std::move(least), component_count_, other_end, mark_);
  }

  // The edges of these weights that join two components, ascending.
  void gather_joints(std::uint32_t least_weight, std::uint32_t largest_weight) {
    constexpr std::uint32_t kBlock = 4096;
    joints_.reserve(graph_.edge_count() / 2);
    std::size_t size = 0;
    for (std::uint32_t begin = 0; begin < graph_.edge_count(); begin += kBlock) {
      joints_.resize(size + kBlock);  // so that all can be written, most in vain, without a branch
      const std::uint32_t end = begin + std::min(kBlock, graph_.edge_count() - begin);
      for (std::uint32_t edge = begin; edge < end; ++edge) {
        const std::uint32_t weight = graph_.weight(edge);
        if (weight < least_weight || weight > largest_weight) continue;
        const auto [a, b] = graph_.ends(edge);
        joints_[size] = {component_[a], component_[b], edge};
        size += component_[a] != component_[b] ? 1U : 0U;
      }
    }
    joints_.resize(size);
  }

  // Rounds until no joint joins two components.
  void join_joints() {
    std::vector<std::uint32_t> final_number(component_count_);
    std::iota(final_number.begin(), final_number.end(), 0U);
    while (!joints_.empty()) {
      LeastEdges least(component_count_);
      for (std::uint32_t i = 0; i < joints_.size(); ++i) {
        const std::uint32_t weight = graph_.weight(joints_[i].edge);
        least.offer(joints_[i].a, i, weight);
        least.offer(joints_[i].b, i, weight);
      }
      const std::vector<std::uint32_t> number = joined(
          std::move(least), component_count_,
          [&](std::uint32_t i, std::uint32_t c) { return joints_[i].a ^ joints_[i].b ^ c; },
          [&](std::uint32_t i) { mark_(joints_[i].edge); });
      std::size_t kept = 0;
      for (const Joint& joint : joints_) {
        joints_[kept] = {number[joint.a], number[joint.b], joint.edge};
        kept += joints_[kept].a != joints_[kept].b ? 1U : 0U;
      }
      joints_.resize(kept);
      for (std::uint32_t& c : final_number) c = number[c];
    }
    if (component_count_ == 1) return;  // nothing is left to join
    for (std::uint32_t& c : component_) c = final_number[c];
  }

  const Graph& graph_;
  const Mark& mark_;
  std::uint32_t component_count_ = 0;
  std::vector<std::uint32_t> component_;  // [node]
  std::vector<Joint> joints_;             // ascending
};

}  // namespace spanning_forest_detail

/// The minimum spanning forest of a graph by Boruvka's rounds: every component takes its least edge
/// to another, all at once. A round is a sweep in the order of the edges, so that a graph whose
/// edges are numbered along space is read along space; sorted by weight it would be read at random.
///
/// Calls `mark(edge)` once for every edge of the forest, in no certain order. Of equal weights the
/// edge with the smaller number is less. A Graph has
///     node_count(), below 2^31, and edge_count();
///     ends(edge): a pair of nodes, equal for an edge that joins nothing;
///     weight(edge): an integer below 2^32 - 1;
///     light_weight(): edges up to this weight are tried first. Where they connect nearly all of
///     the graph, the others are read only once or twice more.
///
/// Eight bytes a node, then twelve for every edge that neither is the least of a node nor joins two
/// of one component after the first round. O(m log n) for m edges.  @cite boruvka_1926
template <class Graph, class Mark>
void mark_spanning_forest(const Graph& graph, const Mark& mark) {
  spanning_forest_detail::Builder<Graph, Mark>(graph, mark).build();
}

}  // namespace orthoball
