// SPDX-License-Identifier: MIT
#include "oracles/cut_ball.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace orthoball::oracles {
namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
void add(Vector& to, double times, const Vector& what) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += times * what[i];
}
double norm(const Vector& a) { return std::sqrt(dot(a, a)); }

// What is left of a vector across orthonormal ones.
Vector across(Vector vector, const std::vector<Vector>& basis) {
  for (int twice = 0; twice < 2; ++twice) {
    for (const Vector& unit : basis) add(vector, -dot(vector, unit), unit);
  }
  return vector;
}

bool is_nearly_inside(const Vector& x, const std::vector<HalfSpace>& cuts, double slack) {
  return std::all_of(cuts.begin(), cuts.end(), [&](const HalfSpace& cut) {
    return dot(cut.normal, x) <= cut.offset + slack;
  });
}

// First coordinates at which slices change: the first and last points of the spheres in which the
// ball's sphere meets the planes of up to D cuts.
class Events {
 public:
  explicit Events(const CutBall& ball) : ball_(ball) {
    visit(0, {}, ball.centre);
    std::sort(at_.begin(), at_.end());
  }
  [[nodiscard]] const std::vector<double>& at() const { return at_; }

 private:
  void visit(std::size_t next, const std::vector<Vector>& normals, const Vector& centre) {
    Vector offset = centre;
    add(offset, -1.0, ball_.centre);
    const double radius2 = ball_.radius * ball_.radius - dot(offset, offset);
    if (radius2 < 0.0) return;
    Vector first(centre.size());
    first[0] = 1.0;
    const Vector along = across(first, normals);
    const double length = normals.size() == centre.size() ? 0.0 : norm(along);
    for (const double side : {-1.0, 1.0}) {
      Vector x = centre;
      if (length > 1e-12) add(x, side * std::sqrt(radius2) / length, along);
      if (is_nearly_inside(x, ball_.cuts, 1e-9 * ball_.radius)) at_.push_back(x[0]);
    }
    if (normals.size() == centre.size()) return;
    for (std::size_t i = next; i < ball_.cuts.size(); ++i) {
      Vector normal = across(ball_.cuts[i].normal, normals);
      const double size = norm(normal);
      if (size < 1e-9) continue;
      for (double& x : normal) x /= size;
      Vector moved = centre;
      add(moved, (ball_.cuts[i].offset - dot(ball_.cuts[i].normal, centre)) / size, normal);
      std::vector<Vector> more = normals;
      more.push_back(normal);
      visit(i + 1, more, moved);
    }
  }

  const CutBall& ball_;
  std::vector<double> at_;
};

// The integral of a function of the first coordinate, which may begin and end like a root between
// any two events. Halved where halves tell more, for it may bend close by.
template <class Function>
class Integral {
 public:
  Integral(const CutBall& ball, const Function& function) : function_(function) {
    error_ = 1e-13 * std::pow(ball.radius, static_cast<double>(ball.centre.size()));
    const Events events(ball);
    for (std::size_t i = 1; i < events.at().size(); ++i) {
      const double low = events.at()[i - 1], high = events.at()[i];
      if (high - low > 1e-15 * ball.radius) value_ += refined(low, high, between(low, high), 20);
    }
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  [[nodiscard]] double between(double low, double high) const {
    const double half = (high - low) / 2;
    return boost::math::quadrature::gauss<double, 20>::integrate(
        [&](double turn) {
          const double quarter = std::sin(turn / 2);
          return half * std::sin(turn) * function_(low + 2 * half * quarter * quarter);
        },
        0.0, std::numbers::pi);
  }
  [[nodiscard]] double refined(double low, double high, double whole, int depth) const {
    const double middle = (low + high) / 2;
    const double left = between(low, middle), right = between(middle, high);
    if (depth == 0 || std::abs(left + right - whole) <= error_) return left + right;
    return refined(low, middle, left, depth - 1) + refined(middle, high, right, depth - 1);
  }

  const Function& function_;
  double error_ = 0.0;
  double value_ = 0.0;
};

template <class Function>
double integral(const CutBall& ball, const Function& function) {
  return Integral<Function>(ball, function).value();
}

CutBall slice(const CutBall& ball, double x) {
  const double off = x - ball.centre[0];
  CutBall result;
  result.centre.assign(ball.centre.begin() + 1, ball.centre.end());
  result.radius = std::sqrt(std::max(0.0, (ball.radius - off) * (ball.radius + off)));
  for (const HalfSpace& cut : ball.cuts) {
    result.cuts.push_back({{cut.normal.begin() + 1, cut.normal.end()}, cut.offset});
    result.cuts.back().offset -= cut.normal[0] * x;
  }
  return result;
}

// Of a segment, or of a disk at a first coordinate.
double interval(const CutBall& ball, double x = 0.0) {
  const std::size_t axis = ball.centre.size() - 1;
  const double off = axis == 1 ? x - ball.centre[0] : 0.0;
  const double half = std::sqrt(std::max(0.0, (ball.radius - off) * (ball.radius + off)));
  double low = ball.centre[axis] - half, high = ball.centre[axis] + half;
  for (const HalfSpace& cut : ball.cuts) {
    const double n = cut.normal[axis];
    const double offset = axis == 1 ? cut.offset - cut.normal[0] * x : cut.offset;
    if (n > 0.0) high = std::min(high, offset / n);
    if (n < 0.0) low = std::max(low, offset / n);
    if (n == 0.0 && offset < 0.0) return 0.0;
  }
  return std::max(0.0, high - low);
}

// Of the circle inside the cuts: the angle of those arcs between cuts whose middles are.
double angle(const CutBall& disk) {
  std::vector<double> ends{0.0, 2 * std::numbers::pi};
  for (const HalfSpace& cut : disk.cuts) {
    const double size = norm(cut.normal) * disk.radius;
    const double beyond = cut.offset - dot(cut.normal, disk.centre);
    if (std::abs(beyond) >= size) continue;
    const double towards = std::atan2(cut.normal[1], cut.normal[0]);
    const double half = std::acos(beyond / size);
    for (const double end : {towards - half, towards + half}) {
      ends.push_back(end - 2 * std::numbers::pi * std::floor(end / (2 * std::numbers::pi)));
    }
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double middle = (ends[i - 1] + ends[i]) / 2;
    const Vector x{disk.centre[0] + disk.radius * std::cos(middle),
                   disk.centre[1] + disk.radius * std::sin(middle)};
    if (is_nearly_inside(x, disk.cuts, 0.0)) sum += ends[i] - ends[i - 1];
  }
  return sum;
}

}  // namespace

HalfSpace where_power_is_less(const CutBall& one, const CutBall& other) {
  HalfSpace result{other.centre, 0.0};
  add(result.normal, -1.0, one.centre);
  const double size = norm(result.normal);
  const double twice = dot(other.centre, other.centre) - dot(one.centre, one.centre) +
                       (one.radius - other.radius) * (one.radius + other.radius);
  if (size == 0.0) return {result.normal, twice};
  for (double& x : result.normal) x /= size;
  result.offset = twice / (2 * size);
  return result;
}

HalfSpace where_power_is_more(const CutBall& one, const CutBall& other) {
  return where_power_is_less(other, one);
}

double volume(const CutBall& ball) {
  if (ball.centre.size() == 1) return interval(ball);
  if (ball.centre.size() == 2) {
    return integral(ball, [&](double x) { return interval(ball, x); });
  }
  return integral(ball, [&](double x) { return volume(slice(ball, x)); });
}

double area(const CutBall& ball) {
  if (ball.centre.size() == 1) {
    double count = 0.0;
    for (const double x : {ball.centre[0] - ball.radius, ball.centre[0] + ball.radius}) {
      if (is_nearly_inside({x}, ball.cuts, 0.0)) count += 1.0;
    }
    return count;
  }
  if (ball.centre.size() == 2) return ball.radius * angle(ball);
  return ball.radius * integral(ball, [&](double x) { return angle(slice(ball, x)); });
}

CutBall facet(const CutBall& ball, std::size_t cut) {
  const HalfSpace& plane = ball.cuts[cut];
  const std::size_t dimension = ball.centre.size();
  const double off = plane.offset - dot(plane.normal, ball.centre);
  Vector centre = ball.centre;
  add(centre, off, plane.normal);

  std::vector<Vector> basis{plane.normal};
  for (std::size_t axis = 0; axis < dimension && basis.size() < dimension; ++axis) {
    Vector unit(dimension);
    unit[axis] = 1.0;
    unit = across(unit, basis);
    const double size = norm(unit);
    if (size < 0.5) continue;  // another axis is farther from those
    for (double& x : unit) x /= size;
    basis.push_back(unit);
  }

  CutBall result;
  result.centre.assign(dimension - 1, 0.0);
  result.radius = std::sqrt(std::max(0.0, (ball.radius - off) * (ball.radius + off)));
  for (std::size_t i = 0; i < ball.cuts.size(); ++i) {
    if (i == cut) continue;
    HalfSpace seen{{}, ball.cuts[i].offset - dot(ball.cuts[i].normal, centre)};
    for (std::size_t k = 1; k < dimension; ++k) {
      seen.normal.push_back(dot(ball.cuts[i].normal, basis[k]));
    }
    result.cuts.push_back(seen);
  }
  if (off * off > ball.radius * ball.radius) {
    result.cuts.push_back({Vector(dimension - 1), -1.0});  // the plane misses the ball
  }
  return result;
}

}  // namespace orthoball::oracles
