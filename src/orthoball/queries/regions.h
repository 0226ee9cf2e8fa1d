// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"

namespace orthoball {

/// What holds a region of an alpha shape together.
enum class JoinedBy {
  vertices,  ///< any face in common: the components of the complex, betti 0 of them
  cells,     ///< cells with a common vertex, as those of the notable alpha `one_region`
  facets,    ///< cells with a common facet: the components of the shape's interior
};

/// A part of an alpha shape. In input units, as ComplexMeasures.
struct Region {
  double volume = 0.0;           ///< of its cells; length^D
  double area = 0.0;             ///< two-sided where facets are singular; length^(D-1)
  std::vector<SiteId> rows;      ///< of its vertices, ascending
  std::vector<SimplexId> cells;  ///< ascending
};

/// The regions of the shape at one index, the largest volume first; equal ones by area, then by the
/// lowest row. Singular simplices belong to regions with JoinedBy::vertices only; a row may be in
/// several with JoinedBy::facets only.
///
/// Which simplices are whose is exact. Linear but for sorting.
/// @throws InputError for an index beyond the spectrum's size.
template <int D>
[[nodiscard]] std::vector<Region> regions(const Filtration<D>& filtration, std::uint32_t index,
                                          JoinedBy by);

extern template std::vector<Region> regions<2>(const Filtration<2>&, std::uint32_t,
                                               JoinedBy);  // in regions.cpp
extern template std::vector<Region> regions<3>(const Filtration<3>&, std::uint32_t, JoinedBy);

}  // namespace orthoball
