// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/index_counts.h"

namespace orthoball {

/// How many simplices change their role at one index.
template <int D>
struct RoleChanges {
  ByDimension<D> entering{};
  ByDimension<D> regular{};   ///< become regular; those of dimension D - 1 and D need not be given
  ByDimension<D> interior{};  ///< become interior; those of dimension D need not be given
};

/// The numbers of simplices by role in one alpha complex. Exact.
template <int D>
class RoleCounts {
 public:
  /// Those of the empty complex, in which all simplices are exterior.
  explicit RoleCounts(const Filtration<D>& filtration) {
    for (int k = 0; k <= D; ++k) {
      total_[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(filtration.count(k));
    }
  }

  /// Goes on to another index: adds what changes at all up to it.
  void advance(const RoleChanges<D>& changes) {
    for (std::size_t k = 0; k < total_.size(); ++k) entered_[k] += changes.entering[k];
    for (std::size_t k = 0; k < total_.size(); ++k) regular_ever_[k] += changes.regular[k];
    for (std::size_t k = 0; k < total_.size(); ++k) interior_[k] += changes.interior[k];
    // Every cell makes each of its facets regular or, being the second there, interior.
    regular_ever_[D - 1] = (D + 1) * entered_[D] - interior_[D - 1];
    regular_ever_[D] = interior_[D] = entered_[D];  // a cell is interior as soon as it enters
  }

  // By dimension; the four add up to the simplices of the triangulation.

  [[nodiscard]] ByDimension<D> exterior() const { return difference(total_, entered_); }
  [[nodiscard]] ByDimension<D> singular() const { return difference(entered_, regular_ever_); }
  [[nodiscard]] ByDimension<D> regular() const { return difference(regular_ever_, interior_); }
  [[nodiscard]] const ByDimension<D>& interior() const { return interior_; }
  /// All that are not exterior.
  [[nodiscard]] const ByDimension<D>& entered() const { return entered_; }
  /// Vertices - edges + triangles - tetrahedra of the complex.
  [[nodiscard]] std::int64_t euler() const {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < entered_.size(); ++k) {
      sum += k % 2 == 0 ? std::int64_t{entered_[k]} : -std::int64_t{entered_[k]};
    }
    return sum;
  }
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

  ByDimension<D> total_{}, entered_{}, regular_ever_{}, interior_{};
};

/// When the simplices of a dimension become regular and interior: how many at each index.
///
/// Four bytes a simplex. Linear.
template <int D>
struct RoleChangeCounts {
  RoleChangeCounts() = default;
  RoleChangeCounts(const Filtration<D>& filtration, int dimension, Threads threads);

  IndexCounts regular, interior;
};

extern template struct RoleChangeCounts<2>;  // defined in role_counts.cpp
extern template struct RoleChangeCounts<3>;

}  // namespace orthoball
