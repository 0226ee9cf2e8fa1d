// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/ids.h"

namespace orthoball {

/// What holds a region of an alpha shape together.
enum class JoinedBy {
  vertices,  ///< any face in common: the components of the complex, betti 0 of them
  cells,     ///< cells with a common vertex, as those of the notable alpha `one_region`
  facets,    ///< cells with a common facet: the components of the shape's interior
};

/// A part of an alpha shape, or of what is around it. In input units, as ComplexMeasures.
struct Region {
  double volume = 0.0;           ///< of its cells; length^D
  double area = 0.0;             ///< two-sided where facets are singular; length^(D-1)
  std::vector<SiteId> rows;      ///< of its vertices, ascending
  std::vector<SimplexId> cells;  ///< ascending
  /// [k]: of the region alone, closed; 0 from the dimension of space on.
  std::array<std::uint32_t, 3> betti{};
};

/// The regions of a shape, the largest volume first; equal ones by area, then by the lowest row.
/// Singular simplices belong to regions with JoinedBy::vertices only; a row may be in several with
/// JoinedBy::facets only.
///
/// Which simplices are whose, and Betti numbers, are exact. Linear but for sorting.
template <int D>
[[nodiscard]] std::vector<Region> regions(const AlphaComplex<D>& complex, JoinedBy by);

/// All of a shape as one region, with the Betti numbers of the whole.
template <int D>
[[nodiscard]] Region whole_shape(const AlphaComplex<D>& complex);

/// The holes of a shape, the bounded components of its complement, in the same order: those of
/// K_index are its voids. Cells are outside the complex, rows those of their vertices that are in
/// it; area is that of the complex around. No Betti numbers.
template <int D>
[[nodiscard]] std::vector<Region> holes(const AlphaComplex<D>& complex);

extern template std::vector<Region> regions<2>(const AlphaComplex<2>&,
                                               JoinedBy);  // in regions.cpp
extern template std::vector<Region> regions<3>(const AlphaComplex<3>&, JoinedBy);
extern template Region whole_shape<2>(const AlphaComplex<2>&);
extern template Region whole_shape<3>(const AlphaComplex<3>&);
extern template std::vector<Region> holes<2>(const AlphaComplex<2>&);
extern template std::vector<Region> holes<3>(const AlphaComplex<3>&);

}  // namespace orthoball
