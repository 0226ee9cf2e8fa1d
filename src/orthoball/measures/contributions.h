// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// Vertices of a cell, which are its facets as well.
template <int D>
inline constexpr std::size_t kCorners = static_cast<std::size_t>(D) + 1;

/// What a cell adds to the measures of a complex when it enters.
template <int D>
struct CellContribution {
  double volume = 0.0;  ///< D! volumes
  double length = 0.0;  ///< in space: sum over its edges of length x exterior angle
  /// [i]: (D - 1)! areas of the facet without the i-th vertex; the sign bit is set where the cell
  /// is the second of the facet's two cells to enter, which makes the facet interior.
  std::array<double, kCorners<D>> facets{};
};

/// What a facet adds when it enters.
struct FacetContribution {
  double area = 0.0;       ///< (D - 1)! areas
  double perimeter = 0.0;  ///< in space
};

/// What an edge in space adds when it enters: its length.
using EdgeContribution = double;

/// Measures single simplices, many at a time.
///
/// Contributions are in units of 2^-unit_exponent units of the points. Each depends on the
/// vertices' coordinates alone, taken in the order of the vertices: a facet seen from either side
/// gives the same double. Errors are a few 2^-53 of the products of edge lengths.
template <int D>
class Contributions {
 public:
  /// Keeps a reference to the filtration.
  /// In units of the double stages of Sites: no intermediate result leaves the double range, but
  /// much shorter edges than 2^-500 units may vanish.
  explicit Contributions(const Filtration<D>& filtration);
  /// In any unit, for points of any range. Slow. Results may overflow to infinity or vanish.
  Contributions(const Filtration<D>& filtration, int unit_exponent);

  /// out[i] becomes the contribution of cells[i], a SimplexId's row. Fastest where neighbours in
  /// the list are neighbours in number.
  void measure(std::span<const std::uint32_t> cells, std::span<CellContribution<D>> out) const;
  /// The same of simplices of dimension D - 1.
  void measure(std::span<const std::uint32_t> facets, std::span<FacetContribution> out) const;
  /// The same of edges in space; does nothing in the plane, where edges are facets.
  void measure(std::span<const std::uint32_t> edges, std::span<EdgeContribution> out) const;

  [[nodiscard]] int unit_exponent() const { return unit_exponent_; }

 private:
  const Filtration<D>* filtration_;
  bool is_wide_ = false;
  int unit_exponent_ = 0;
};

extern template class Contributions<2>;  // defined in contributions.cpp
extern template class Contributions<3>;

}  // namespace orthoball
