// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "orthoball/filtration/filter_steps.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/index_counts.h"

namespace orthoball {

/// The numbers of simplices by role in the alpha complexes of a filtration, one after the other.
///
/// Exact. Linear in the simplices; four bytes for each below D - 1 and two for each facet.
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
  std::array<IndexCounts, std::size_t{D} - 1> becoming_regular_;
  std::array<IndexCounts, std::size_t{D}> becoming_interior_;
};

extern template class RoleCounts<2>;  // defined in role_counts.cpp
extern template class RoleCounts<3>;

}  // namespace orthoball
