// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/input_units.h"
#include "orthoball/measures/lens.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// The balls of a filtration's vertices at one alpha, in numbers that can be calculated with.
///
/// Lengths are those of Sites, but for a power of two where balls are so large that their volumes
/// would overflow: `units` turns them into input units. Centres and weights as exact as in Sites,
/// radii rounded. Immutable. Refers to the filtration. 40 bytes a vertex in space.
template <int D>
class ScaledBalls {
 public:
  /// @param alpha2  added to the weights, length^2 in input units.
  /// @throws InputError for an index beyond the spectrum's size, and for an alpha2 that is infinite
  ///         or no number, but -infinity.
  ScaledBalls(const Filtration<D>& filtration, std::uint32_t index, double alpha2);

  /// [vertex]: the balls; radius 0 for those that are empty.
  [[nodiscard]] std::span<const Sphere<D>> spheres() const { return spheres_; }
  /// From the units of these. @param power  1 for lengths, 2 for areas, 3 for volumes.
  [[nodiscard]] InputUnits units(int power) const;
  /// The other way, of a number in input units. Rounded.
  [[nodiscard]] double from_input(double value, int power) const;

 private:
  const Filtration<D>* filtration_;
  int scale_exponent_;  // lengths are 2^this times those in the unit of the points
  RawVector<Sphere<D>> spheres_;
};

extern template class ScaledBalls<2>;  // defined in scaled_balls.cpp
extern template class ScaledBalls<3>;

}  // namespace orthoball
