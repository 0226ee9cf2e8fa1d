// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// What tables say of one simplex.
template <int D>
struct FilterLine {
  std::array<std::uint32_t, std::size_t{D} + 1> rows{};  ///< of the vertices, ascending
  std::uint32_t dimension = 0;                           ///< rows in use, less one
  std::uint32_t enters = 0;                              ///< indices of the spectrum
  std::uint32_t regular = 0;
  std::uint32_t interior = 0;
};

/// Gathers the lines of simplices that are in the order of the filter.
///
/// Neighbours in the filter lie anywhere in memory. Many simplices are therefore looked up at once,
/// dimension by dimension in loops whose turns do not wait for each other: several times as fast as
/// one by one. Refers to the filtration, and is used by one thread.
template <int D>
class FilterLines {
 public:
  /// As many simplices as can be asked for at once.
  static constexpr std::size_t kMost = 1024;

  explicit FilterLines(const Filtration<D>& filtration) : filtration_(filtration), lines_(kMost) {}

  /// [i]: the line of simplices[i]. Valid until the next call.
  [[nodiscard]] std::span<const FilterLine<D>> lines(std::span<const SimplexId> simplices);

 private:
  template <int Dimension>
  void gather(std::span<const SimplexId> simplices);

  const Filtration<D>& filtration_;
  std::vector<FilterLine<D>> lines_;
  std::array<std::vector<std::uint32_t>, std::size_t{D} + 1> places_;  // by dimension
};

/// Calls `use` with the lines of many simplices, piece by piece in order.
template <int D, class Use>
void for_filter_lines(const Filtration<D>& filtration, std::span<const SimplexId> simplices,
                      const Use& use) {
  FilterLines<D> lines(filtration);
  while (!simplices.empty()) {
    const std::size_t count = std::min(simplices.size(), FilterLines<D>::kMost);
    use(lines.lines(simplices.first(count)));
    simplices = simplices.subspan(count);
  }
}

extern template class FilterLines<2>;  // defined in filter_lines.cpp
extern template class FilterLines<3>;

}  // namespace orthoball
