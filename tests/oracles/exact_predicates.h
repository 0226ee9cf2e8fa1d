// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "oracles/exact_points.h"
#include "orthoball/exact/sign.h"

namespace orthoball::oracles {

/// det of the rows p_i - p_0, i >= 1, on the given axes: what orient is the sign of. In the
/// integers of `points`.
[[nodiscard]] inline Integer orientation(const ExactPoints& points,
                                         std::span<const std::uint32_t> rows,
                                         std::span<const int> axes) {
  std::vector<std::vector<Integer>> matrix;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    auto& line = matrix.emplace_back();
    for (const int axis : axes) {
      const auto at = static_cast<std::size_t>(axis);
      line.push_back(points.position[rows[i]][at] - points.position[rows[0]][at]);
    }
  }
  return determinant(matrix);
}

/// det of the rows (|p_i - q|^2 - w_i + w_q, p_i - q), the coordinates on as many axes as there are
/// rows but one, the squares on all: what power_side is the sign of.
[[nodiscard]] inline Integer power_determinant(const ExactPoints& points,
                                               std::span<const std::uint32_t> rows,
                                               std::uint32_t query) {
  const auto& q = points.position[query];
  std::vector<std::vector<Integer>> matrix;
  for (const std::uint32_t row : rows) {
    std::vector<Integer> line{points.weight[query] - points.weight[row]};
    for (std::size_t axis = 0; axis < q.size(); ++axis) {
      const Integer distance = points.position[row][axis] - q[axis];
      line[0] += distance * distance;
      if (axis + 1 < rows.size()) line.push_back(distance);
    }
    matrix.push_back(line);
  }
  return determinant(matrix);
}

[[nodiscard]] inline Sign sign_of(const Integer& number) { return Sign(number.sign()); }

/// 2^exponent.
[[nodiscard]] inline Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << (exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

}  // namespace orthoball::oracles
