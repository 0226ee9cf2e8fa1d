// SPDX-License-Identifier: MIT
//
// Every ball's part is a ball cut by the half-spaces in which its power is larger than that of
// another. By the divergence theorem its volume is a third of radius times spherical area, less
// height times area, over the disks in which planes cut it; these areas follow the same way from
// arcs and chords. Spherical areas are sectors beside the arcs and the solid angles between them.
//
// Naiman, Wynn. Inclusion-exclusion-Bonferroni identities and inequalities for discrete tube-like
// problems via Euler characteristics. Annals of Statistics 20 (1992): that these overlaps suffice.
// Edelsbrunner. The union of balls and its dual shape. Discrete & Computational Geometry 13 (1995).
#include "orthoball/measures/ball_overlaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "orthoball/error.h"
#include "orthoball/measures/lens.h"

namespace orthoball {
namespace {

template <int D>
using Spheres = std::array<Sphere<D>, std::size_t{D} + 1>;

template <int D>
Spheres<D> checked(std::span<const Ball<D>> balls) {
  if (balls.empty() || balls.size() > std::size_t{D} + 1) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "an overlap is of 1 to " + std::to_string(D + 1) + " balls, not of " +
                         std::to_string(balls.size()));
  }
  Spheres<D> spheres{};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    bool is_finite = std::isfinite(balls[i].radius);
    for (const double x : balls[i].centre) is_finite = is_finite && std::isfinite(x);
    if (!is_finite || balls[i].radius < 0.0) {
      throw InputError(
          is_finite ? InputError::Reason::wrong_argument : InputError::Reason::not_finite, i,
          "ball " + std::to_string(i) +
              ": centre and radius must be finite and the radius not negative");
    }
    spheres[i] = {balls[i].centre, balls[i].radius * balls[i].radius, balls[i].radius};
  }
  return spheres;
}

// The solid angle at each ball between the circles with two others, twice for three balls, for
// which it is there on both sides. The frame of the smaller circle tells it best.
class SolidAngles {
 public:
  void tell(const LensFrame& frame, const Chord& chord, const Spheres<3>& spheres, std::size_t i,
            std::size_t j, std::size_t k) {
    tell_one(frame.lens().radius2, i, 6 - i - j - k,
             2 * angle(frame.half_solid_angle(chord, 0, spheres[i].radius)));
    tell_one(frame.lens().radius2, j, 6 - i - j - k,
             2 * angle(frame.half_solid_angle(chord, 1, spheres[j].radius)));
  }
  [[nodiscard]] double sum(std::size_t ball) const {
    double sum = 0.0;
    for (const double angle : angles_[ball]) sum += angle;
    return sum;
  }

 private:
  void tell_one(double circle2, std::size_t ball, std::size_t left_out, double angle) {
    if (circle2 >= circles_[ball][left_out]) return;
    circles_[ball][left_out] = circle2;
    angles_[ball][left_out] = angle;
  }
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  std::array<std::array<double, 4>, 4> circles_{{{kNone, kNone, kNone, kNone},
                                                 {kNone, kNone, kNone, kNone},
                                                 {kNone, kNone, kNone, kNone},
                                                 {kNone, kNone, kNone, kNone}}};
  std::array<std::array<double, 4>, 4> angles_{};  // [ball][the one that is neither]
};

// What the other balls leave of the circle and the disk of two.
struct Disk {
  double angle = 2 * std::numbers::pi;  // of the arc
  double area = 0.0;
  double dihedral = 0.0;  // of the tetrahedron at the two centres
};

// What meets the disk beyond a line.
struct Other {
  Beyond beyond;
  Chord chord;
};

Disk disk_inside(const LensFrame& frame, std::span<const Other> others) {
  const double circle2 = frame.lens().radius2;
  Disk disk;
  if (others.size() == 1) {
    const Chord& chord = others[0].chord;
    disk.angle = 2 * angle(chord.half_angle());
    disk.area = (circle2 * disk.angle - chord.height * 2 * chord.half) / 2;
    return disk;
  }
  if (others.size() == 2) {
    const bool turns = cross(others[0].beyond.apex, others[1].beyond.apex) < 0.0;
    const Beyond &behind = others[turns ? 1 : 0].beyond, &ahead = others[turns ? 0 : 1].beyond;
    const Chord &a = others[turns ? 1 : 0].chord, &b = others[turns ? 0 : 1].chord;
    disk.dihedral = angle(angle_between(behind.apex, ahead.apex));
    disk.angle = std::max(0.0, angle(a.half_angle()) + angle(b.half_angle()) - disk.dihedral);
    const InLens meeting = frame.crossing(behind, ahead);
    const double on_a = a.half - cross(a.towards, meeting);
    const double on_b = b.half - cross(meeting, b.towards);
    disk.area = (circle2 * disk.angle - a.height * on_a - b.height * on_b) / 2;
    return disk;
  }
  disk.area = circle2 * std::numbers::pi;
  return disk;
}

BallOverlap<3> overlap(const Spheres<3>& spheres, std::size_t count) {
  BallOverlap<3> result;
  std::array<double, 4> beside{};  // [ball]: heights times the areas of disks
  SolidAngles solid;
  std::array<double, 4> dihedrals{};  // [ball]: their sum
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const LensFrame frame(spheres[i], spheres[j]);
      std::array<Other, 2> other;
      std::size_t others = 0;
      for (std::size_t k = 0; k < count; ++k) {
        if (k == i || k == j) continue;
        std::array<std::size_t, 3> order{i, j, k};
        std::sort(order.begin(), order.end());
        const Beyond beyond = frame.beyond(spheres[k]);
        const Chord chord = frame.chord(
            beyond, meeting_height(spheres[order[0]], spheres[order[1]], spheres[order[2]]));
        other[others++] = {beyond, chord};
        solid.tell(frame, chord, spheres, i, j, k);
      }
      const Disk disk = disk_inside(frame, std::span(other).first(others));
      result.arcs[i][j] = result.arcs[j][i] = frame.lens().radius * disk.angle;
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const std::size_t ball = end == 0 ? i : j;
        const double r = spheres[ball].radius, height = frame.lens().height[end];
        result.areas[ball] += r * (r - height) * disk.angle;
        beside[ball] += height * disk.area;
        dihedrals[ball] += disk.dihedral;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double r = spheres[i].radius;
    if (count == 1) result.areas[i] = 4 * std::numbers::pi * r * r;
    if (count == 3) result.areas[i] -= r * r * 2 * solid.sum(i);
    if (count == 4) {
      result.areas[i] += r * r * (dihedrals[i] - std::numbers::pi - solid.sum(i));
    }
    result.areas[i] = std::max(0.0, result.areas[i]);
    result.volumes[i] = std::max(0.0, (r * result.areas[i] - beside[i]) / 3);
  }
  return result;
}

BallOverlap<2> overlap(const Spheres<2>& spheres, std::size_t count) {
  BallOverlap<2> result;
  std::array<double, 3> angles{};  // [disk]: of the arc inside the others
  std::array<double, 3> beside{};  // [disk]: heights times lengths of chords
  if (count == 1) angles[0] = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const Lens<2> pair = lens(spheres[i], spheres[j]);
      double length = 2 * pair.radius;
      double share = 2;  // of the opening: both sides of the axis, or one
      if (count == 3) {
        length = pair.radius - offset_across(pair, spheres[i], spheres[3 - i - j]);
        share = 1;
      }
      angles[i] += share * angle(pair.opening(0));
      angles[j] += share * angle(pair.opening(1));
      beside[i] += pair.height[0] * length;
      beside[j] += pair.height[1] * length;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double r = spheres[i].radius;
    if (count == 3) {
      angles[i] -= corner_angle(spheres[i], spheres[(i + 1) % 3], spheres[(i + 2) % 3]);
    }
    result.areas[i] = r * std::max(0.0, angles[i]);
    result.volumes[i] = std::max(0.0, (r * result.areas[i] - beside[i]) / 2);
  }
  return result;
}

}  // namespace

template <int D>
BallOverlap<D> ball_overlap(std::span<const Ball<D>> balls) {
  BallOverlap<D> result = overlap(checked(balls), balls.size());
  for (const double volume : result.volumes) result.volume += volume;
  for (const double area : result.areas) result.area += area;
  return result;
}

template BallOverlap<2> ball_overlap<2>(std::span<const Ball<2>>);
template BallOverlap<3> ball_overlap<3>(std::span<const Ball<3>>);

}  // namespace orthoball
