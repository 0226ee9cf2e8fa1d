// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "orthoball/measures/angle.h"

namespace orthoball {

/// A ball or disk as what is measured sees it. Any unit of length.
template <int D>
struct Sphere {
  std::array<double, std::size_t{D}> x{};
  double weight = 0.0;  ///< radius^2, but for a number that is the same for all
  double radius = 0.0;
};

// What two and three balls of one simplex of an alpha complex have in common. Their spheres meet,
// so that all heights below lie within the balls; where rounding says otherwise they are put back
// there. Derivations are in docs/derivations/union_of_balls.md.

/// Two balls: their spheres meet in a circle (D = 3) or a pair of points (D = 2), in the plane or
/// line of equal power.
template <int D>
struct Lens {
  std::array<double, std::size_t{D}> axis{};  ///< unit vector from the first centre to the second
  double distance = 0.0;                      ///< of the centres
  /// [ball]: signed distance of the plane of equal power from each centre, towards the other.
  std::array<double, 2> height{};
  double radius2 = 0.0;  ///< of the circle, >= 0; half the pair's distance squared
  double radius = 0.0;

  /// [ball]: the angle at each centre between the axis and the circle, in [0, pi] radians.
  [[nodiscard]] double opening(std::size_t ball) const {
    return angle_from_x_axis(height[ball], radius);
  }
};

/// radius + height, >= 0, also where these nearly cancel.
[[nodiscard]] inline double above_far_pole(double radius, double height, double circle2) {
  if (height >= 0.0) return radius + height;
  return radius > height ? circle2 / (radius - height) : 0.0;
}

/// The lens of two balls with different centres.
template <int D>
[[nodiscard]] inline Lens<D> lens(const Sphere<D>& a, const Sphere<D>& b) {
  Lens<D> result;
  double largest = 0.0;
  for (std::size_t i = 0; i < D; ++i) {
    result.axis[i] = b.x[i] - a.x[i];
    largest = std::max(largest, std::abs(result.axis[i]));
  }
  if (largest == 0.0) {  // closer than doubles can tell
    result.axis[0] = 1.0;
  } else {
    double norm2 = 0.0;
    for (double& x : result.axis) {
      x /= largest;  // so that no square vanishes
      norm2 += x * x;
    }
    const double norm = std::sqrt(norm2);
    for (double& x : result.axis) x /= norm;
    result.distance = largest * norm;
    const double offset = (a.weight - b.weight) / result.distance;
    result.height[0] = std::clamp((result.distance + offset) / 2, -a.radius, a.radius);
    result.height[1] = std::clamp((result.distance - offset) / 2, -b.radius, b.radius);
  }
  const bool first = std::abs(result.height[0]) <= std::abs(result.height[1]);
  const double radius = first ? a.radius : b.radius;
  const double height = result.height[first ? 0 : 1];
  result.radius2 = (radius - height) * (radius + height);
  result.radius = std::sqrt(result.radius2);
  return result;
}

/// In the plane: how far from the axis, towards a third disk, the point lies that has equal power
/// to all three: within the lens's radius.
/// @param first  the lens's first disk.
[[nodiscard]] inline double offset_across(const Lens<2>& lens, const Sphere<2>& first,
                                          const Sphere<2>& third) {
  const double x = third.x[0] - first.x[0], y = third.x[1] - first.x[1];
  const double along = x * lens.axis[0] + y * lens.axis[1];
  const double off = std::abs(lens.axis[0] * y - lens.axis[1] * x);
  const double level =
      (off * off + along * (along - 2 * lens.height[0]) + first.weight - third.weight) / 2;
  return off > 0.0 ? std::clamp(level / off, -lens.radius, lens.radius) : 0.0;
}

/// In the plane: the angle of a triangle at `at`, in [0, pi] radians.
[[nodiscard]] inline double corner_angle(const Sphere<2>& at, const Sphere<2>& b,
                                         const Sphere<2>& c) {
  const double bx = b.x[0] - at.x[0], by = b.x[1] - at.x[1];
  const double cx = c.x[0] - at.x[0], cy = c.x[1] - at.x[1];
  return angle_from_x_axis(bx * cx + by * cy, std::abs(bx * cy - by * cx));
}

/// A vector in the plane of a lens's circle.
struct InLens {
  double x = 0.0, y = 0.0;
};
[[nodiscard]] inline double dot(InLens a, InLens b) { return a.x * b.x + a.y * b.y; }
/// Positive where b is counterclockwise of a.
[[nodiscard]] inline double cross(InLens a, InLens b) { return a.x * b.y - a.y * b.x; }

/// A third ball at a lens in space: it covers the arc of the circle, and the segment of its disk,
/// beyond a chord.
struct Chord {
  InLens apex;                 ///< the third centre, from the axis
  double apex_distance = 0.0;  ///< its length
  double along = 0.0;          ///< the third centre along the axis, from the first centre
  double height = 0.0;         ///< signed distance of the chord from the axis, towards the apex
  double half = 0.0;           ///< half its length, >= 0

  /// Half the angle of the arc that the third ball covers, in [0, pi] radians.
  [[nodiscard]] double half_angle() const { return angle_from_x_axis(height, half); }
  /// One end of the chord: the later one seen counterclockwise for side = 1, the earlier for -1.
  [[nodiscard]] InLens end(double side) const { return point(side * half); }
  /// The point of the chord so far counterclockwise of its middle.
  [[nodiscard]] InLens point(double offset) const {
    if (apex_distance == 0.0) return {height, offset};
    const InLens u{apex.x / apex_distance, apex.y / apex_distance};
    return {height * u.x - offset * u.y, height * u.y + offset * u.x};
  }
};

/// A lens in space with coordinates in the plane of its circle: `across[0]`, `across[1]` and the
/// axis are a right-handed orthonormal frame.
class LensFrame {
 public:
  LensFrame(const Sphere<3>& a, const Sphere<3>& b) : lens_(orthoball::lens(a, b)), first_(a) {
    const auto& e = lens_.axis;
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::abs(e[i]) < std::abs(e[least])) least = i;
    }
    const std::size_t j = (least + 1) % 3, k = (least + 2) % 3;
    const double norm = std::sqrt(e[j] * e[j] + e[k] * e[k]);
    auto& f = across_[0];
    f[j] = -e[k] / norm;
    f[k] = e[j] / norm;
    for (std::size_t i = 0; i < 3; ++i) {
      across_[1][i] = e[(i + 1) % 3] * f[(i + 2) % 3] - e[(i + 2) % 3] * f[(i + 1) % 3];
    }
  }

  [[nodiscard]] const Lens<3>& lens() const { return lens_; }
  /// From the plane of the circle to space.
  [[nodiscard]] std::array<double, 3> in_space(InLens at) const {
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i) x[i] = at.x * across_[0][i] + at.y * across_[1][i];
    return x;
  }

  [[nodiscard]] Chord chord(const Sphere<3>& third) const {
    std::array<double, 3> to{};
    for (std::size_t i = 0; i < 3; ++i) to[i] = third.x[i] - first_.x[i];
    const auto along = [&](const std::array<double, 3>& e) {
      return to[0] * e[0] + to[1] * e[1] + to[2] * e[2];
    };
    Chord chord;
    chord.apex = {along(across_[0]), along(across_[1])};
    chord.along = along(lens_.axis);
    const double off2 = dot(chord.apex, chord.apex);
    chord.apex_distance = std::sqrt(off2);
    // On the plane of equal power with the first ball x . to = (|to|^2 + weight - weight) / 2.
    const double level =
        (off2 + chord.along * (chord.along - 2 * lens_.height[0]) + first_.weight - third.weight) /
        2;
    if (chord.apex_distance > 0.0) chord.height = level / chord.apex_distance;
    chord.height = std::clamp(chord.height, -lens_.radius, lens_.radius);
    chord.half = std::sqrt((lens_.radius - chord.height) * (lens_.radius + chord.height));
    return chord;
  }

  /// Where two chords cross: the orthocentre of the four balls, seen along the axis. The second
  /// apex is counterclockwise of the first.
  [[nodiscard]] InLens crossing(const Chord& a, const Chord& b) const {
    const double size = cross(a.apex, b.apex);
    const double to_a = a.height * a.apex_distance, to_b = b.height * b.apex_distance;
    InLens at;
    if (size > 0.0) {
      at = {(to_a * b.apex.y - to_b * a.apex.y) / size, (to_b * a.apex.x - to_a * b.apex.x) / size};
    }
    const double off2 = dot(at, at);
    if (off2 <= lens_.radius2) return at;
    if (!std::isfinite(off2)) return {};
    const double back = lens_.radius / std::sqrt(off2);
    return {at.x * back, at.y * back};
  }

  /// The solid angle, at the centre of one of the two balls, of the tetrahedron from the three
  /// centres to an end of the chord; in [0, 2 pi]. As a function of the height and the half of the
  /// chord it goes with half_angle(): what rounding takes from one it gives to the other.
  [[nodiscard]] double solid_angle(const Chord& chord, std::size_t ball, double radius) const {
    const double along = ball == 0 ? chord.along : lens_.distance - chord.along;
    const double off = chord.apex_distance;
    const double length = std::sqrt(along * along + off * off);
    const double beyond = along >= 0.0 ? length + along : off * (off / (length - along));
    const double above = above_far_pole(radius, lens_.height[ball], lens_.radius2);
    return 2 * angle_from_x_axis(above * beyond + off * chord.height, off * chord.half);
  }

 private:
  Lens<3> lens_;
  Sphere<3> first_;
  std::array<std::array<double, 3>, 2> across_{};
};

/// The angle from one apex to the next one counterclockwise, in [0, pi] radians: the dihedral angle
/// of their tetrahedron at the axis.
[[nodiscard]] inline double angle_between(InLens a, InLens b) {
  return angle_from_x_axis(dot(a, b), std::max(0.0, cross(a, b)));
}

}  // namespace orthoball
