// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "orthoball/measures/angle.h"
#include "orthoball/vectors.h"

namespace orthoball {

/// A ball or disk as what is measured sees it. Any unit of length.
template <int D>
struct Sphere {
  std::array<double, std::size_t{D}> x{};  ///< [axis]: the centre
  double weight = 0.0;                     ///< radius^2, but for a number that is the same for all
  double radius = 0.0;
};

/// A vector whose angle with the x axis is meant, y >= 0, so that many angles can be computed at
/// once.
struct HalfPlane {
  double x = 1.0, y = 0.0;
};
/// That angle, in [0, pi] radians.
[[nodiscard]] inline double angle(HalfPlane vector) {
  return angle_from_x_axis(vector.x, vector.y);
}

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
  [[nodiscard]] HalfPlane opening(std::size_t ball) const { return {height[ball], radius}; }
};

/// Squares of lengths below this may have lost bits or vanished: vectors are enlarged before.
inline constexpr double kLeastSquare = 0x1p-900;
inline constexpr double kEnlarging = 0x1p+900;

/// radius + height, >= 0, also where these nearly cancel.
[[nodiscard]] inline double above_far_pole(double radius, double height, double circle2) {
  if (height >= 0.0) return radius + height;
  return radius > height ? circle2 / (radius - height) : 0.0;
}

/// The lens of two balls with different centres.
template <int D>
[[nodiscard]] inline Lens<D> lens(const Sphere<D>& a, const Sphere<D>& b) {
  Lens<D> result;
  const auto set_axis = [&](double unit) {
    double norm2 = 0.0;
    for (std::size_t i = 0; i < D; ++i) {
      result.axis[i] = (b.x[i] - a.x[i]) / unit;
      norm2 += result.axis[i] * result.axis[i];
    }
    return norm2;
  };
  double unit = 1.0;
  double norm2 = set_axis(unit);
  if (norm2 < kLeastSquare) {  // so that no square vanishes
    unit = 0.0;
    for (std::size_t i = 0; i < D; ++i) unit = std::max(unit, std::abs(b.x[i] - a.x[i]));
    norm2 = unit > 0.0 ? set_axis(unit) : 0.0;
  }
  if (norm2 > 0.0) {
    const double norm = std::sqrt(norm2), inverse = 1.0 / norm;
    for (double& x : result.axis) x *= inverse;
    result.distance = unit * norm;
    const double offset = (a.weight - b.weight) * inverse / unit;
    result.height[0] = std::clamp((result.distance + offset) / 2, -a.radius, a.radius);
    result.height[1] = std::clamp((result.distance - offset) / 2, -b.radius, b.radius);
  } else {
    result.axis[0] = 1.0;  // closer than doubles can tell
  }
  const bool first = std::abs(result.height[0]) <= std::abs(result.height[1]);
  const double radius = first ? a.radius : b.radius;
  const double height = result.height[first ? 0 : 1];
  result.radius2 = (radius - height) * (radius + height);
  result.radius = std::sqrt(result.radius2);
  return result;
}

/// The square of the radius of their circle, roughly: for telling which of two is the smaller.
template <int D>
[[nodiscard]] inline double rough_circle2(const Sphere<D>& a, const Sphere<D>& b) {
  double norm2 = 0.0;
  for (std::size_t i = 0; i < D; ++i) norm2 += (b.x[i] - a.x[i]) * (b.x[i] - a.x[i]);
  if (norm2 < kLeastSquare) return lens(a, b).radius2;
  const double twice = norm2 + (a.weight - b.weight);
  return a.radius * a.radius - twice * twice / (4 * norm2);
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
  return angle({bx * cx + by * cy, std::abs(bx * cy - by * cx)});
}

/// A vector in the plane of a lens's circle.
struct InLens {
  double x = 0.0, y = 0.0;
};
/// The inner product.
[[nodiscard]] inline double dot(InLens a, InLens b) { return a.x * b.x + a.y * b.y; }
/// Positive where b is counterclockwise of a.
[[nodiscard]] inline double cross(InLens a, InLens b) { return a.x * b.y - a.y * b.x; }

/// A third ball at a lens in space, seen along the axis: it covers what is beyond a line.
struct Beyond {
  InLens apex;  ///< the third centre, from the axis
  /// [ball]: the third centre along the axis, from each centre towards the other.
  std::array<double, 2> along{};
  double level = 0.0;  ///< the line is where the inner product with `apex` is this
  /// `apex` and `level` are this many times too large: 1, or more where squares would vanish.
  double enlarged = 1.0;
};

/// Where that line cuts the disk of the lens.
struct Chord {
  InLens towards;                 ///< unit vector to the apex
  double apex_distance = 0.0;     ///< of the third centre from the axis
  std::array<double, 2> along{};  ///< as in Beyond
  double height = 0.0;            ///< signed distance of the chord from the axis, towards the apex
  double half = 0.0;              ///< half its length, >= 0

  /// Half the angle of the arc that the third ball covers, in [0, pi] radians.
  [[nodiscard]] HalfPlane half_angle() const { return {height, half}; }
  /// One end of the chord: the later one seen counterclockwise for side = 1, the earlier for -1.
  [[nodiscard]] InLens end(double side) const {
    const double offset = side * half;
    return {height * towards.x - offset * towards.y, height * towards.y + offset * towards.x};
  }
};

/// a.x - b.x
[[nodiscard]] inline std::array<double, 3> difference(const Sphere<3>& a, const Sphere<3>& b) {
  return difference(a.x, b.x);
}

/// A lens in space with coordinates in the plane of its circle: `across[0]`, `across[1]` and the
/// axis are a right-handed orthonormal frame.
class LensFrame {
 public:
  LensFrame(const Sphere<3>& a, const Sphere<3>& b)
      : lens_(orthoball::lens(a, b)), first_(a), second_(b) {
    const auto& e = lens_.axis;
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::abs(e[i]) < std::abs(e[least])) least = i;
    }
    const std::size_t j = (least + 1) % 3, k = (least + 2) % 3;
    const double inverse = 1.0 / std::sqrt(e[j] * e[j] + e[k] * e[k]);
    auto& f = across_[0];
    f[j] = -e[k] * inverse;
    f[k] = e[j] * inverse;
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

  [[nodiscard]] Beyond beyond(const Sphere<3>& third) const {
    // From the nearer end: where the third centre is close to it, its direction is known as well.
    // Which that is is as good as random: nothing branches on it.
    const std::array<double, 3> to0 = difference(third, first_), to1 = difference(third, second_);
    const std::size_t nearer = inner(to1, to1) < inner(to0, to0) ? 1 : 0;
    const Sphere<3>& end = *std::array{&first_, &second_}[nearer];
    const std::array<double, 3> to = difference(third, end);
    const std::array<double, 2> place{0.0, lens_.distance},
        height{lens_.height[0], -lens_.height[1]};
    Beyond beyond;
    beyond.apex = {inner(to, across_[0]), inner(to, across_[1])};
    const double along = inner(to, lens_.axis);
    beyond.along = {place[nearer] + along, place[1 - nearer] - along};
    // On the plane of equal power with the end x . to = (|to|^2 + weight - weight) / 2.
    beyond.level = (dot(beyond.apex, beyond.apex) + along * (along - 2 * height[nearer]) +
                    (end.weight - third.weight)) /
                   2;
    if (dot(beyond.apex, beyond.apex) < kLeastSquare) {
      beyond.enlarged = kEnlarging;
      beyond.apex = {beyond.apex.x * kEnlarging, beyond.apex.y * kEnlarging};
      beyond.level *= kEnlarging;
    }
    return beyond;
  }

  /// @param half  meeting_height() of the three balls.
  [[nodiscard]] Chord chord(const Beyond& beyond, double half) const {
    Chord chord;
    const double distance = std::sqrt(dot(beyond.apex, beyond.apex));
    chord.apex_distance = distance / beyond.enlarged;
    chord.along = beyond.along;
    chord.towards = {1.0, 0.0};
    if (distance > 0.0) {
      const double inverse = 1.0 / distance;
      chord.towards = {beyond.apex.x * inverse, beyond.apex.y * inverse};
      chord.height = std::clamp(beyond.level * inverse, -lens_.radius, lens_.radius);
    }
    // Its ends are on the circle: the smaller of height and half is the better known.
    chord.half = std::min(half, lens_.radius);
    const double height = std::copysign(
        std::sqrt((lens_.radius - chord.half) * (lens_.radius + chord.half)), chord.height);
    if (std::abs(chord.height) > chord.half) chord.height = height;
    return chord;
  }

  /// Where two lines cross: the orthocentre of the four balls, seen along the axis. The second apex
  /// is counterclockwise of the first. Of a tetrahedron that is nearly flat the lines are nearly
  /// one, and where on it they cross is all rounding: the point is on both in any case, and in the
  /// disk.
  [[nodiscard]] InLens crossing(const Beyond& a, const Beyond& b) const {
    const double off2 = dot(a.apex, a.apex);
    if (off2 == 0.0) return {};
    const double scale = a.level / off2;
    InLens foot{a.apex.x * scale, a.apex.y * scale};
    double along = (b.level - dot(foot, b.apex)) / cross(a.apex, b.apex);
    const double room2 = lens_.radius2 - dot(foot, foot);
    if (!(along * along * off2 <= room2)) {  // also where it is no number
      const double most = room2 > 0.0 ? std::sqrt(room2 / off2) : 0.0;
      along = along > 0.0 ? most : -most;
      if (room2 < 0.0) {
        const double back = std::sqrt(lens_.radius2 / dot(foot, foot));
        foot = {foot.x * back, foot.y * back};
      }
    }
    return {foot.x - along * a.apex.y, foot.y + along * a.apex.x};
  }

  /// Half the solid angle, at the centre of one of the two balls, of the tetrahedron from the three
  /// centres to an end of the chord; in [0, pi]. As a function of the height and the half of the
  /// chord it goes with half_angle(): what rounding takes from one it gives to the other.
  [[nodiscard]] HalfPlane half_solid_angle(const Chord& chord, std::size_t ball,
                                           double radius) const {
    const double along = chord.along[ball];
    const double off = chord.apex_distance;
    const double square = along * along + off * off;
    const double length = square < kLeastSquare ? std::hypot(along, off) : std::sqrt(square);
    const double beyond = along >= 0.0 ? length + along : off * (off / (length - along));
    const double above = above_far_pole(radius, lens_.height[ball], lens_.radius2);
    return {above * beyond + off * chord.height, off * chord.half};
  }

 private:
  Lens<3> lens_;
  Sphere<3> first_, second_;
  std::array<std::array<double, 3>, 2> across_{};
};

/// How far from the plane of three centres the two points are where their spheres meet: half the
/// chord in the frame of each pair. Told by the pair with the smallest circle; the same double
/// whatever the pair at hand is, as long as the balls come in one order.
[[nodiscard]] inline double meeting_height(const Sphere<3>& a, const Sphere<3>& b,
                                           const Sphere<3>& c) {
  const double ab = rough_circle2(a, b), ac = rough_circle2(a, c), bc = rough_circle2(b, c);
  const auto of_pair = [](const Sphere<3>& first, const Sphere<3>& second, const Sphere<3>& third) {
    const Lens<3> pair = lens(first, second);
    const std::array<double, 3> to0 = difference(third, first), to1 = difference(third, second);
    const bool nearer = inner(to1, to1) < inner(to0, to0);
    const auto& to = nearer ? to1 : to0;
    const auto& e = pair.axis;
    std::array<double, 3> off{to[1] * e[2] - to[2] * e[1], to[2] * e[0] - to[0] * e[2],
                              to[0] * e[1] - to[1] * e[0]};
    const double off2 = inner(off, off), along = inner(to, e);
    double distance = std::sqrt(off2);
    if (off2 < kLeastSquare) {
      for (double& x : off) x *= kEnlarging;
      distance = std::sqrt(inner(off, off)) / kEnlarging;
    }
    const double height_of_plane = nearer ? -pair.height[1] : pair.height[0];
    const double level = (off2 + along * (along - 2 * height_of_plane) +
                          ((nearer ? second : first).weight - third.weight)) /
                         2;
    double height = 0.0;
    if (distance > 0.0) height = std::clamp(level / distance, -pair.radius, pair.radius);
    return std::sqrt((pair.radius - height) * (pair.radius + height));
  };
  if (ab <= ac && ab <= bc) return of_pair(a, b, c);
  return ac <= bc ? of_pair(a, c, b) : of_pair(b, c, a);
}

/// The angle from one apex to the next one counterclockwise, in [0, pi] radians: the dihedral angle
/// of their tetrahedron at the axis.
[[nodiscard]] inline HalfPlane angle_between(InLens a, InLens b) {
  return {dot(a, b), std::max(0.0, cross(a, b))};
}

}  // namespace orthoball
