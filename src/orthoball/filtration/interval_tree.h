// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orthoball {

/// Indices begin <= i < end at which something holds.
struct IndexInterval {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// Which of many half-open intervals contain an index.
///
/// A static interval tree in flat arrays: every interval lies at the highest node of a balanced
/// tree over the distinct begins that it contains, once in a list by begin and once in one by end.
/// Empty intervals are not stored. Immutable; any number of threads may read it.
///
/// 16 bytes an interval and 8 a distinct begin; O(n) time to build.  @cite edelsbrunner_1983
class IntervalTree {
 public:
  IntervalTree() = default;  // of no intervals
  /// @param intervals  [row]; rows are what queries give back.
  explicit IntervalTree(std::span<const IndexInterval> intervals);

  /// Number of intervals that are not empty.
  [[nodiscard]] std::size_t size() const { return by_begin_.size(); }

  /// Calls `visit(row)` for every interval with begin <= index < end, in no particular order.
  /// O(log n + k) for k of them.
  template <class Visit>
  void for_each_containing(std::uint32_t index, const Visit& visit) const;

 private:
  struct Bound {
    std::uint32_t at;
    std::uint32_t row;
  };

  // The place of the last begin <= index, from 1; 0 if there is none.
  [[nodiscard]] std::uint32_t place(std::uint32_t index) const;

  std::vector<std::uint32_t> begins_;  // [place - 1]: distinct, ascending
  std::vector<std::uint32_t> first_;   // [node]: of both lists below; nodes are places
  std::vector<Bound> by_begin_;        // within a node by begin, ascending
  std::vector<Bound> by_end_;          // within a node by end, descending
};

// One node of every height: the path down to the place of the index.
template <class Visit>
void IntervalTree::for_each_containing(std::uint32_t index, const Visit& visit) const {
  const std::uint32_t here = place(index);
  if (here == 0) return;
  const auto nodes = static_cast<std::uint32_t>(begins_.size());
  for (int height = static_cast<int>(std::bit_width(nodes)) - 1; height >= 0; --height) {
    // The node of this height whose subtree has the place.
    const std::uint32_t node = (here >> height | 1U) << height;
    if (node > nodes) continue;
    if (here < node) {  // its intervals reach beyond the index: those that have begun
      for (std::uint32_t i = first_[node]; i < first_[node + 1]; ++i) {
        if (by_begin_[i].at > index) break;
        visit(by_begin_[i].row);
      }
    } else {  // its intervals have begun: those that have not ended
      for (std::uint32_t i = first_[node]; i < first_[node + 1]; ++i) {
        if (by_end_[i].at <= index) break;
        visit(by_end_[i].row);
      }
    }
    if (here == node) break;  // nothing below contains it
  }
}

}  // namespace orthoball
