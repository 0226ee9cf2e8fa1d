// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace orthoball::oracles {

/// The points x with normal . x <= offset.
struct HalfSpace {
  std::vector<double> normal;
  double offset = 0.0;
};

/// A ball in space, a disk in the plane or a segment of a line (`centre` has that many numbers) cut
/// by half-spaces: what a ball has to itself of an overlap or of a union, and, a dimension lower,
/// where two such parts meet.
struct CutBall {
  std::vector<double> centre;
  double radius = 0.0;
  std::vector<HalfSpace> cuts;
};

/// The half-space in which the power to one ball is at most that to another.
[[nodiscard]] HalfSpace where_power_is_less(const CutBall& one, const CutBall& other);
[[nodiscard]] HalfSpace where_power_is_more(const CutBall& one, const CutBall& other);

/// length^D. Slices of slices, of which the last are intervals; by Gauss's rule between the places
/// where anything begins, ends or bends, so that errors are some 1e-13 of the ball's volume.
[[nodiscard]] double volume(const CutBall& ball);

/// length^(D-1), of the sphere inside the half-spaces: in the plane the length of arcs, on a line
/// the number of ends. In space by slices, on which it is an angle.
[[nodiscard]] double area(const CutBall& ball);

/// Where the plane of one cut meets the ball, inside the other cuts; lengths are kept.
[[nodiscard]] CutBall facet(const CutBall& ball, std::size_t cut);

}  // namespace orthoball::oracles
