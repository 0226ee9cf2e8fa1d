// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filter_steps.h"
#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// How often each index occurs in a list, read in ascending order. One byte an index and four for
/// every 256 occurrences: an index occurs a few times where there are many of them.
class IndexHistogram {
 public:
  IndexHistogram() = default;
  /// For indices 0..largest.
  explicit IndexHistogram(std::uint32_t largest) : counts_(std::size_t{largest} + 1, 0) {}

  void add(std::uint32_t index) {
    if (++counts_[index] == 0) carries_.push_back(index);
  }
  /// To be called once between the last `add` and the first `count`.
  void finish() { std::sort(carries_.begin(), carries_.end()); }
  /// Occurrences of `index`; calls must ascend.
  [[nodiscard]] std::uint32_t count(std::uint32_t index) {
    std::uint32_t total = counts_[index];
    for (; next_carry_ < carries_.size() && carries_[next_carry_] == index; ++next_carry_) {
      total += 256;
    }
    return total;
  }

 private:
  std::vector<std::uint8_t> counts_;    // [index], modulo 256
  std::vector<std::uint32_t> carries_;  // the index whose count has overflowed, once each time
  std::size_t next_carry_ = 0;
};

/// The numbers of simplices by role in the alpha complexes of a filtration, one after the other.
///
/// Exact. Linear in the simplices; 2 D bytes an index of the spectrum.
template <int D>
class RoleCounts {
 public:
  /// Begins with the empty complex, in which all simplices are exterior.
  explicit RoleCounts(const Filtration<D>& filtration);

  /// Goes on to the next index, at which `entering` simplices join.
  void advance(const ByDimension<D>& entering);

  // By dimension; the four add up to the simplices of the triangulation.

  [[nodiscard]] ByDimension<D> exterior() const { return difference(total_, entered_); }
  [[nodiscard]] ByDimension<D> singular() const { return difference(entered_, regular_ever_); }
  [[nodiscard]] ByDimension<D> regular() const { return difference(regular_ever_, interior_); }
  [[nodiscard]] const ByDimension<D>& interior() const { return interior_; }
  /// Vertices - edges + triangles - tetrahedra of the complex.
  [[nodiscard]] std::int64_t euler() const;
  /// All vertices of the triangulation are in the complex.
  [[nodiscard]] bool has_all_vertices() const { return entered_[0] == total_[0]; }
  /// Every simplex of the complex is the face of a cell in it.
  [[nodiscard]] bool has_no_singular() const { return entered_ == regular_ever_; }

 private:
  static ByDimension<D> difference(const ByDimension<D>& a, const ByDimension<D>& b) {
    ByDimension<D> result;
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = a[k] - b[k];
    return result;
  }

  std::uint32_t index_ = 0;
  ByDimension<D> total_{}, entered_{}, regular_ever_{}, interior_{};
  std::array<IndexHistogram, static_cast<std::size_t>(D)> becoming_regular_, becoming_interior_;
};

extern template class RoleCounts<2>;  // defined in role_counts.cpp
extern template class RoleCounts<3>;

}  // namespace orthoball
