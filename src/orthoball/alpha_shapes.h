// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "orthoball/filtration/filtration.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// All alpha shapes of weighted points in the plane or in space: the one object whose dimension is
/// known at run time only. Command line, Python and viewer hold it.
///
/// Immutable; any number of threads may read it.
class AlphaShapes {
 public:
  /// Triangulates and orders. Memory at most 1 KB a site in space.
  /// @throws LimitError for more simplices than can be numbered.
  explicit AlphaShapes(WeightedPoints points);

  [[nodiscard]] const WeightedPoints& points() const { return points_; }
  [[nodiscard]] int dimension() const { return points_.dimension(); }
  /// The filtration; `dimension()` tells which of the two it is.
  [[nodiscard]] const std::variant<Filtration<2>, Filtration<3>>& filtration() const {
    return filtration_;
  }

 private:
  WeightedPoints points_;
  std::variant<Filtration<2>, Filtration<3>> filtration_;
};

}  // namespace orthoball
