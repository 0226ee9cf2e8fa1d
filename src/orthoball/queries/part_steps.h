// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/queries/star_parts.h"

namespace orthoball {

/// Cells around one vertex that could change sides together, to make the parts there fewer.
struct PartStep {
  double cost = 0.0;                 ///< the volume of the cells
  std::vector<std::uint32_t> cells;  ///< ascending
};

/// What could be done around a vertex.
///
/// Of every part of a side that has several: the whole of it, but for that which has what is beyond
/// the convex hull, and the cheapest path through cells of the other side to another part of its
/// side. Refers to what it is made from. Four bytes a cell. Not for several threads at once.
template <int D>
class PartSteps {
 public:
  /// @param volumes   [cell]
  /// @param is_fixed  [cell]: it is in no step.
  PartSteps(const StarParts<D>& stars, std::span<const double> volumes,
            const std::vector<bool>& is_fixed)
      : stars_(stars), volumes_(volumes), is_fixed_(is_fixed), place_(volumes.size()) {}

  /// The cheapest first, then the fewest cells. None of more than 32 cells or, if they may be of
  /// any size, of those only the cheapest. All paths are found at once, in the time of sorting the
  /// cells around the vertex.
  [[nodiscard]] std::vector<PartStep> at(std::uint32_t vertex, bool of_any_size);

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t kManyCells = 32;  // of a step
  // How the cheapest path from a part comes to a cell.
  struct Reach {
    double cost = std::numeric_limits<double>::infinity();
    std::uint32_t part = kNone, before = kNone;  // the cell before
    std::uint32_t length = 0;                    // in cells
  };
  // A path: from one or two cells backwards.
  struct Path {
    double cost = std::numeric_limits<double>::infinity();
    std::uint32_t length = 0;
    std::array<std::uint32_t, 2> ends{kNone, kNone};
  };

  void reach(std::uint32_t cell, Reach by);
  void grow(std::uint32_t vertex);
  void meet(std::uint32_t vertex);
  void add_paths(std::vector<PartStep>& steps);
  void add_wholes(std::vector<PartStep>& steps, std::uint32_t vertex) const;
  [[nodiscard]] bool has_paths(std::uint32_t vertex, std::uint32_t cell) const;
  [[nodiscard]] Reach& reached(std::uint32_t cell) { return reached_[place_[cell]]; }
  void add(std::vector<PartStep>& steps, std::vector<std::uint32_t> cells) const;

  const StarParts<D>& stars_;
  std::span<const double> volumes_;
  const std::vector<bool>& is_fixed_;
  std::vector<std::uint32_t> place_;                     // [cell]: among those around the vertex
  std::vector<Reach> reached_;                           // [place]
  std::vector<std::pair<double, std::uint32_t>> front_;  // a heap: costs and cells
  std::vector<Path> paths_;                              // [part]: the cheapest
};

extern template class PartSteps<2>;  // defined in part_steps.cpp
extern template class PartSteps<3>;

}  // namespace orthoball
