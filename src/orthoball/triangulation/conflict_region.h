// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/exact/perturbation.h"
#include "orthoball/triangulation/cell_store.h"

namespace orthoball {

/// The cells that one site invalidates, and their replacement by cells at that site.
///
/// The cells in conflict form a ball around the site (perturbation leaves no ties). A search over
/// neighbours finds them; each facet of the ball's boundary makes a new cell with the site at once,
/// in the place of a cell that died with an earlier site. What is left is to join new cells to each
/// other: two of them share a ridge of the boundary with the site. Boundary vertices are numbered
/// as they are met; a matrix over these numbers holds, for each directed ridge, the facet to its
/// left, and its twin is the facet at the reversed ridge. No hashing, no allocation once arrays
/// have grown.
template <int A, int D>
class ConflictRegion {
 public:
  ConflictRegion(CellStore<A>& cells, const Sites<D>& sites)
      : cells_(cells),
        sites_(sites),
        numbers_(cells.infinity() + std::size_t{1}),
        left_of_(kMatrix) {}

  /// Whether `site` is in conflict with `cell`. Exact.
  [[nodiscard]] bool in_conflict(std::uint32_t cell, std::uint32_t site) const {
    const auto& record = cells_[cell];
    if (cells_.is_finite(record)) {
      return orthoball::in_conflict<A, D>(sites_, record.corners, site);
    }
    return in_conflict_at_infinity(record, site);
  }

  /// Replaces the cells in conflict with `site`, found from `start`, which is one of them. Appends
  /// to `swallowed` the vertices that no longer have a cell. Returns one of the new cells.
  std::uint32_t insert(std::uint32_t site, std::uint32_t start,
                       std::vector<std::uint32_t>& swallowed) {
    restar(site, start);
    if (A < 3 || number_count_ <= kMatrixSide) {
      join_by_matrix();
    } else {
      join_by_sorting();
    }
    if (!sites_.is_unweighted()) note_swallowed(swallowed);
    cells_.release(dead());
    return new_[new_count_ - 1].cell;
  }

 private:
  // A cell at the site over a facet of the region's boundary. Its other facets are at the site.
  struct NewCell {
    std::uint32_t cell;
    std::uint32_t site_at;  // which corner is the site
    // Where the matrix holds the facet to be joined to the one opposite each other corner.
    std::array<std::uint32_t, std::size_t{A}> twins;
  };
  // The number of a boundary vertex, valid in one visit: nothing to reset between insertions.
  struct Number {
    std::uint32_t visit = 0;
    std::uint32_t number = 0;
  };

  // Appends to arrays that only grow: `count` elements are in use.
  template <class Element>
  static void push(std::vector<Element>& array, std::size_t& count, const Element& element) {
    if (count == array.size()) array.resize(2 * count + 64);
    array[count++] = element;
  }
  [[nodiscard]] std::span<const std::uint32_t> dead() const {
    return std::span(dead_).first(dead_count_);
  }

  static constexpr std::uint32_t kMatrixSide = 64;  // boundary vertices that the matrix can hold
  static constexpr std::uint32_t kMatrix = kMatrixSide * kMatrixSide;

  // Strictly beyond the hull facet, or in its plane and in conflict within it. There the finite
  // cell behind the facet answers: its orthosphere cuts the plane in the facet's.
  [[nodiscard]] bool in_conflict_at_infinity(const CellRecord<A>& record,
                                             std::uint32_t site) const {
    const std::size_t infinite = cells_.corner_at_infinity(record);
    Corners<A> corners = record.corners;
    corners[infinite] = site;
    const Sign side = orient<A, D>(sites_, corners);
    if (side != Sign::zero) return side == Sign::positive;
    const std::uint32_t inside = record.neighbours[infinite] / 4;
    return orthoball::in_conflict<A, D>(sites_, cells_[inside].corners, site);
  }

  // Breadth-first: dead_ is the queue. Marks: visit_ for a cell found free of conflict, visit_ + 1
  // for one in conflict.
  void restar(std::uint32_t site, std::uint32_t start) {
    visit_ += 2;
    number_count_ = 0;
    dead_count_ = 0;
    new_count_ = 0;
    push(dead_, dead_count_, start);
    cells_.mark(start) = visit_ + 1;
    for (std::size_t next = 0; next < dead_count_; ++next) {
      const CellRecord<A> record = cells_[dead_[next]];
      [&]<std::uint32_t... kAt>(std::integer_sequence<std::uint32_t, kAt...>) {
        (cross_facet<kAt>(record, site), ...);
      }
      (std::make_integer_sequence<std::uint32_t, std::uint32_t{A + 1}>());
    }
  }

  // What lies beyond the facet opposite corner kAt of a dead cell is dead, too, or stays.
  template <std::uint32_t kAt>
  void cross_facet(const CellRecord<A>& record, std::uint32_t site) {
    const std::uint32_t outside = record.neighbours[kAt];
    std::uint32_t& mark = cells_.mark(outside / 4);
    if (mark == visit_ + 1) return;
    if (mark != visit_) {
      if (in_conflict(outside / 4, site)) {
        mark = visit_ + 1;
        push(dead_, dead_count_, outside / 4);
        return;
      }
      mark = visit_;
    }
    add_cell<kAt>(record.corners, site, outside);
  }

  // The cell of `corners` with the site in the place of corner kAt, before the facet `outside`.
  template <std::uint32_t kAt>
  void add_cell(const Corners<A>& corners, std::uint32_t site, std::uint32_t outside) {
    const std::uint32_t cell = cells_.acquire();
    auto& record = cells_[cell];
    record.corners = corners;
    record.corners[kAt] = site;
    cells_.join(4 * cell + kAt, outside);

    std::array<std::uint32_t, std::size_t{A + 1}> numbers{};
    for (std::size_t i = 0; i <= A; ++i) {
      if (i != kAt) numbers[i] = number(corners[i]);
    }
    NewCell added{cell, kAt, {}};
    std::size_t next = 0;
    for (std::uint32_t corner = 0; corner <= A; ++corner) {
      if (corner == kAt) continue;
      const auto [own, twin] = ridge(numbers, kAt, corner);
      left_of_[own] = 4 * cell + corner;
      added.twins[next++] = twin;
    }
    push(new_, new_count_, added);
  }

  std::uint32_t number(std::uint32_t vertex) {
    Number& known = numbers_[vertex];
    if (known.visit != visit_) {
      known = {visit_, number_count_++};
      if (A == 2 && 2 * number_count_ > left_of_.size()) left_of_.resize(2 * left_of_.size());
    }
    return known.number;
  }

  // Vertices of dead cells that are not on the boundary have lost their power cell.
  void note_swallowed(std::vector<std::uint32_t>& swallowed) {
    for (const std::uint32_t cell : dead()) {
      for (const std::uint32_t vertex : cells_[cell].corners) {
        if (numbers_[vertex].visit == visit_) continue;
        numbers_[vertex].visit = visit_;
        swallowed.push_back(vertex);
      }
    }
  }

  // (at, corner, kFrom[at][corner], the fourth) is an even permutation of a tetrahedron's corners.
  static constexpr std::uint32_t kFrom[4][4] = {
      {0, 2, 3, 1}, {3, 0, 0, 2}, {1, 3, 0, 0}, {2, 0, 1, 0}};

  // A new cell's facet opposite `corner` shares a ridge with the boundary. The place in the matrix
  // of the ridge directed so that this facet is on its left, and of the reverse. Numbers too large
  // for the matrix wrap round; insert() does not use it then.
  [[nodiscard]] static std::pair<std::uint32_t, std::uint32_t> ridge(
      const std::array<std::uint32_t, std::size_t{A + 1}>& numbers, std::uint32_t at,
      std::uint32_t corner) {
    if constexpr (A == 1) {
      return at < corner ? std::pair{0U, 1U} : std::pair{1U, 0U};
    } else if constexpr (A == 2) {
      const std::uint32_t vertex = 2 * numbers[3 - at - corner];
      return (at + 1) % 3 == corner ? std::pair{vertex, vertex + 1} : std::pair{vertex + 1, vertex};
    } else {
      const std::uint32_t from = kFrom[at][corner];
      const std::uint32_t a = numbers[from] % kMatrixSide;
      const std::uint32_t b = numbers[6 - at - corner - from] % kMatrixSide;
      return {a * kMatrixSide + b, b * kMatrixSide + a};
    }
  }

  void join_by_matrix() {
    for (const NewCell& added : std::span(new_).first(new_count_)) {
      auto& neighbours = cells_[added.cell].neighbours;
      for (std::uint32_t i = 0; i < A; ++i) {
        neighbours[i < added.site_at ? i : i + 1] = left_of_[added.twins[i]];
      }
    }
  }

  // For the rare region with so many vertices that a matrix would not pay.
  void join_by_sorting() {
    using Ridge = std::pair<std::uint32_t, std::uint32_t>;  // directed, by vertices
    const auto left_ridge = [&](const NewCell& added, std::uint32_t corner) {
      const auto& corners = cells_[added.cell].corners;
      const std::uint32_t from = kFrom[added.site_at][corner];
      return Ridge{corners[from], corners[6 - added.site_at - corner - from]};
    };
    std::vector<std::pair<Ridge, std::uint32_t>> facets;
    for (const NewCell& added : std::span(new_).first(new_count_)) {
      for (std::uint32_t corner = 0; corner <= A; ++corner) {
        if (corner == added.site_at) continue;
        facets.emplace_back(left_ridge(added, corner), 4 * added.cell + corner);
      }
    }
    std::sort(facets.begin(), facets.end());
    for (const auto& [ridge, facet] : facets) {
      const Ridge reverse{ridge.second, ridge.first};
      cells_[facet / 4].neighbours[facet % 4] =
          std::lower_bound(facets.begin(), facets.end(), std::pair{reverse, std::uint32_t{0}})
              ->second;
    }
  }

  CellStore<A>& cells_;
  const Sites<D>& sites_;
  std::uint32_t visit_ = 0;
  std::uint32_t number_count_ = 0;
  std::size_t dead_count_ = 0;
  std::size_t new_count_ = 0;
  std::vector<std::uint32_t> dead_;
  std::vector<NewCell> new_;
  std::vector<Number> numbers_;         // [vertex]
  std::vector<std::uint32_t> left_of_;  // [place of a directed ridge] facet to its left
};

}  // namespace orthoball
