// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/part_steps.h"
#include "orthoball/queries/star_parts.h"

namespace orthoball {

/// Changes a solid, a set of cells, until its boundary is a manifold.
///
/// Refers to the filtration. Deterministic.
template <int D>
class ManifoldRepair {
 public:
  /// @param balls  those of the filtration at any alpha: where its vertices are.
  /// @param solid  [cell], by number among cells.
  ManifoldRepair(const Filtration<D>& filtration, const ScaledBalls<D>& balls,
                 std::vector<bool> solid);
  ManifoldRepair(const ManifoldRepair&) = delete;  // steps_ refers to what is beside it
  ManifoldRepair& operator=(const ManifoldRepair&) = delete;
  ~ManifoldRepair() = default;

  /// The vertices at which the boundary is no manifold, ascending.
  [[nodiscard]] std::vector<std::uint32_t> offending() const;
  /// Until there are none.
  void run();

  /// [cell]: the solid.
  [[nodiscard]] const std::vector<bool>& solid() const { return stars_.solid(); }
  /// The cells that are not as they were, ascending.
  [[nodiscard]] std::vector<std::uint32_t> changed() const;
  /// Of a cell, in the units of the balls.
  [[nodiscard]] double volume(std::uint32_t cell) const { return volumes_[cell]; }
  /// How many cells it looked at so far.
  [[nodiscard]] std::uint64_t work() const { return work_ + stars_.work(); }

 private:
  // A step of a plan: its volume for each surplus part that it takes away, as far as is known.
  struct Planned {
    double cost;
    std::uint32_t step;
    friend auto operator<=>(const Planned&, const Planned&) = default;
  };
  // What could be done at a vertex.
  struct Plan {
    std::vector<PartStep> steps;
    std::vector<Planned> left;  // a heap, the cheapest first
    std::uint64_t version = 0;
    std::size_t turned = 0;  // cells around the vertex, since it was made
  };
  // A plan and its cheapest step.
  struct Waiting {
    double cost;
    std::uint32_t vertex;
    std::uint64_t version;
    friend auto operator<=>(const Waiting&, const Waiting&) = default;
  };

  void plan(std::uint32_t vertex, bool of_any_size);
  void wait(std::uint32_t vertex, const Plan& plan);
  [[nodiscard]] bool is_old(std::uint32_t vertex, const Plan& plan) const;
  void take_planned();
  void take_next(std::uint32_t vertex, Plan& plan);
  void apply(const PartStep& step);
  void turn(std::span<const std::uint32_t> cells);
  void take_all_steps();
  void clear(std::uint32_t vertex);
  void clear_some();
  void change_back();

  std::vector<double> volumes_;  // [cell]
  StarParts<D> stars_;
  std::vector<bool> at_first_, is_cleared_;  // [cell]
  PartSteps<D> steps_;
  std::unordered_map<std::uint32_t, Plan> plans_;  // by vertex; only of those with surplus
  std::vector<std::uint64_t> turned_at_;           // [vertex]: the version of the last turn there
  std::vector<Waiting> waiting_;                   // a heap, the cheapest first
  std::vector<std::uint32_t> near_;  // vertices of cells that turned and of those next to them
  std::uint64_t version_ = 0, applied_count_ = 0, work_ = 0;
};

extern template class ManifoldRepair<2>;  // defined in manifold_repair.cpp
extern template class ManifoldRepair<3>;

}  // namespace orthoball
