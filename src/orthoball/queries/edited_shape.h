// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "orthoball/filtration/alpha_complex.h"

namespace orthoball {

/// What is made of a shape, in this order.
struct ShapeEdits {
  bool regularized = false;  ///< singular simplices are left out
  /// Holes of at most this volume are filled: bounded components of the complement. length^D; 0
  /// fills none.
  std::optional<double> hole_threshold{};
  /// Regions of at most this volume are left out: components of what there is then. length^D; 0
  /// leaves out those that are nothing but singular simplices, and keeps all with cells, though
  /// their volume be too small for a double.
  std::optional<double> region_threshold{};
  std::uint32_t region = 0;  ///< only this one is left, 1 being the largest; 0: all are
};

/// A shape of which holes were filled and regions left out.
template <int D>
struct EditedShape {
  AlphaComplex<D> complex;
  std::size_t region_count = 0;     ///< before any was left out; 0 where nobody asked for that
  std::size_t regions_dropped = 0;  ///< by the threshold
  double volume_dropped = 0.0;      ///< of those; length^D
  std::size_t holes_filled = 0;
  double volume_filled = 0.0;  ///< of the holes; length^D
};

/// The shape at an index with edits; K_index itself without any. Thresholds mean what MATLAB's
/// HoleThreshold and RegionThreshold do, of a regularized shape.
///
/// Which simplices belong together is exact; volumes are compared as doubles. Linear but for
/// sorting.
/// @throws InputError for an index beyond the spectrum's size, for a threshold below 0 or NaN, for
/// a region that there is not.
template <int D>
[[nodiscard]] EditedShape<D> edited_shape(const Filtration<D>& filtration, std::uint32_t index,
                                          const ShapeEdits& edits);

extern template EditedShape<2> edited_shape<2>(const Filtration<2>&, std::uint32_t,
                                               const ShapeEdits&);  // in edited_shape.cpp
extern template EditedShape<3> edited_shape<3>(const Filtration<3>&, std::uint32_t,
                                               const ShapeEdits&);

}  // namespace orthoball
