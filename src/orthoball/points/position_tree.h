// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// The distinct positions of points, arranged so that the nearest to each are found fast: a k-d
/// tree.
///
/// Rows at one position are one position; -0 equals 0. Lengths are in the unit of the points'
/// arrays. Squared distances are sums in the order of the axes, each operation rounded to double:
/// exact for integers less than 2^25 apart, otherwise off by less than 2^-51 of themselves. They
/// are the same for any order of rows and number of threads. Immutable; any number of threads may
/// read.
///
/// O(n log n) time; 8 D + 9 bytes a row.   @cite bentley_1975
template <int D>
class PositionTree {
 public:
  /// @param points  of dimension D; their weights do not matter.
  explicit PositionTree(const WeightedPoints& points, Threads threads = {});

  /// Number of distinct positions.
  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  /// [row]: the position of each row, 0..size() - 1; those near in space have near numbers.
  [[nodiscard]] std::span<const std::uint32_t> position_of_row() const { return position_of_row_; }

  /// The squared distances from a position to the nearest others, ascending.
  /// @param squares  as many as are wanted, fewer than size(); they are written.
  /// O(k log n) for k of them in points that are not made to be hard.
  void nearest_squares(std::uint32_t position, std::span<double> squares) const;

 private:
  using Position = std::array<double, std::size_t{D}>;

  std::vector<Position> positions_;             // [position]
  std::vector<std::uint8_t> axes_;              // [position]: by which its range is cut there
  std::vector<std::uint32_t> position_of_row_;  // [row]
};

extern template class PositionTree<2>;  // defined in position_tree.cpp
extern template class PositionTree<3>;

}  // namespace orthoball
