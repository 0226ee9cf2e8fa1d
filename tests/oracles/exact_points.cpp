// SPDX-License-Identifier: MIT
#include "oracles/exact_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace orthoball::oracles {

namespace {

// The exponent of the lowest bit that is set; the largest int for zero.
int lowest_exponent(double value) {
  if (value == 0.0) return std::numeric_limits<int>::max();
  int exponent = 0;
  const auto bits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  return exponent - 53 + static_cast<int>(boost::multiprecision::lsb(Integer(std::abs(bits))));
}

int lowest_exponent(std::span<const double> values) {
  int lowest = std::numeric_limits<int>::max();
  for (const double value : values) lowest = std::min(lowest, lowest_exponent(value));
  return lowest;
}

// value / 2^exponent, which is an integer.
Integer scaled(double value, int exponent) {
  if (value == 0.0) return 0;
  const int own = lowest_exponent(value);
  return Integer(static_cast<std::int64_t>(std::ldexp(value, -own))) << (own - exponent);
}

Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << std::abs(exponent);
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

int floor_half(int value) { return value >= 0 ? value / 2 : -((1 - value) / 2); }

}  // namespace

ExactPoints exact_points(const WeightedPoints& points) {
  const auto dimension = static_cast<std::size_t>(points.dimension());
  const bool has_radii = points.weight_kind() == WeightKind::radius;

  // One exponent for all lengths; weights have twice that.
  int exponent = lowest_exponent(points.coordinates());
  const int of_weights =
      std::min(lowest_exponent(points.weights()), lowest_exponent(points.weights_low()));
  if (of_weights != std::numeric_limits<int>::max()) {
    exponent = std::min(exponent, has_radii ? of_weights : floor_half(of_weights));
  }
  if (exponent == std::numeric_limits<int>::max()) exponent = 0;

  ExactPoints exact{points.dimension(), power_of_two(exponent), {}, {}};
  if (points.decimals()) {
    exact.unit /=
        boost::multiprecision::pow(Integer(10), static_cast<unsigned>(*points.decimals()));
  }
  for (std::size_t row = 0; row < points.size(); ++row) {
    std::vector<Integer>& position = exact.position.emplace_back();
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      position.push_back(scaled(points.coordinates()[dimension * row + axis], exponent));
    }
    Integer weight = 0;
    if (has_radii) {
      const Integer radius = scaled(points.weights()[row], exponent);
      weight = radius * boost::multiprecision::abs(radius);
    } else if (points.weight_kind() == WeightKind::weight) {
      weight = scaled(points.weights()[row], 2 * exponent);
      if (!points.weights_low().empty()) weight += scaled(points.weights_low()[row], 2 * exponent);
    }
    exact.weight.push_back(weight);
  }
  return exact;
}

double nearest_double(const Rational& value) {
  const Integer numerator = boost::multiprecision::abs(boost::multiprecision::numerator(value));
  const Integer denominator = boost::multiprecision::denominator(value);
  if (numerator == 0) return 0.0;

  // value = quotient * 2^exponent with a quotient of 53 bits, fewer for subnormals.
  int exponent = std::max(static_cast<int>(boost::multiprecision::msb(numerator)) -
                              static_cast<int>(boost::multiprecision::msb(denominator)) - 53,
                          -1074);
  Integer quotient, remainder, divisor;
  const auto divide = [&] {
    divisor = exponent > 0 ? Integer(denominator << exponent) : denominator;
    const Integer dividend = exponent < 0 ? Integer(numerator << -exponent) : numerator;
    boost::multiprecision::divide_qr(dividend, divisor, quotient, remainder);
  };
  divide();
  if (quotient >= Integer(1) << 53) {
    ++exponent;
    divide();
  }
  const int half = Integer(2 * remainder).compare(divisor);
  if (half > 0 || (half == 0 && boost::multiprecision::bit_test(quotient, 0))) ++quotient;
  const double magnitude = std::ldexp(quotient.convert_to<double>(), exponent);
  return value < 0 ? -magnitude : magnitude;
}

Integer determinant(const std::vector<std::vector<Integer>>& matrix) {
  if (matrix.empty()) return 1;
  if (matrix.size() == 1) return matrix[0][0];
  Integer sum = 0;
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    if (matrix[row][0] == 0) continue;
    std::vector<std::vector<Integer>> minor;
    for (std::size_t other = 0; other < matrix.size(); ++other) {
      if (other != row) minor.emplace_back(matrix[other].begin() + 1, matrix[other].end());
    }
    const Integer term = matrix[row][0] * determinant(minor);
    if (row % 2 == 0) {
      sum += term;
    } else {
      sum -= term;
    }
  }
  return sum;
}

}  // namespace orthoball::oracles
