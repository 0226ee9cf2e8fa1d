// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "orthoball/measures/lens.h"

namespace orthoball {

/// What the union of balls leaves free of a cell outside the dual complex, as far as pieces of the
/// union over its facets and around its edges go; the sectors of its corners' balls are left to the
/// caller. A single cell's numbers may be negative; sums over the cells of a void are its own.
template <int D>
struct CellGap {
  double volume = 0.0;  ///< of the cell, less those pieces
  /// [corner]: the directions into the cell, in steradians or radians, less those into the pieces:
  /// what the void has of the corner's sphere.
  std::array<double, std::size_t{D} + 1> exposed{};
};

/// Which faces of a cell are in the complex, a bit each, all by the corners they leave out or, of
/// edges in space, by their slot (kEdgeCorners).
struct FacesInComplex {
  std::uint32_t facets = 0;  ///< by the corner opposite
  std::uint32_t edges = 0;   ///< in space only
};

/// @param corners  the balls at the corners of a cell, in any order; any unit of length.
[[nodiscard]] CellGap<2> cell_gap(const std::array<Sphere<2>, 3>& corners, FacesInComplex faces);
[[nodiscard]] CellGap<3> cell_gap(const std::array<Sphere<3>, 4>& corners, FacesInComplex faces);

/// Area or volume of a cell.
[[nodiscard]] double cell_volume(const std::array<Sphere<2>, 3>& corners);
[[nodiscard]] double cell_volume(const std::array<Sphere<3>, 4>& corners);

/// Length or area of the facet of a cell opposite a corner.
[[nodiscard]] double facet_size(const std::array<Sphere<2>, 3>& corners, std::size_t opposite);
[[nodiscard]] double facet_size(const std::array<Sphere<3>, 4>& corners, std::size_t opposite);

}  // namespace orthoball
