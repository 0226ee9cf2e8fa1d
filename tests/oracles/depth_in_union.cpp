// SPDX-License-Identifier: MIT
#include "oracles/depth_in_union.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoball::oracles {
namespace {

using Point = std::array<double, 3>;

Point combined(const Point& a, double s, const Point& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
double inner(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Point& a) { return std::sqrt(inner(a, a)); }
Point minus(const Point& a, const Point& b) { return combined(a, -1.0, b); }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The circle of two spheres; radius^2 < 0 where they do not meet.
struct Circle {
  Point centre, axis;
  double radius2;
};
Circle circle_of(const SolidBall& a, const SolidBall& b) {
  const Point way = minus(b.centre, a.centre);
  const double d = norm(way);
  const double height = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  return {combined(a.centre, height / d, way), combined({}, 1 / d, way),
          a.radius * a.radius - height * height};
}

class Depth {
 public:
  Depth(const std::vector<SolidBall>& balls, const Point& point) : balls_(balls), point_(point) {}

  double found() {
    const std::size_t n = balls_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point way = minus(point_, balls_[i].centre);
      if (norm(way) > 0.0) {
        try_point(combined(balls_[i].centre, balls_[i].radius / norm(way), way));
      }
      for (std::size_t j = i + 1; j < n; ++j) {
        const Circle circle = circle_of(balls_[i], balls_[j]);
        if (!(circle.radius2 >= 0.0)) continue;
        try_circle(circle);
        for (std::size_t k = j + 1; k < n; ++k) try_meeting(circle, balls_[k]);
      }
    }
    return nearest_;
  }

 private:
  void try_point(const Point& at) {
    for (const SolidBall& ball : balls_) {
      if (norm(minus(at, ball.centre)) < ball.radius * (1 - 1e-9)) return;
    }
    nearest_ = std::min(nearest_, norm(minus(at, point_)));
  }
  void try_circle(const Circle& circle) {
    const Point way = minus(point_, circle.centre);
    const Point across = combined(way, -inner(way, circle.axis), circle.axis);
    if (norm(across) > 0.0) {
      try_point(combined(circle.centre, std::sqrt(circle.radius2) / norm(across), across));
    }
  }
  void try_meeting(const Circle& circle, const SolidBall& third) {
    const Point way = minus(third.centre, circle.centre);
    const Point across = combined(way, -inner(way, circle.axis), circle.axis);
    const double distance = norm(across);
    if (!(distance > 0.0)) return;
    const double level =
        (inner(way, way) + circle.radius2 - third.radius * third.radius) / (2 * distance);
    const double half2 = circle.radius2 - level * level;
    if (!(half2 >= 0.0)) return;
    const Point towards = combined({}, 1 / distance, across);
    const Point middle = combined(circle.centre, level, towards);
    for (const double side : {-1.0, 1.0}) {
      try_point(combined(middle, side * std::sqrt(half2), cross(circle.axis, towards)));
    }
  }

  const std::vector<SolidBall>& balls_;
  Point point_;
  double nearest_ = std::numeric_limits<double>::infinity();
};

}  // namespace

double depth_in_union(const std::vector<SolidBall>& balls, const std::array<double, 3>& point) {
  const bool is_inside = std::any_of(balls.begin(), balls.end(), [&](const SolidBall& ball) {
    return norm(minus(point, ball.centre)) < ball.radius;
  });
  return is_inside ? Depth(balls, point).found() : 0.0;
}

}  // namespace orthoball::oracles
