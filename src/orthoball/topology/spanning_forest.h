// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// An edge between two components of a graph. Of two joints the one with the smaller weight is
/// less, and of equal weights the one that comes first in a list.
struct Joint {
  std::uint32_t a, b, weight, edge;
};

/// A list of joints in parts, each of which one thread sees to at a time.
using JointParts = std::vector<RawVector<Joint>>;

namespace spanning_forest_detail {

inline constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

/// Where each part begins in the list, and the length of the list.
inline std::vector<std::uint32_t> begins_of(const JointParts& joints) {
  std::vector<std::uint32_t> begins{0};
  for (const auto& part : joints) {
    begins.push_back(begins.back() + static_cast<std::uint32_t>(part.size()));
  }
  return begins;
}

// Lowers a number that other threads lower, too.
inline void lower(std::uint64_t& number, std::uint64_t to) {
  const std::atomic_ref shared(number);
  std::uint64_t known = shared.load(std::memory_order_relaxed);
  while (to < known && !shared.compare_exchange_weak(known, to, std::memory_order_relaxed)) {
  }
}

// The least joint of each component, its weight in the upper half and its place in the lower.
inline RawVector<std::uint64_t> least_joints(const JointParts& joints,
                                             std::span<const std::uint32_t> begins,
                                             std::uint32_t component_count, Threads threads) {
  RawVector<std::uint64_t> least(component_count);
  parallel_parts(threads, least.size(), joints.size(),
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   std::fill(least.data() + begin, least.data() + end, kNone);
                 });
  const auto lower_all = [&](std::size_t part, const auto& lower_one) {
    std::uint64_t place = begins[part];
    for (const Joint& joint : joints[part]) {
      const std::uint64_t key = std::uint64_t{joint.weight} << 32U | place++;
      lower_one(least[joint.a], key);
      lower_one(least[joint.b], key);
    }
  };
  if (joints.size() == 1) {
    lower_all(0, [](std::uint64_t& number, std::uint64_t to) { number = std::min(number, to); });
  } else {
    parallel_for(threads, joints.size(), [&](std::size_t part) { lower_all(part, lower); });
  }
  return least;
}

}  // namespace spanning_forest_detail

/// Turns the parent of every node of a forest, itself for a root, into the number of its root;
/// roots are numbered from 0 in order. Returns their number.
/// @param nodes  [node]; fewer than 2^31.
inline std::uint32_t number_roots(RawVector<std::uint32_t>& nodes, Threads threads) {
  constexpr std::uint32_t kIsNumber = std::uint32_t{1} << 31U;  // and no parent
  const std::size_t parts = threads.count();
  const auto for_each_part = [&](std::size_t count, const auto& visit) {
    parallel_for(threads, count, [&](std::size_t part) {
      visit(part, static_cast<std::uint32_t>(nodes.size() * part / parts),
            static_cast<std::uint32_t>(nodes.size() * (part + 1) / parts));
    });
  };
  std::vector<std::uint32_t> first(parts + 1, 0);  // [part]: number of its first root
  for_each_part(parts - 1, [&](std::size_t part, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t roots = 0;
    for (std::uint32_t node = begin; node < end; ++node) roots += nodes[node] == node ? 1U : 0U;
    first[part + 1] = roots;
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  for_each_part(parts, [&](std::size_t part, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t next = first[part];
    for (std::uint32_t node = begin; node < end; ++node) {
      if (nodes[node] == node) nodes[node] = kIsNumber | next++;
    }
    if (part + 1 == parts) first[parts] = next;
  });
  // A thread follows the nodes of others and shortens the ways of its own alone: one that shortened
  // another's could put a parent where that one has just put the number.
  const auto at = [&](std::uint32_t node) { return std::atomic_ref(nodes[node]); };
  for_each_part(parts, [&](std::size_t, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t node = begin; node < end; ++node) {
      std::uint32_t ancestor = node, parent = at(node).load(std::memory_order_relaxed);
      while ((parent & kIsNumber) == 0) {
        const std::uint32_t next = at(parent).load(std::memory_order_relaxed);
        const bool is_own = ancestor - begin < end - begin;
        if (is_own) at(ancestor).store(next, std::memory_order_relaxed);  // a number, or nearer
        ancestor = parent;
        parent = next;
      }
      at(node).store(parent, std::memory_order_relaxed);
    }
  });
  for_each_part(parts, [&](std::size_t, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t node = begin; node < end; ++node) nodes[node] &= ~kIsNumber;
  });
  return first[parts];
}

/// The minimum spanning forest of a graph by Boruvka's rounds: every component takes its least
/// joint, all at once. A round is a sweep in the order of the joints, so that a graph whose edges
/// are numbered along space is read along space; sorted by weight it would be read at random.
///
/// Calls `mark(part, edge)` once for every edge of the forest, in no certain order, from several
/// threads at once with different parts, as many as `joints` has.
/// @param joints  below 2^32; freed.
/// @param component_count  below 2^32; becomes the number of trees.
/// @return [component]: the number of its tree.
/// Eight bytes a component. O(m log n) for m joints.  @cite boruvka_1926
template <class Mark>
RawVector<std::uint32_t> join(JointParts joints, std::uint32_t& component_count, Threads threads,
                              const Mark& mark) {
  const std::size_t parts = joints.size();
  RawVector<std::uint32_t> tree(component_count);
  std::iota(tree.begin(), tree.end(), 0U);
  auto begins = spanning_forest_detail::begins_of(joints);
  while (begins.back() > 0) {
    RawVector<std::uint32_t> parents(component_count);
    {
      const RawVector<std::uint64_t> least =
          spanning_forest_detail::least_joints(joints, begins, component_count, threads);
      const auto joint_at = [&](std::uint32_t place) -> const Joint& {
        std::size_t part = parts - 1;
        while (begins[part] > place) --part;
        return joints[part][place - begins[part]];
      };
      // Following least joints ends at two components that share theirs, for weights only fall.
      parallel_parts(threads, component_count, parts,
                     [&](std::size_t part, std::size_t begin, std::size_t end) {
                       for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
                         parents[c] = c;
                         if (least[c] == spanning_forest_detail::kNone) continue;
                         const Joint& joint = joint_at(static_cast<std::uint32_t>(least[c]));
                         const std::uint32_t other = joint.a ^ joint.b ^ c;
                         if (least[other] == least[c] && c < other) continue;
                         parents[c] = other;
                         mark(part, joint.edge);
                       }
                     });
    }
    component_count = number_roots(parents, threads);
    const RawVector<std::uint32_t>& number = parents;
    parallel_for(threads, parts, [&](std::size_t part) {
      RawVector<Joint>& of_part = joints[part];
      std::size_t kept = 0;
      for (const Joint& joint : of_part) {
        of_part[kept] = {number[joint.a], number[joint.b], joint.weight, joint.edge};
        kept += of_part[kept].a != of_part[kept].b ? 1U : 0U;
      }
      of_part.resize(kept);
    });
    begins = spanning_forest_detail::begins_of(joints);
    if (begins.back() > 0 || component_count > 1) {
      parallel_parts(threads, tree.size(), parts,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t c = begin; c < end; ++c) tree[c] = number[tree[c]];
                     });
    }
  }
  return tree;
}

/// The joints that `joint(i)` makes of 0..size - 1, in order, but for those between a component and
/// itself; a part for each thread.
template <class MakeJoint>
JointParts joints_of(std::uint32_t size, Threads threads, const MakeJoint& joint) {
  constexpr std::uint32_t kBlock = 4096;
  JointParts parts(threads.count());
  parallel_parts(threads, size, parts.size(),
                 [&](std::size_t part, std::size_t first, std::size_t behind) {
                   const MakeJoint own = joint;  // which no joint that is written can change
                   RawVector<Joint> joints;
                   // Most edges of triangulations that are not joined at once.
                   joints.reserve((behind - first) / 8 * 5);
                   std::size_t kept = 0;
                   for (std::size_t begin = first; begin < behind; begin += kBlock) {
                     // So that all can be written, most in vain, without a branch.
                     joints.resize(kept + kBlock);
                     const std::size_t end = std::min<std::size_t>(begin + kBlock, behind);
                     for (std::size_t i = begin; i < end; ++i) {
                       joints[kept] = own(static_cast<std::uint32_t>(i));
                       kept += joints[kept].a != joints[kept].b ? 1U : 0U;
                     }
                   }
                   joints.resize(kept);
                   parts[part] = std::move(joints);
                 });
  return parts;
}

/// The same forest of a Graph, which has
///     node_count() and edge_count(), below 2^32;
///     ends(edge): a pair of nodes, equal for an edge that joins nothing;
///     weight(edge): an integer below 2^32;
///     light_weight(): edges up to this weight are tried first. Where they connect nearly all of
///     the graph, the others are read only once.
/// Of equal weights the edge with the smaller number is less. There are as many parts as threads.
template <class Graph, class Mark>
void mark_spanning_forest(const Graph& graph, Threads threads, const Mark& mark) {
  const std::uint32_t light = graph.light_weight();
  std::uint32_t component_count = graph.node_count();
  const auto joint = [&graph, light](std::uint32_t edge) -> Joint {
    const std::uint32_t weight = graph.weight(edge);
    if (weight > light) return {0, 0, 0, 0};
    const auto [a, b] = graph.ends(edge);
    return {a, b, weight, edge};
  };
  const RawVector<std::uint32_t> component =
      join(joints_of(graph.edge_count(), threads, joint), component_count, threads, mark);
  if (component_count <= 1) return;
  const auto late_joint = [&graph, &component, light](std::uint32_t edge) -> Joint {
    const std::uint32_t weight = graph.weight(edge);
    if (weight <= light) return {0, 0, 0, 0};
    const auto [a, b] = graph.ends(edge);
    return {component[a], component[b], weight, edge};
  };
  join(joints_of(graph.edge_count(), threads, late_joint), component_count, threads, mark);
}

}  // namespace orthoball
