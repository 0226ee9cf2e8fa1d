// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace orthoball {

/// A ball in space or a disk in the plane.
template <int D>
struct Ball {
  std::array<double, std::size_t{D}> centre{};  ///< [axis]
  double radius = 0.0;                          ///< >= 0, in the unit of the centre
};

/// What 1 to D + 1 balls have in common, and the part of it that each of them bounds.
///
/// Ball i bounds the points in which its power is the largest. There the common part ends at its
/// sphere, and `volumes` are the measures of these points, `areas` those of the sphere inside all
/// other balls. In the plane volumes are areas, areas lengths of arcs.
template <int D>
struct BallOverlap {
  double volume = 0.0;                               ///< length^D
  double area = 0.0;                                 ///< of the boundary; length^(D-1)
  std::array<double, std::size_t{D} + 1> volumes{};  ///< [ball], their sum is `volume`
  std::array<double, std::size_t{D} + 1> areas{};    ///< [ball], their sum is `area`
  /// In space, [i][j] and [j][i]: length of the circle of balls i and j inside the other balls.
  std::array<std::array<double, std::size_t{D} + 1>, std::size_t{D} + 1> arcs{};
};

/// The overlap of balls that are a simplex of their dual complex: their orthoball is imaginary or
/// a point, as are those of the faces. These are the overlaps that inclusion and exclusion over a
/// complex needs; others are empty or overlaps of fewer balls. Where the balls are farther apart,
/// the result is that of balls that just touch.
///
/// Radii and distances up to 2^300; beyond, volumes may overflow.
/// Error: a few 2^-53 of what the balls themselves measure, from touching balls to nearly
/// concentric ones. docs/derivations/union_of_balls.md has the formulas.
/// @param balls  1 to D + 1, with different centres in general position.
/// @throws InputError for another number of balls, a negative radius or numbers that are not
///         finite.
template <int D>
[[nodiscard]] BallOverlap<D> ball_overlap(std::span<const Ball<D>> balls);

extern template BallOverlap<2> ball_overlap<2>(std::span<const Ball<2>>);  // in ball_overlaps.cpp
extern template BallOverlap<3> ball_overlap<3>(std::span<const Ball<3>>);

}  // namespace orthoball
