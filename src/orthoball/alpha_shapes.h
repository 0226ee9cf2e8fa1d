// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/memory_budget.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// The parts of the work of building an AlphaShapes, in their order.
enum class BuildStage { triangulation, filtration };

/// Told which part begins, for showing progress.
using BuildObserver = std::function<void(BuildStage)>;

/// How an AlphaShapes is built. But for `alpha2`, what it becomes does not depend on it.
struct BuildOptions {
  Threads threads{};         ///< at most so many; by default one for each core
  BuildObserver on_stage{};  ///< called at the begin of each part; may be empty
  MemoryBudget memory{};     ///< by default what the system has
  /// Where not empty, the complexes at these values alone, in half the time and two thirds of the
  /// memory: see Filtration. Ascending; length^2 in input units.
  std::vector<double> alpha2{};
};

/// All alpha shapes of weighted points in the plane or in space: the one object whose dimension is
/// known at run time only. Command line, Python and viewer hold it.
///
/// Immutable; any number of threads may read it.
class AlphaShapes {
 public:
  /// Triangulates and orders. Memory about 1.1 KB a site in space.
  /// @throws LimitError for more simplices than can be numbered; for more memory than there is, by
  ///         an estimate before the work and by a closer one once the cells are known.
  ///         InputError where `alpha2` does not ascend.
  explicit AlphaShapes(WeightedPoints points, const BuildOptions& options = {});

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
