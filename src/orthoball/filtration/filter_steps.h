// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// [k]: a number of simplices of dimension k, 0..D.
template <int D>
using ByDimension = std::array<std::uint32_t, static_cast<std::size_t>(D) + 1>;

/// The filter cut into the steps from each alpha complex to the next: which part of it enters at
/// each index, and how many simplices of each dimension. Linear in the simplices.
template <int D>
class FilterSteps {
 public:
  /// Begins at index 0, the empty complex. Keeps a reference to the filtration.
  explicit FilterSteps(const Filtration<D>& filtration) : filtration_(&filtration) {}

  /// Goes on to the next index; false, and nothing happens, behind the last.
  bool next();

  [[nodiscard]] std::uint32_t index() const { return index_; }
  /// By dimension, at index().
  [[nodiscard]] const ByDimension<D>& entering() const { return entering_; }
  /// The first position of the filter behind those of index().
  [[nodiscard]] std::size_t end() const { return end_; }

 private:
  const Filtration<D>* filtration_;
  std::uint32_t index_ = 0;
  std::size_t end_ = 0;
  ByDimension<D> entering_{};
};

extern template class FilterSteps<2>;  // defined in filter_steps.cpp
extern template class FilterSteps<3>;

}  // namespace orthoball
