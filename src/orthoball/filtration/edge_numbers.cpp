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
#include <utility>

namespace orthoball {
namespace {

constexpr std::uint32_t kNameless = 0xFFFFFFFFU;

// The slots of a facet's edges, by the corner opposite; corners and slots in ascending order.
constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetSlots{
    {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}}};

// Slots where the last two corners change places: where each comes from.
constexpr std::array<std::array<std::uint8_t, 6>, 2> kAscendingSlot{
    {{0, 1, 2, 3, 4, 5}, {0, 2, 1, 4, 3, 5}}};

bool is_descending(const CellRecord<3>& record) { return record.corners[3] < record.corners[2]; }

// The place of a corner when all ascend.
unsigned ascending_corner(unsigned corner, bool is_descending) {
  return corner ^ (corner >> 1U & static_cast<unsigned>(is_descending));
}

class EdgeNames {
 public:
  explicit EdgeNames(std::size_t cells) {
    parents_.reserve(2 * cells);
    owners_.reserve(2 * cells);
  }

  std::uint32_t add(std::uint32_t owner) {
    const auto name = static_cast<std::uint32_t>(parents_.size());
    parents_.push_back(name);
    owners_.push_back(owner);
    return name;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parents_[std::max(a, b)] = std::min(a, b);
    ++united_;
  }
  // Ends the names: from here on, number() is known. Returns the edges' owners.
  std::vector<std::uint32_t> number_all() {
    std::vector<std::uint32_t> owners;
    owners.reserve(parents_.size() - united_);
    for (std::uint32_t name = 0; name < parents_.size(); ++name) {
      const std::uint32_t parent = parents_[name];  // itself, or a smaller one that has its number
      if (parent != name) {
        parents_[name] = parents_[parent];
        continue;
      }
      parents_[name] = static_cast<std::uint32_t>(owners.size());
      owners.push_back(owners_[name]);
    }
    return owners;
  }
  [[nodiscard]] std::uint32_t number(std::uint32_t name) const { return parents_[name]; }

 private:
  std::uint32_t root(std::uint32_t name) {
    while (parents_[name] != name) name = parents_[name] = parents_[parents_[name]];
    return name;
  }

  std::vector<std::uint32_t> parents_;  // [name]: never larger
  std::vector<std::uint32_t> owners_;   // [name]: 6 * cell + slot that it was given at
  std::size_t united_ = 0;
};

}  // namespace

EdgeNumbers edge_numbers(std::span<const CellRecord<3>> cells) {
  EdgeNumbers result;
  result.of_cells.resize(cells.size());
  EdgeNames names(cells.size());
  std::vector<bool> descending(cells.size());
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const bool descends = is_descending(cells[cell]);
    descending[cell] = descends;
    auto& edges = result.of_cells[cell];
    edges.fill(kNameless);
    for (unsigned corner = 0; corner < 4; ++corner) {
      const std::uint32_t beyond = cells[cell].neighbours[corner];
      const std::uint32_t other = beyond / 4;
      if (other >= cell) continue;  // kOutside, too
      const auto& here = kFacetSlots[ascending_corner(corner, descends)];
      const auto& there = kFacetSlots[ascending_corner(beyond % 4, descending[other])];
      for (unsigned i = 0; i < 3; ++i) {
        const auto [first, last] = std::minmax({edges[here[i]], result.of_cells[other][there[i]]});
        if (first != last && last != kNameless) names.unite(first, last);
        edges[here[i]] = first;
      }
    }
    for (unsigned slot = 0; slot < 6; ++slot) {
      std::uint32_t& name = edges[kAscendingSlot[descends ? 1 : 0][slot]];
      if (name == kNameless) name = names.add(6 * cell + slot);
    }
  }

  result.owners = names.number_all();
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    auto& edges = result.of_cells[cell];
    if (descending[cell]) {
      std::swap(edges[1], edges[2]);
      std::swap(edges[3], edges[4]);
    }
    for (std::uint32_t& edge : edges) edge = names.number(edge);
  }
  return result;
}

}  // namespace orthoball
