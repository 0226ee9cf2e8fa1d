// SPDX-License-Identifier: MIT
//
// Balls that touch D + 1 given ones from outside: with the first centre as origin, the differences
// of |x - c_i| = r_i + t are linear in x and t, so that x = a + t b, and the first is a quadratic
// equation for t.
#include "orthoball/queries/inscribed_ball.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "orthoball/vectors.h"

namespace orthoball {
namespace {

template <int D>
using Vector = std::array<double, std::size_t{D}>;

double determinant(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }
double determinant(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// x with rows[i] . x = values[i], by Cramer's rule; not finite where there is none.
template <int D>
Vector<D> solution(const std::array<Vector<D>, std::size_t{D}>& rows, const Vector<D>& values) {
  std::array<Vector<D>, std::size_t{D}> columns;  // of the matrix
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t j = 0; j < D; ++j) columns[j][i] = rows[i][j];
  }
  const auto size = [](const auto& c) {
    if constexpr (D == 2) return determinant(c[0], c[1]);
    if constexpr (D == 3) return determinant(c[0], c[1], c[2]);
  };
  const double all = size(columns);
  Vector<D> x;
  for (std::size_t j = 0; j < D; ++j) {
    auto with_values = columns;
    with_values[j] = values;
    x[j] = size(with_values) / all;
  }
  return x;
}

// The points of equal power to some balls and, beside them, how these move with a radius that is
// added to all: x = at + t * by.
template <int D>
struct Line {
  Vector<D> at{}, by{};
};
template <int D>
Line<D> equal_distances(const std::array<Sphere<D>, std::size_t{D} + 1>& balls, bool by_power) {
  std::array<Vector<D>, std::size_t{D}> rows{};
  Vector<D> values{}, slopes{};
  const Sphere<D>& origin = balls[0];
  for (std::size_t i = 0; i < D; ++i) {
    const Sphere<D>& ball = balls[i + 1];
    for (std::size_t axis = 0; axis < D; ++axis) rows[i][axis] = ball.x[axis] - origin.x[axis];
    const double difference = by_power
                                  ? origin.weight - ball.weight
                                  : (origin.radius - ball.radius) * (origin.radius + ball.radius);
    values[i] = (inner(rows[i], rows[i]) + difference) / 2;
    slopes[i] = origin.radius - ball.radius;
  }
  return {solution<D>(rows, values), solution<D>(rows, slopes)};
}

template <int D>
Vector<D> moved(const Vector<D>& from, const Vector<D>& by) {
  Vector<D> to = from;
  for (std::size_t axis = 0; axis < D; ++axis) to[axis] += by[axis];
  return to;
}

// The one or two radii of balls that touch all; not finite where there are none.
template <int D>
std::array<double, 2> touching_radii(const Line<D>& line, double first_radius) {
  const double a = inner(line.by, line.by) - 1.0;
  const double b = inner(line.at, line.by) - first_radius;
  const double c = inner(line.at, line.at) - first_radius * first_radius;
  // Without cancellation: the larger root in size, the other by the product of both.
  const double root = std::sqrt(b * b - a * c);
  const double sum = b >= 0.0 ? -b - root : -b + root;
  return {sum / a, c / sum};
}

template <int D>
std::array<Sphere<D>, std::size_t{D} + 1> nearest(const Vector<D>& point,
                                                  std::span<const Sphere<D>> balls) {
  std::array<Sphere<D>, std::size_t{D} + 1> result;
  std::array<double, std::size_t{D} + 1> gaps;
  gaps.fill(std::numeric_limits<double>::infinity());
  for (const Sphere<D>& ball : balls) {
    Vector<D> to{};
    for (std::size_t axis = 0; axis < D; ++axis) to[axis] = point[axis] - ball.x[axis];
    const double gap = std::sqrt(inner(to, to)) - ball.radius;
    if (gap >= gaps.back()) continue;
    std::size_t place = D;
    for (; place > 0 && gap < gaps[place - 1]; --place) {
      gaps[place] = gaps[place - 1];
      result[place] = result[place - 1];
    }
    gaps[place] = gap;
    result[place] = ball;
  }
  return result;
}

}  // namespace

template <int D>
Vector<D> point_of_equal_power(const std::array<Sphere<D>, std::size_t{D} + 1>& balls) {
  return moved<D>(balls[0].x, equal_distances<D>(balls, true).at);
}

template <int D>
InscribedBall<D> ball_around(const std::array<double, std::size_t{D}>& centre,
                             std::span<const Sphere<D>> balls) {
  double radius = std::numeric_limits<double>::infinity();
  for (const double x : centre) {
    if (!std::isfinite(x)) return {centre, -radius};
  }
  for (const Sphere<D>& ball : balls) {
    Vector<D> to{};
    for (std::size_t axis = 0; axis < D; ++axis) to[axis] = centre[axis] - ball.x[axis];
    radius = std::min(radius, std::sqrt(inner(to, to)) - ball.radius);
  }
  return {centre, radius};
}

template <int D>
InscribedBall<D> inscribed_ball(const std::array<double, std::size_t{D}>& start,
                                std::span<const Sphere<D>> balls) {
  constexpr int kMostSteps = 64;
  InscribedBall<D> best = ball_around<D>(start, balls);
  if (!(best.radius >= 0.0)) return {start, -std::numeric_limits<double>::infinity()};
  for (int step = 0; step < kMostSteps; ++step) {
    const auto around = nearest<D>(best.centre, balls);
    const Line<D> line = equal_distances<D>(around, false);
    InscribedBall<D> found = best;
    for (const double radius : touching_radii<D>(line, around[0].radius)) {
      Vector<D> step_to = line.at;
      for (std::size_t axis = 0; axis < D; ++axis) step_to[axis] += radius * line.by[axis];
      const InscribedBall<D> candidate = ball_around<D>(moved<D>(around[0].x, step_to), balls);
      Vector<D> way{};
      for (std::size_t axis = 0; axis < D; ++axis) {
        way[axis] = candidate.centre[axis] - best.centre[axis];
      }
      const bool is_connected = std::sqrt(inner(way, way)) < best.radius + candidate.radius;
      if (is_connected && candidate.radius > found.radius) found = candidate;
    }
    if (!(found.radius > best.radius)) break;
    best = found;
  }
  return best;
}

template Vector<2> point_of_equal_power(const std::array<Sphere<2>, 3>&);
template Vector<3> point_of_equal_power(const std::array<Sphere<3>, 4>&);
template InscribedBall<2> ball_around(const std::array<double, 2>&, std::span<const Sphere<2>>);
template InscribedBall<3> ball_around(const std::array<double, 3>&, std::span<const Sphere<3>>);
template InscribedBall<2> inscribed_ball(const std::array<double, 2>&, std::span<const Sphere<2>>);
template InscribedBall<3> inscribed_ball(const std::array<double, 3>&, std::span<const Sphere<3>>);

}  // namespace orthoball
