// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "orthoball/exact/sites.h"

namespace orthoball {

/// The points with low <= x < high on every axis.
template <int D>
struct Box {
  std::array<double, std::size_t{D}> low;   ///< [axis]
  std::array<double, std::size_t{D}> high;  ///< [axis]

  /// All points.
  [[nodiscard]] static Box whole() {
    Box box{};
    box.low.fill(-std::numeric_limits<double>::infinity());
    box.high.fill(std::numeric_limits<double>::infinity());
    return box;
  }
  /// Whether a site is in it.
  [[nodiscard]] bool has(const Site<D>& site) const {
    bool all = true;
    for (std::size_t axis = 0; axis < D; ++axis) {
      all &= (low[axis] <= site.x[axis]) & (site.x[axis] < high[axis]);
    }
    return all;
  }
};

/// A set of vertices; a thread changes only cells that have all their corners in its own, disjoint
/// from those of others. The vertex at infinity is in all territories of a triangulation of
/// tetrahedra, in none of one of triangles, whose cells at infinity share too few other vertices.
///
/// Two cells that share a facet share at least two finite corners in any territory that one of them
/// lies in, and three corners are enough to have one of these. So no other thread owns the
/// neighbour of a thread's cell, the cell behind it, or any facet of it: a thread may read the
/// neighbours of its cells and write to them without locks.
template <int A, int D>
class Territory {
 public:
  /// All vertices.
  [[nodiscard]] static Territory whole() { return Territory(); }
  /// The vertices begin..end - 1.
  [[nodiscard]] static Territory of_numbers(std::uint32_t begin, std::uint32_t end,
                                            std::uint32_t infinity) {
    Territory result;
    result.begin_ = begin;
    result.size_ = end - begin;
    result.infinity_ = infinity;
    return result;
  }
  /// The vertices in a box. Keeps a reference to the sites.
  [[nodiscard]] static Territory of_box(const Sites<D>& sites, const Box<D>& box,
                                        std::uint32_t infinity) {
    Territory result;
    result.size_ = 0;
    result.sites_ = &sites;
    result.box_ = box;
    result.infinity_ = infinity;
    return result;
  }

  [[nodiscard]] bool is_whole() const { return size_ == kAll; }
  [[nodiscard]] bool has(std::uint32_t vertex) const {
    return has_at_once(vertex) ||
           (vertex == infinity_ ? A == 3 : sites_ != nullptr && box_.has((*sites_)[vertex]));
  }
  /// What one comparison tells: most of what a territory of numbers has, nothing of a box.
  [[nodiscard]] bool has_at_once(std::uint32_t vertex) const { return vertex - begin_ < size_; }

 private:
  static constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();
  Territory() = default;

  std::uint32_t begin_ = 0, size_ = kAll;  // no numbers in a box
  std::uint32_t infinity_ = kAll;
  const Sites<D>* sites_ = nullptr;  // of a box
  Box<D> box_{};
};

}  // namespace orthoball
