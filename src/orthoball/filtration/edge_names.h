// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// A range of cells, which takes its edges' names from cells of the range only.
struct CellRange {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t first_name;
};

/// Names that edges get before they have numbers. Those of a range of cells ascend with the cells
/// and slots that gave them, from the range's first name on. An edge may have several names; these
/// are united with smaller ones, and the smallest of all, the root, is that of the smallest cell
/// around the edge.
///
/// Memory that no name has reached is not touched.
class EdgeNames {
 public:
  /// For some cells in some ranges.
  EdgeNames(std::size_t cells, std::size_t ranges)
      : parents_(std::make_unique_for_overwrite<std::uint32_t[]>(6 * cells + kSpare * ranges)) {}

  /// Where the names of a range begin: behind six for every cell before, and a few to spare for
  /// every range before, which it may write to.
  [[nodiscard]] static std::uint32_t first_name(std::uint32_t begin, std::size_t range) {
    return 6 * begin + static_cast<std::uint32_t>(kSpare * range);
  }

  /// [name]: a smaller one that it is united with, or itself.
  [[nodiscard]] std::uint32_t* parents() { return parents_.get(); }
  [[nodiscard]] std::uint32_t& operator[](std::uint32_t name) { return parents_[name]; }
  [[nodiscard]] std::uint32_t operator[](std::uint32_t name) const { return parents_[name]; }

  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a != b) parents_[std::max(a, b)] = std::min(a, b);
  }
  [[nodiscard]] std::uint32_t root(std::uint32_t name) {
    while (parents_[name] != name) name = parents_[name] = parents_[parents_[name]];
    return name;
  }

  /// The same without a change.
  [[nodiscard]] std::uint32_t root_now(std::uint32_t name) const {
    while (parents_[name] != name) name = parents_[name];
    return name;
  }

 private:
  static constexpr std::size_t kSpare = 8;

  std::unique_ptr<std::uint32_t[]> parents_;
};

/// Slots of a cell whose last two corners change places where they descend: where each comes from,
/// by whether they do. So slots are written while edges have names: the common facet of two cells
/// then has its corners in the same order in both.
inline constexpr std::array<std::array<std::uint8_t, 6>, 2> kAscendingSlot{
    {{0, 1, 2, 3, 4, 5}, {0, 2, 1, 4, 3, 5}}};

/// The slots of a facet's edges, by the corner opposite; corners and slots in ascending order.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetSlots{
    {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}}};

/// Whether the last two corners descend, 0 or 1.
[[nodiscard]] inline unsigned descends(const CellRecord<3>& cell) {
  return cell.corners[3] < cell.corners[2] ? 1 : 0;
}
/// The place of a corner when all ascend.
[[nodiscard]] inline unsigned ascending_corner(unsigned corner, unsigned descends) {
  return corner ^ (corner >> 1U & descends);
}

/// Gives names to the edges of a range of cells, in ascending slots, and unites those that meet.
/// @param of_cells  [cell][slot] of all cells.
/// @return the first name behind those of the range.
std::uint32_t name_edges(std::span<const CellRecord<3>> cells, CellRange range,
                         std::array<std::uint32_t, 6>* of_cells, EdgeNames& names);

/// The two ways to do so, for tests: not part of the public interface.
namespace edge_names_stages {

/// On any processor.
std::uint32_t name_edges_one_by_one(std::span<const CellRecord<3>> cells, CellRange range,
                                    std::array<std::uint32_t, 6>* of_cells, EdgeNames& names);
/// Six edges at once, where has_avx2().
std::uint32_t name_edges_in_lanes(std::span<const CellRecord<3>> cells, CellRange range,
                                  std::array<std::uint32_t, 6>* of_cells, EdgeNames& names);

}  // namespace edge_names_stages
}  // namespace orthoball
