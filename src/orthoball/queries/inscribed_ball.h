// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "orthoball/measures/lens.h"

namespace orthoball {

/// A ball that touches others from outside.
template <int D>
struct InscribedBall {
  std::array<double, std::size_t{D}> centre{};  ///< [axis]
  double radius = 0.0;                          ///< < 0 where the centre is inside another ball
};

/// The point of equal power to D + 1 balls; not finite where they are flat.
template <int D>
[[nodiscard]] std::array<double, std::size_t{D}> point_of_equal_power(
    const std::array<Sphere<D>, std::size_t{D} + 1>& balls);

/// The largest ball around a point that is in none of the balls; of radius -infinity around a point
/// that is not finite.
template <int D>
[[nodiscard]] InscribedBall<D> ball_around(const std::array<double, std::size_t{D}>& centre,
                                           std::span<const Sphere<D>> balls);

/// From a point in none of the balls, the orthocentre of a cell of a void, to a ball that cannot
/// grow by touching others: again and again the one that touches the D + 1 nearest balls, as long
/// as that is larger and has points in common with the one before, so that it lies in the same
/// void.
/// @param balls  those that line the void; at least D + 1.
template <int D>
[[nodiscard]] InscribedBall<D> inscribed_ball(const std::array<double, std::size_t{D}>& start,
                                              std::span<const Sphere<D>> balls);

extern template std::array<double, 2> point_of_equal_power(const std::array<Sphere<2>, 3>&);
extern template std::array<double, 3> point_of_equal_power(const std::array<Sphere<3>, 4>&);
extern template InscribedBall<2> ball_around(const std::array<double, 2>&,
                                             std::span<const Sphere<2>>);  // in inscribed_ball.cpp
extern template InscribedBall<3> ball_around(const std::array<double, 3>&,
                                             std::span<const Sphere<3>>);
extern template InscribedBall<2> inscribed_ball(const std::array<double, 2>&,
                                                std::span<const Sphere<2>>);
extern template InscribedBall<3> inscribed_ball(const std::array<double, 3>&,
                                                std::span<const Sphere<3>>);

}  // namespace orthoball
