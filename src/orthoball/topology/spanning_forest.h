// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "orthoball/raw_vector.h"

namespace orthoball {

/// An edge between two components of a graph. Of two joints the one with the smaller weight is
/// less, and of equal weights the one that comes first in a list.
struct Joint {
  std::uint32_t a, b, weight, edge;
};

namespace spanning_forest_detail {

inline constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

// The least joint of each component, its weight in the upper half and its place in the lower.
inline BlockVector<std::uint64_t> least_joints(const RawVector<Joint>& joints,
                                               std::uint32_t component_count) {
  BlockVector<std::uint64_t> least(component_count, kNone);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::uint64_t key = std::uint64_t{joints[i].weight} << 32U | i;
    least[joints[i].a] = std::min(least[joints[i].a], key);
    least[joints[i].b] = std::min(least[joints[i].b], key);
  }
  return least;
}

}  // namespace spanning_forest_detail

/// Turns the parent of every node of a forest, itself for a root, into the number of its root;
/// roots are numbered from 0 in order. Returns their number.
/// @param nodes  [node]; fewer than 2^31.
inline std::uint32_t number_roots(RawVector<std::uint32_t>& nodes) {
  constexpr std::uint32_t kIsNumber = std::uint32_t{1} << 31U;  // and no parent
  std::uint32_t roots = 0;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) {
    if (nodes[node] == node) nodes[node] = kIsNumber | roots++;
  }
  for (std::uint32_t node = 0; node < nodes.size(); ++node) {
    std::uint32_t ancestor = node;
    while ((nodes[ancestor] & kIsNumber) == 0) {
      const std::uint32_t parent = nodes[ancestor];
      const std::uint32_t next = nodes[parent];
      nodes[ancestor] = next;  // a number, or the parent's parent
      ancestor = parent;
    }
    nodes[node] = nodes[ancestor];
  }
  for (std::uint32_t& node : nodes) node &= ~kIsNumber;
  return roots;
}

/// The minimum spanning forest of a graph by Boruvka's rounds: every component takes its least
/// joint, all at once. A round is a sweep in the order of the joints, so that a graph whose edges
/// are numbered along space is read along space; sorted by weight it would be read at random.
///
/// Calls `mark(edge)` once for every edge of the forest, in no certain order.
/// @param joints  below 2^32; freed.
/// @param component_count  below 2^32; becomes the number of trees.
/// @return [component]: the number of its tree.
/// Eight bytes a component. O(m log n) for m joints.  @cite boruvka_1926
template <class Mark>
RawVector<std::uint32_t> join(RawVector<Joint> joints, std::uint32_t& component_count,
                              const Mark& mark) {
  RawVector<std::uint32_t> tree(component_count);
  std::iota(tree.begin(), tree.end(), 0U);
  while (!joints.empty()) {
    RawVector<std::uint32_t> parents(component_count);
    {
      const BlockVector<std::uint64_t> least =
          spanning_forest_detail::least_joints(joints, component_count);
      // Following least joints ends at two components that share theirs, for weights only fall.
      for (std::uint32_t c = 0; c < component_count; ++c) {
        parents[c] = c;
        if (least[c] == spanning_forest_detail::kNone) continue;
        const Joint& joint = joints[static_cast<std::uint32_t>(least[c])];
        const std::uint32_t other = joint.a ^ joint.b ^ c;
        if (least[other] == least[c] && c < other) continue;
        parents[c] = other;
        mark(joint.edge);
      }
    }
    component_count = number_roots(parents);
    const RawVector<std::uint32_t>& number = parents;
    std::size_t kept = 0;
    for (const Joint& joint : joints) {
      joints[kept] = {number[joint.a], number[joint.b], joint.weight, joint.edge};
      kept += joints[kept].a != joints[kept].b ? 1U : 0U;
    }
    joints.resize(kept);
    if (!joints.empty() || component_count > 1) {
      for (std::uint32_t& c : tree) c = number[c];
    }
  }
  return tree;
}

/// The joints that `joint(i)` makes of 0..size - 1, in order, but for those between a component and
/// itself.
template <class MakeJoint>
RawVector<Joint> joints_of(std::uint32_t size, const MakeJoint& joint) {
  constexpr std::uint32_t kBlock = 4096;
  RawVector<Joint> joints;
  joints.reserve(std::size_t{size} / 8 *
                 5);  // most edges of triangulations that are not joined at once
  std::size_t kept = 0;
  for (std::uint32_t begin = 0; begin < size; begin += kBlock) {
    joints.resize(kept + kBlock);  // so that all can be written, most in vain, without a branch
    const std::uint32_t end = begin + std::min(kBlock, size - begin);
    for (std::uint32_t i = begin; i < end; ++i) {
      joints[kept] = joint(i);
      kept += joints[kept].a != joints[kept].b ? 1U : 0U;
    }
  }
  joints.resize(kept);
  return joints;
}

/// The same forest of a Graph, which has
///     node_count() and edge_count(), below 2^32;
///     ends(edge): a pair of nodes, equal for an edge that joins nothing;
///     weight(edge): an integer below 2^32;
///     light_weight(): edges up to this weight are tried first. Where they connect nearly all of
///     the graph, the others are read only once.
/// Of equal weights the edge with the smaller number is less.
template <class Graph, class Mark>
void mark_spanning_forest(const Graph& graph, const Mark& mark) {
  const std::uint32_t light = graph.light_weight();
  std::uint32_t component_count = graph.node_count();
  const auto joint = [&](std::uint32_t edge) -> Joint {
    const std::uint32_t weight = graph.weight(edge);
    if (weight > light) return {0, 0, 0, 0};
    const auto [a, b] = graph.ends(edge);
    return {a, b, weight, edge};
  };
  const RawVector<std::uint32_t> component =
      join(joints_of(graph.edge_count(), joint), component_count, mark);
  if (component_count <= 1) return;
  const auto late_joint = [&](std::uint32_t edge) -> Joint {
    const std::uint32_t weight = graph.weight(edge);
    if (weight <= light) return {0, 0, 0, 0};
    const auto [a, b] = graph.ends(edge);
    return {component[a], component[b], weight, edge};
  };
  join(joints_of(graph.edge_count(), late_joint), component_count, mark);
}

}  // namespace orthoball
