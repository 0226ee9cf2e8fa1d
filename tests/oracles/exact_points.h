// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "orthoball/points/weighted_points.h"

namespace orthoball::oracles {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

/// Weighted points as the rational numbers they are: integers times one unit. Any finite input.
struct ExactPoints {
  int dimension = 0;
  Rational unit = 1;                           ///< of lengths, in input units; weights: unit^2
  std::vector<std::vector<Integer>> position;  ///< [row][axis]
  std::vector<Integer> weight;                 ///< [row]
};

[[nodiscard]] ExactPoints exact_points(const WeightedPoints& points);

/// Correctly rounded, ties to even; infinite beyond the double range, subnormals included.
[[nodiscard]] double nearest_double(const Rational& value);

/// Of a square matrix, by Laplace's expansion; 1 for an empty one.
[[nodiscard]] Integer determinant(const std::vector<std::vector<Integer>>& matrix);

}  // namespace orthoball::oracles
