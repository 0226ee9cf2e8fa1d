// SPDX-License-Identifier: MIT
//
// Edges numbered by what each cell has in common with smaller ones. Cells are taken in ascending
// order. A cell takes over the names of the edges of every facet that it shares with a smaller
// cell; an edge that it finds on none of these gets a new name. So a ring of cells around an edge
// has a name for each cell that is smaller than both its neighbours in the ring, the first from the
// smallest of all; where two names meet, at the latest in the ring's largest cell, they are united.
// A name's root is the first name of its edge; the roots, in order, are the edges.
//
// No ring is walked: a step around an edge waits for the one before, while all that is read here is
// known beforehand.
//
// Corners ascend but for the last two, so the common facet of two cells has its corners in the same
// order in both if these two change places where they descend. That is how slots are written until
// the names become numbers.
#include "orthoball/filtration/edge_numbers.h"

#include <algorithm>
#include <cstddef>

#include "orthoball/exact/unrolled.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNameless = 0xFFFFFFFFU;

// The slots of a facet's edges, by the corner opposite; corners and slots in ascending order.
constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetSlots{
    {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}}};

// Slots where the last two corners change places: where each comes from.
constexpr std::array<std::array<std::uint8_t, 6>, 2> kAscendingSlot{
    {{0, 1, 2, 3, 4, 5}, {0, 2, 1, 4, 3, 5}}};

// The place of a corner when all ascend.
unsigned ascending_corner(unsigned corner, unsigned descends) {
  return corner ^ (corner >> 1U & descends);
}

// Names from 0 on, each with a smaller one that it is united with, or itself.
class EdgeNames {
 public:
  explicit EdgeNames(std::size_t cells) { parents_.reserve(2 * cells + kStep); }

  // Writes the names of a cell's edges, with a new one, in order, for each that has none. Without
  // branches: which slots are new is hard to foretell.
  void complete(const std::array<std::uint32_t, 6>& known, const std::array<std::uint8_t, 6>& order,
                std::array<std::uint32_t, 6>& names) {
    if (parents_.size() < size_ + names.size()) parents_.resize(parents_.size() + kStep);
    for (const unsigned slot : order) {
      parents_[size_] = size_;
      const bool is_new = known[slot] == kNameless;
      names[slot] = is_new ? size_ : known[slot];
      size_ += is_new ? 1 : 0;
    }
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parents_[std::max(a, b)] = std::min(a, b);
  }
  // Ends the names: from here on, number() is known. Returns the number of edges.
  std::uint32_t number_all() {
    std::uint32_t next = 0;
    for (std::uint32_t name = 0; name < size_; ++name) {
      const std::uint32_t parent = parents_[name];  // a smaller one has its number
      const bool is_root = parent == name;
      parents_[name] = is_root ? next : parents_[parent];
      next += is_root ? 1 : 0;
    }
    return next;
  }
  [[nodiscard]] std::uint32_t number(std::uint32_t name) const { return parents_[name]; }

 private:
  static constexpr std::size_t kStep = std::size_t{1} << 16U;

  std::uint32_t root(std::uint32_t name) {
    while (parents_[name] != name) name = parents_[name] = parents_[parents_[name]];
    return name;
  }

  std::vector<std::uint32_t> parents_;  // [name]: never larger; some to spare behind the last name
  std::uint32_t size_ = 0;
};

}  // namespace

EdgeNumbers edge_numbers(std::span<const CellRecord<3>> cells) {
  EdgeNumbers result;
  result.of_cells.reserve(cells.size());
  EdgeNames names(cells.size());
  std::vector<std::uint8_t> descending(cells.size());  // whether the last two corners are
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const auto& corners = cells[cell].corners;
    const unsigned descends = corners[3] < corners[2] ? 1 : 0;
    descending[cell] = static_cast<std::uint8_t>(descends);
    std::array<std::uint32_t, 6> edges;
    edges.fill(kNameless);
    for (unsigned corner = 0; corner < 4; ++corner) {
      const std::uint32_t beyond = cells[cell].neighbours[corner];
      if (beyond / 4 >= cell) continue;  // kOutside, too
      const auto& others = result.of_cells[beyond / 4];
      const auto& here = kFacetSlots[ascending_corner(corner, descends)];
      const auto& there = kFacetSlots[ascending_corner(beyond % 4, descending[beyond / 4])];
      unrolled<3>([&](std::size_t i) {
        const std::uint32_t mine = edges[here[i]];
        const std::uint32_t other = others[there[i]];
        if (mine != other && mine != kNameless) names.unite(mine, other);
        edges[here[i]] = std::min(mine, other);
      });
    }
    names.complete(edges, kAscendingSlot[descends], result.of_cells.emplace_back());
  }

  result.owners.resize(names.number_all() + std::size_t{1});  // one to spare
  std::uint32_t next = 0;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const auto names_of_cell = result.of_cells[cell];
    const auto& order = kAscendingSlot[descending[cell]];
    for (std::uint32_t slot = 0; slot < 6; ++slot) {
      const std::uint32_t edge = names.number(names_of_cell[order[slot]]);
      result.of_cells[cell][slot] = edge;
      result.owners[next] = 6 * cell + slot;
      next += edge == next ? 1 : 0;  // met for the first time
    }
  }
  result.owners.pop_back();
  return result;
}

}  // namespace orthoball
