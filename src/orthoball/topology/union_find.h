// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace orthoball {

/// Disjoint sets over the numbers 0..size-1, all apart at first.
///
/// Four bytes a number. Any sequence of m operations costs O(m log n); in practice a few steps
/// each. The smallest number of a set represents it, so the result never depends on the order in
/// which sets were joined.  @cite tarjan_van_leeuwen_1984
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size), set_count_(size) {
    for (std::size_t i = 0; i < size; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  /// The smallest number in the set of `element`. Shortens paths, so it is not const.
  [[nodiscard]] std::uint32_t find(std::uint32_t element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }

  /// Joins two sets; false if they were one already.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    --set_count_;
    return true;
  }

  /// Number of disjoint sets left.
  [[nodiscard]] std::size_t set_count() const { return set_count_; }

 private:
  std::vector<std::uint32_t> parent_;  // [element], itself for the smallest of a set
  std::size_t set_count_;
};

}  // namespace orthoball
