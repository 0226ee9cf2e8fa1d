// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/topology/facet_roles.h"

namespace orthoball {

/// Vertices of a cell, which are its facets as well.
template <int D>
inline constexpr std::size_t kCorners = static_cast<std::size_t>(D) + 1;

/// What a cell adds to the measures of a complex when it enters, together with the facets that
/// enter with it because they are never singular.
struct CellTerms {
  double volume = 0.0;  ///< D! volumes
  /// In space: sum over its edges of length x exterior angle, less pi perimeters of those facets.
  double length = 0.0;
  double singular = 0.0;  ///< (D - 1)! areas of singular facets, a change that is never positive
  double regular = 0.0;   ///< (D - 1)! areas of regular facets, a change of either sign
  double singular_error = 0.0, regular_error = 0.0;  ///< to be added: what rounding took from them
};

/// What a facet that is singular at first adds when it enters.
struct FacetTerms {
  double length = 0.0;  ///< in space: -pi perimeters
  double area = 0.0;    ///< (D - 1)! areas
};

/// What an edge in space adds when it enters: 2 pi lengths.
using EdgeTerm = double;

/// How many terms of a simplex are too large to be summed, by the sum they belong to; -1 where such
/// a term goes.
struct LargeTerms {
  std::int8_t volume = 0, length = 0, singular = 0, regular = 0;
};

/// Measures single simplices, many at a time.
///
/// Terms are in units of 2^-unit_exponent units of the points. Each depends on the vertices'
/// coordinates alone, taken in the order of the vertices: a facet seen from either side gives the
/// same area, and the sums of areas are exact to 2^-105 of them. Other errors are a few 2^-53 of
/// the products of edge lengths.
template <int D>
class Contributions {
 public:
  /// Larger terms are left out, and counted as LargeTerms.
  static constexpr double kLargestTerm = 0x1p+960;

  /// Keeps references to the filtration and the roles, which may be empty where no sums of singular
  /// and regular areas are wanted.
  /// In units of the double stages of Sites: no intermediate result leaves the double range, but
  /// much shorter edges than 2^-500 units may vanish. No term is too large.
  Contributions(const Filtration<D>& filtration, std::span<const std::uint8_t> roles);
  /// In any unit, for points of any range. Slow. Results may be too large or vanish.
  Contributions(const Filtration<D>& filtration, std::span<const std::uint8_t> roles,
                int unit_exponent);

  /// out[i] becomes that of cells[i], counted from the first cell, and large[i] as well if
  /// may_be_large(). Fastest where neighbours in the list are neighbours in number.
  void measure(std::span<const std::uint32_t> cells, std::span<CellTerms> out,
               std::span<LargeTerms> large) const;
  /// The same of facets.
  void measure(std::span<const std::uint32_t> facets, std::span<FacetTerms> out,
               std::span<LargeTerms> large) const;
  /// The same of edges in space; does nothing in the plane, where edges are facets.
  void measure(std::span<const std::uint32_t> edges, std::span<EdgeTerm> out,
               std::span<LargeTerms> large) const;

  [[nodiscard]] int unit_exponent() const { return unit_exponent_; }
  [[nodiscard]] bool may_be_large() const { return is_wide_; }

 private:
  const Filtration<D>* filtration_;
  std::span<const std::uint8_t> roles_;
  bool is_wide_ = false;
  int unit_exponent_ = 0;
};

extern template class Contributions<2>;  // defined in contributions.cpp
extern template class Contributions<3>;

}  // namespace orthoball
