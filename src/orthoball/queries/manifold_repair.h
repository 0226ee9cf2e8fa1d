// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/large_star.h"
#include "orthoball/queries/star_parts.h"

namespace orthoball {

/// Changes a solid, a set of cells, until its boundary is a manifold.
///
/// Refers to the filtration and the balls. Deterministic.
template <int D>
class ManifoldRepair {
 public:
  /// @param balls  those of the filtration at any alpha: where its vertices are.
  /// @param solid  [cell], by number among cells.
  ManifoldRepair(const Filtration<D>& filtration, const ScaledBalls<D>& balls,
                 std::vector<bool> solid);

  /// The vertices at which the boundary is no manifold, ascending.
  [[nodiscard]] std::vector<std::uint32_t> offending() const;
  /// Until there are none.
  void run();

  /// [cell]: the solid.
  [[nodiscard]] const std::vector<bool>& solid() const { return solid_; }
  /// The cells that are not as they were, ascending.
  [[nodiscard]] std::vector<std::uint32_t> changed() const;
  /// Of a cell, in the units of the balls.
  [[nodiscard]] double volume(std::uint32_t cell) const;
  /// How often the search had to clear the cells around a vertex.
  [[nodiscard]] std::uint32_t cleared_count() const { return cleared_count_; }

 private:
  // Cells that change sides together.
  struct Step {
    double cost = 0.0;  // their volume, in the end for each surplus part less
    std::vector<std::uint32_t> cells;
  };
  // A vertex, when its next step was known last.
  struct Waiting {
    double cost;
    std::uint32_t vertex, version;
    friend bool operator>(const Waiting& a, const Waiting& b) {
      return a.cost != b.cost ? a.cost > b.cost : a.vertex > b.vertex;
    }
  };

  [[nodiscard]] std::vector<Step> steps(std::uint32_t vertex);
  void add_path(std::vector<Step>& steps, std::uint32_t vertex, std::uint32_t from);
  void add_step(std::vector<Step>& steps, Step step) const;
  [[nodiscard]] Step best_step(std::uint32_t vertex);
  [[nodiscard]] std::vector<std::uint32_t> vertices_of(std::span<const std::uint32_t> cells) const;
  [[nodiscard]] std::uint32_t surplus(std::uint32_t vertex);
  [[nodiscard]] std::int64_t gain(std::span<const std::uint32_t> cells, std::int64_t least);
  void turn(std::span<const std::uint32_t> cells);
  void apply(std::span<const std::uint32_t> cells);
  void wait(double cost, std::uint32_t vertex);
  void wait_all();
  void take_steps();
  void take_steps_at(std::uint32_t vertex);
  void take_all_steps();
  bool clear_one();
  void change_back();

  const Filtration<D>& filtration_;
  std::span<const CellRecord<D>> cells_;
  const ScaledBalls<D>& balls_;
  std::vector<bool> solid_, at_first_, is_cleared_;  // [cell]
  StarParts<D> stars_;
  std::map<std::uint32_t, LargeStar<D>> large_;  // by vertex
  std::vector<std::uint32_t> surplus_;           // [vertex]
  std::vector<std::uint32_t> version_;           // [vertex]: of what waits; older ones are void
  std::vector<Waiting> waiting_;                 // a heap, the smallest first
  std::uint32_t applied_count_ = 0, cleared_count_ = 0;
};

extern template class ManifoldRepair<2>;  // defined in manifold_repair.cpp
extern template class ManifoldRepair<3>;

}  // namespace orthoball
