// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace orthoball {

/// Row number of one element in the arrays of the object that made it. Every kind of element has
/// its own type, so a cell can never index the array of sites by mistake.
template <class Tag>
class Id {
 public:
  constexpr Id() = default;  // no element
  constexpr explicit Id(std::uint32_t row) : row_(row) {}

  [[nodiscard]] constexpr std::uint32_t row() const { return row_; }
  [[nodiscard]] constexpr bool exists() const { return row_ != kNone; }
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t row_ = kNone;
};

using SiteId = Id<struct SiteTag>;      ///< an input row: a weighted point as the caller numbers it
using VertexId = Id<struct VertexTag>;  ///< a vertex, see regular_triangulation.h
using SimplexId = Id<struct SimplexTag>;  ///< a simplex of the triangulation, see simplex_table.h

}  // namespace orthoball
