// SPDX-License-Identifier: MIT
#include "oracles/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace orthoball::oracles {

namespace {

using Vector = std::vector<Integer>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Integer dot(const Vector& a, const Vector& b) {
  Integer sum = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += a[axis] * b[axis];
  return sum;
}
int exponent_of(const Integer& value) {
  return value == 0 ? 0 : static_cast<int>(boost::multiprecision::msb(abs(value)));
}
// A number whose magnitude a double may not hold, as value * 2^exponent.
struct Scaled {
  double value = 0.0;
  int exponent = 0;
};
Scaled scaled(const Integer& value) {
  const int exponent = exponent_of(value);
  return {nearest_double(Rational(value, Integer(1) << exponent)), exponent};
}
Scaled square_root(const Integer& value) {
  const int exponent = exponent_of(value) / 2;
  return {std::sqrt(nearest_double(Rational(value, Integer(1) << 2 * exponent))), exponent};
}

// Everything is exact until a root or an angle is taken of it.
class Geometry {
 public:
  Geometry(const ExactPoints& points, int exponent)
      : points_(points), unit_(scaled_unit(points.unit, exponent)) {}

  [[nodiscard]] Vector edge(std::uint32_t from, std::uint32_t to) const {
    Vector vector;
    for (std::size_t axis = 0; axis < points_.position[from].size(); ++axis) {
      vector.push_back(points_.position[to][axis] - points_.position[from][axis]);
    }
    return vector;
  }
  [[nodiscard]] double length(const std::vector<std::uint32_t>& rows) const {
    const Vector along = edge(rows[0], rows[1]);
    return in_units(square_root(dot(along, along)), 1);
  }
  [[nodiscard]] double area(const std::vector<std::uint32_t>& rows) const {
    const Vector normal = cross(edge(rows[0], rows[1]), edge(rows[0], rows[2]));
    return in_units(square_root(dot(normal, normal)), 2) / 2;
  }
  // Of a triangle: the products of its edges, of which its area may be a small difference.
  [[nodiscard]] double products_of_edges(const std::vector<std::uint32_t>& rows) const {
    if (rows.size() != 3) return 0.0;
    const double a = length({rows[1], rows[2]}), b = length({rows[0], rows[2]});
    const double c = length({rows[0], rows[1]});
    return a * b + b * c + c * a;
  }
  [[nodiscard]] double volume(const std::vector<std::uint32_t>& rows) const {
    std::vector<Vector> edges;
    int factorial = 1;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      edges.push_back(edge(rows[0], rows[i]));
      factorial *= static_cast<int>(i);
    }
    return std::abs(in_units(scaled(determinant(edges)), static_cast<int>(edges.size()))) /
           factorial;
  }
  // The angle of the tetrahedron at the edge from its corner a to b: the cross product of the two
  // normals there is the edge times the determinant.
  [[nodiscard]] double dihedral(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint32_t d) const {
    const Vector along = edge(a, b), to_c = edge(a, c), to_d = edge(a, d);
    const Integer volume = determinant({along, to_c, to_d});
    const Scaled sine = square_root(dot(along, along) * volume * volume);
    const Scaled cosine = scaled(dot(cross(along, to_c), cross(along, to_d)));
    const int largest = std::max(sine.exponent, cosine.exponent);
    return std::atan2(std::ldexp(sine.value, sine.exponent - largest),
                      std::ldexp(cosine.value, cosine.exponent - largest));
  }

 private:
  static Scaled scaled_unit(const Rational& unit, int exponent) {
    Scaled result;
    result.value = std::frexp(nearest_double(unit), &result.exponent);
    result.exponent -= exponent;
    return result;
  }
  [[nodiscard]] double in_units(const Scaled& value, int power) const {
    double result = value.value;
    for (int i = 0; i < power; ++i) result *= unit_.value;
    return std::ldexp(result, value.exponent + power * unit_.exponent);
  }

  const ExactPoints& points_;
  Scaled unit_;
};

void add(Measure& measure, double term, double magnitude = 0.0) {
  measure.value += term;
  measure.magnitude += std::max(std::abs(term), magnitude);
}

void add_length(Measure& length, const Geometry& geometry, const std::vector<std::uint32_t>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      const double edge = geometry.length({rows[i], rows[j]});
      if (rows.size() == 2) add(length, 2 * std::numbers::pi * edge);
      if (rows.size() == 3) add(length, -std::numbers::pi * edge);
      if (rows.size() != 4) continue;
      std::vector<std::uint32_t> others = rows;
      std::erase_if(others, [&](auto row) { return row == rows[i] || row == rows[j]; });
      add(length,
          edge * (std::numbers::pi - geometry.dihedral(rows[i], rows[j], others[0], others[1])));
      length.magnitude += edge;  // the angle is rounded too
    }
  }
}

}  // namespace

Measures measures(const ExactPoints& points, const BruteForce& filtration, std::uint32_t index) {
  Measures result;
  Integer largest = 1;
  for (const auto& position : points.position) {
    for (std::size_t axis = 0; axis < position.size(); ++axis) {
      largest = std::max(largest, Integer(abs(position[axis] - points.position[0][axis])));
    }
  }
  std::frexp(nearest_double(points.unit), &result.exponent);
  result.exponent += exponent_of(largest) + 1;
  const Geometry geometry(points, result.exponent);

  const int dimension = points.dimension;
  for (const BruteSimplex& simplex : filtration.simplices) {
    if (simplex.enters > index) continue;
    if (simplex.dimension() == dimension) {
      add(result.volume, geometry.volume(simplex.rows), geometry.products_of_edges(simplex.rows));
    }
    if (dimension == 3) add_length(result.length, geometry, simplex.rows);
    if (simplex.dimension() != dimension - 1 || simplex.interior <= index) continue;
    const double area =
        dimension == 2 ? geometry.length(simplex.rows) : geometry.area(simplex.rows);
    const bool is_singular = index < simplex.regular;
    const double products = geometry.products_of_edges(simplex.rows);
    add(is_singular ? result.area_singular : result.area_regular, area, products);
    add(result.area, is_singular ? 2 * area : area, products);
  }
  return result;
}

}  // namespace orthoball::oracles
