// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// The filter of a filtration: all simplices in the order in which they appear, of which every
/// prefix is a complex and some prefixes are the alpha complexes.
///
/// Exact, and the same on any number of threads. Refers to the filtration, which must outlive it.
/// Immutable; any number of threads may read it.
///
/// 4 bytes a simplex, 116 a site in space; while it is made, 2 more a simplex, or 6 where there are
/// few indices. Linear time.
template <int D>
class Filter {
 public:
  explicit Filter(const Filtration<D>& filtration, Threads threads = {});
  explicit Filter(const Filtration<D>&& filtration, Threads threads = {}) = delete;

  [[nodiscard]] const Filtration<D>& filtration() const { return *filtration_; }

  /// [position]: all simplices by (enters, dimension, number).
  [[nodiscard]] std::span<const SimplexId> simplices() const { return simplices_; }
  /// Whether the simplex at a position, from 0, is the first to enter at its index. True of the
  /// position behind the last.
  [[nodiscard]] bool starts_index(std::size_t position) const {
    return position == 0 || position == simplices_.size() ||
           filtration_->enters(simplices_[position]) !=
               filtration_->enters(simplices_[position - 1]);
  }
  /// Length of the prefix that is K_index. O(log n).
  [[nodiscard]] std::size_t complex_size(std::uint32_t index) const;
  /// simplices() with ties (equal index and dimension) in ascending order of their rows: the order
  /// of all tables that people see. O(n log n).
  [[nodiscard]] std::vector<SimplexId> by_rows() const;

 private:
  const Filtration<D>* filtration_;
  RawVector<SimplexId> simplices_;
};

extern template class Filter<2>;  // defined in filter.cpp
extern template class Filter<3>;

}  // namespace orthoball
