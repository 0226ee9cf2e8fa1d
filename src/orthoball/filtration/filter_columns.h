// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// A prefix of the filter of a filtration as columns, one entry a simplex, in the order of all
/// tables that people see: by index, dimension and rows, as Filter::by_rows().
///
/// Exact but for alpha2, correctly rounded; the same on any number of threads. Refers to the
/// filtration, which must outlive it. Immutable; any number of threads may read it. In space 25
/// bytes a simplex, and as many more in the longest stretch while it is made. Linear time but for
/// ties.
template <int D>
class FilterColumns {
 public:
  /// @param index  of the alpha complex that the prefix is; at most the spectrum's size.
  FilterColumns(const Filtration<D>& filtration, std::uint32_t index, Threads threads = {});
  FilterColumns(const Filtration<D>&& filtration, std::uint32_t index,
                Threads threads = {}) = delete;

  [[nodiscard]] std::size_t size() const { return simplices_.size(); }
  /// [position]
  [[nodiscard]] std::span<const SimplexId> simplices() const { return simplices_; }
  /// [position]: 0..D.
  [[nodiscard]] std::span<const std::uint8_t> dimensions() const { return dimensions_; }
  /// [(D + 1) * position + i]: input rows of the vertices, ascending, then none.
  [[nodiscard]] std::span<const SiteId> rows() const {
    return {rows_.empty() ? nullptr : rows_[0].data(), (std::size_t{D} + 1) * rows_.size()};
  }
  /// [position]: indices of the spectrum, never decreasing.
  [[nodiscard]] std::span<const std::uint32_t> enters() const { return enters_; }

  // Made when asked for.

  /// [position]: the label of enters; length^2.
  [[nodiscard]] RawVector<double> alpha2(Threads threads = {}) const;
  /// [position]: indices of the spectrum, its size plus 1 for never.
  [[nodiscard]] RawVector<std::uint32_t> regular(Threads threads = {}) const;
  [[nodiscard]] RawVector<std::uint32_t> interior(Threads threads = {}) const;

 private:
  const Filtration<D>* filtration_;
  RawVector<SimplexId> simplices_;
  RawVector<std::uint8_t> dimensions_;
  RawVector<std::array<SiteId, std::size_t{D} + 1>> rows_;
  RawVector<std::uint32_t> enters_;
};

extern template class FilterColumns<2>;  // defined in filter_columns.cpp
extern template class FilterColumns<3>;

}  // namespace orthoball
