// SPDX-License-Identifier: MIT
//
// The tree is implicit in the binary numbers of its nodes 1..m, the places of the distinct begins:
// a node with h trailing zeros has height h, and the node above any set of consecutive places is
// the one among them with the most trailing zeros. So an interval's node is found in O(1), and a
// query visits one node for each bit.
//
// Edelsbrunner. A new approach to rectangle intersections. Int. J. Computer Math. 13 (1983).
#include "orthoball/filtration/interval_tree.h"

#include <algorithm>
#include <utility>

#include "orthoball/radix_sort.h"
#include "orthoball/raw_vector.h"

namespace orthoball {
namespace {

// The number with the most trailing zeros in first..last, 1 <= first <= last.
std::uint32_t highest_node(std::uint32_t first, std::uint32_t last) {
  const unsigned height = static_cast<unsigned>(std::bit_width((first - 1) ^ last)) - 1;
  return last >> height << height;
}

}  // namespace

IntervalTree::IntervalTree(std::span<const IndexInterval> intervals) {
  RawVector<KeyedRow> order;
  for (std::uint32_t row = 0; row < intervals.size(); ++row) {
    if (intervals[row].begin < intervals[row].end) order.push_back({intervals[row].begin, row});
  }
  radix_sort(order);
  for (const KeyedRow& next : order) {
    const auto begin = static_cast<std::uint32_t>(next.key);
    if (begins_.empty() || begins_.back() != begin) begins_.push_back(begin);
  }

  const auto node_of = [&](const IndexInterval& interval) {
    return highest_node(place(interval.begin), place(interval.end - 1));
  };
  std::vector<std::uint32_t> nodes(intervals.size());
  first_.assign(begins_.size() + 2, 0);
  for (const KeyedRow& next : order) {
    nodes[next.row] = node_of(intervals[next.row]);
    ++first_[nodes[next.row]];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& count : first_) sum += std::exchange(count, sum);

  // Two stable distributions to the nodes: of the rows by begin, then of the rows by end.
  std::vector<std::uint32_t> next_place = first_;
  by_begin_.resize(order.size());
  for (const KeyedRow& next : order) {
    by_begin_[next_place[nodes[next.row]]++] = {static_cast<std::uint32_t>(next.key), next.row};
  }
  for (KeyedRow& next : order) next.key = intervals[next.row].end;
  radix_sort(order);
  next_place = first_;
  by_end_.resize(order.size());
  for (auto next = order.rbegin(); next != order.rend(); ++next) {
    by_end_[next_place[nodes[next->row]]++] = {static_cast<std::uint32_t>(next->key), next->row};
  }
}

std::uint32_t IntervalTree::place(std::uint32_t index) const {
  return static_cast<std::uint32_t>(std::upper_bound(begins_.begin(), begins_.end(), index) -
                                    begins_.begin());
}

}  // namespace orthoball
