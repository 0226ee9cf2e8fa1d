// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"

namespace orthoball {

/// The simplices of one dimension, by number among these, with the keys that order them as the
/// filter does: (enters, number). A view; refers to the filtration.
class KeyedSimplices {
 public:
  template <int D>
  KeyedSimplices(const Filtration<D>& filtration, int dimension)
      : first_(filtration.table().first(dimension)),
        enters_(filtration.enters().subspan(first_, filtration.count(dimension))) {}

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(enters_.size()); }
  [[nodiscard]] std::uint32_t enters(std::uint32_t number) const { return enters_[number]; }
  /// The index in the upper half, the number in the lower.
  [[nodiscard]] std::uint64_t key(std::uint32_t number) const {
    return std::uint64_t{enters_[number]} << 32U | number;
  }
  [[nodiscard]] SimplexId id(std::uint32_t number) const { return SimplexId(first_ + number); }
  [[nodiscard]] std::uint32_t number(SimplexId simplex) const { return simplex.row() - first_; }

 private:
  std::uint32_t first_;
  std::span<const std::uint32_t> enters_;
};

}  // namespace orthoball
