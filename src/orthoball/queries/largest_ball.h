// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "orthoball/measures/lens.h"
#include "orthoball/queries/inscribed_ball.h"

namespace orthoball {

/// A cell of a void.
template <int D>
struct VoidCell {
  /// The balls at its corners, of radius 0 where they are not in the complex.
  std::array<Sphere<D>, std::size_t{D} + 1> corners;
  std::array<double, std::size_t{D}> orthocentre{};  ///< need not be finite
};

/// The largest ball with its centre in a void that is in none of the balls around it; radius
/// negative where none is found, as in voids that rounding has made.
///
/// Exact but for rounding where the radii around the void are equal. Otherwise no ball is larger by
/// more than 1 / 128 and 1 / 1024 of the least radius around the void, unless that is so wide and
/// flat that the search ends early, after 2^16 parts of cells; most often it is the largest.
/// @param cells  all cells of the void.
/// @param balls  those that line it.
template <int D>
[[nodiscard]] InscribedBall<D> largest_ball(std::span<const VoidCell<D>> cells,
                                            std::span<const Sphere<D>> balls);

extern template InscribedBall<2> largest_ball(std::span<const VoidCell<2>>,
                                              std::span<const Sphere<2>>);  // in largest_ball.cpp
extern template InscribedBall<3> largest_ball(std::span<const VoidCell<3>>,
                                              std::span<const Sphere<3>>);

}  // namespace orthoball
