// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "orthoball/exact/sites.h"

namespace orthoball {

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
    result.kind_ = Kind::numbers;
    result.begin_ = begin;
    result.size_ = end - begin;
    result.infinity_ = infinity;
    return result;
  }
  /// The vertices with a coordinate in [low, high). Keeps a reference.
  [[nodiscard]] static Territory of_slab(const Sites<D>& sites, std::size_t axis, double low,
                                         double high, std::uint32_t infinity) {
    Territory result;
    result.kind_ = Kind::slab;
    result.sites_ = &sites;
    result.axis_ = axis;
    result.low_ = low;
    result.high_ = high;
    result.infinity_ = infinity;
    return result;
  }

  [[nodiscard]] bool is_whole() const { return kind_ == Kind::whole; }
  [[nodiscard]] bool has(std::uint32_t vertex) const {
    if (vertex == infinity_) return A == 3;
    if (kind_ == Kind::numbers) return vertex - begin_ < size_;
    if (kind_ == Kind::whole) return true;
    const double x = (*sites_)[vertex].x[axis_];
    return low_ <= x && x < high_;
  }

 private:
  enum class Kind { whole, numbers, slab };
  Territory() = default;

  Kind kind_ = Kind::whole;
  std::uint32_t begin_ = 0, size_ = 0;
  std::uint32_t infinity_ = std::numeric_limits<std::uint32_t>::max();
  const Sites<D>* sites_ = nullptr;
  std::size_t axis_ = 0;
  double low_ = 0.0, high_ = 0.0;
};

}  // namespace orthoball
