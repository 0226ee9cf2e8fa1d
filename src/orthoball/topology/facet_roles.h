// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// Fewer simplices than this for each thread are done sooner by one, whatever is counted of them.
inline constexpr std::size_t kLeastSimplices = 50'000;

/// What every cell is to its facets, and which facets enter without a cell. Exact.
///
/// Of the two cells beside a facet, the first to enter, by (index, number), makes it regular and
/// the second interior. A facet that enters with its first cell, at the same index, is never
/// singular: what it adds to a sum can be added with that cell.
///
/// A byte a cell and a bit a facet; one pass over the facets.
template <int D>
class FacetRoles {
 public:
  /// Bit i of a cell: it is the second of the facet opposite corner i.
  static constexpr unsigned kIsSecond = 1;
  /// Bit i of a cell: the facet opposite corner i enters at the same index.
  static constexpr unsigned kEntersWith = 16;

  FacetRoles() = default;
  explicit FacetRoles(const Filtration<D>& filtration, Threads threads = Threads(1));

  /// [cell]: kIsSecond and kEntersWith for each of its corners.
  [[nodiscard]] std::span<const std::uint8_t> of_cells() const { return of_cells_; }
  /// Bit per facet, by its number within its dimension: it is singular at some index. Ends with a
  /// word that no facet needs.
  [[nodiscard]] std::span<const std::uint64_t> singular() const { return singular_; }
  [[nodiscard]] bool is_singular(std::uint32_t facet) const {
    return (singular_[facet / 64] >> facet % 64 & 1U) != 0;
  }

 private:
  std::vector<std::uint8_t> of_cells_;
  std::vector<std::uint64_t> singular_;  // bit per facet
};

extern template class FacetRoles<2>;  // defined in facet_roles.cpp
extern template class FacetRoles<3>;

}  // namespace orthoball
