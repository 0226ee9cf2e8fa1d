// SPDX-License-Identifier: MIT
#include "oracles/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace orthoball::oracles {

namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Vector& a) { return std::sqrt(dot(a, a)); }

// Edge vectors are differences taken exactly and rounded once.
class Geometry {
 public:
  Geometry(const ExactPoints& points, int exponent) : points_(points), unit_(points.unit) {
    const Integer power = Integer(1) << std::abs(exponent);
    unit_ *= exponent < 0 ? Rational(power) : Rational(1, power);
  }

  [[nodiscard]] Vector edge(std::uint32_t from, std::uint32_t to) const {
    Vector vector{};
    for (std::size_t axis = 0; axis < points_.position[from].size(); ++axis) {
      vector[axis] = nearest_double(
          Rational(points_.position[to][axis] - points_.position[from][axis]) * unit_);
    }
    return vector;
  }
  [[nodiscard]] double length(const std::vector<std::uint32_t>& rows) const {
    return norm(edge(rows[0], rows[1]));
  }
  [[nodiscard]] double area(const std::vector<std::uint32_t>& rows) const {
    return norm(cross(edge(rows[0], rows[1]), edge(rows[0], rows[2]))) / 2;
  }
  // By the exact determinant.
  [[nodiscard]] double volume(const std::vector<std::uint32_t>& rows) const {
    std::vector<std::vector<Integer>> matrix;
    Rational unit = 1;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      auto& row = matrix.emplace_back();
      for (std::size_t axis = 0; axis + 1 < rows.size(); ++axis) {
        row.push_back(points_.position[rows[i]][axis] - points_.position[rows[0]][axis]);
      }
      unit *= unit_;
      unit /= static_cast<int>(i);
    }
    unit *= determinant(matrix);
    return std::abs(nearest_double(unit));
  }
  // The angle of the tetrahedron at the edge from its corner a to b.
  [[nodiscard]] double dihedral(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint32_t d) const {
    const Vector along = edge(a, b);
    const Vector left = cross(along, edge(a, c)), right = cross(along, edge(a, d));
    return std::atan2(norm(cross(left, right)), dot(left, right));
  }

 private:
  const ExactPoints& points_;
  Rational unit_;
};

void add(Measure& measure, double term) {
  measure.value += term;
  measure.magnitude += std::abs(term);
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
  const Geometry unscaled(points, 0);
  double largest = 0.0;
  for (std::size_t row = 1; row < points.position.size(); ++row) {
    for (const double x : unscaled.edge(0, static_cast<std::uint32_t>(row))) {
      largest = std::max(largest, std::min(std::abs(x), 0x1.fp1023));
    }
  }
  std::frexp(largest, &result.exponent);
  const Geometry geometry(points, result.exponent);

  const int dimension = points.dimension;
  for (const BruteSimplex& simplex : filtration.simplices) {
    if (simplex.enters > index) continue;
    if (simplex.dimension() == dimension) add(result.volume, geometry.volume(simplex.rows));
    if (dimension == 3) add_length(result.length, geometry, simplex.rows);
    if (simplex.dimension() != dimension - 1 || simplex.interior <= index) continue;
    const double area =
        dimension == 2 ? geometry.length(simplex.rows) : geometry.area(simplex.rows);
    const bool is_singular = index < simplex.regular;
    add(is_singular ? result.area_singular : result.area_regular, area);
    add(result.area, is_singular ? 2 * area : area);
  }
  return result;
}

}  // namespace orthoball::oracles
