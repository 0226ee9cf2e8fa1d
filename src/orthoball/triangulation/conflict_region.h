// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/exact/perturbation.h"
#include "orthoball/exact/power_sides_across.h"
#include "orthoball/exact/unrolled.h"
#include "orthoball/triangulation/cell_store.h"

namespace orthoball {

/// The cells that one site invalidates, and their replacement by cells at that site.
///
/// The cells in conflict form a ball around the site (perturbation leaves no ties). A search over
/// neighbours finds them and the facets of the ball's boundary; each of these gets a new cell with
/// the site, in the place of a dead one while there are any. New cells are neighbours if they share
/// a ridge of the boundary: boundary vertices are numbered as they are met, a matrix over these
/// numbers holds, for each directed ridge, the facet to its left, and its twin is the facet at the
/// reversed ridge. No hashing, and no allocation once arrays have grown. Nor is there a branch on
/// whether a cell is in conflict, which would be mispredicted every other time: the search asks for
/// all neighbours of a dead cell at once, writes each to both lists and counts it in one.
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
    find(site, start);
    number_vertices();
    if (!sites_.is_unweighted()) note_swallowed(swallowed);
    place_new_cells();
    if constexpr (A == 1) {
      restar_on_line(site);
    } else if (A == 2 || number_count_ <= kMatrixSide) {
      restar_by_matrix(site);
    } else {
      restar_by_sorting(site);
    }
    return places_[0];
  }

 private:
  using Cell = CellRecord<A>;
  template <class Element>
  using OfVertices = std::array<Element, std::size_t{A}>;

  // A facet of the region's boundary. (site, vertices...) is positively oriented, but on a line,
  // where that is for restar_on_line to see to.
  struct Facet {
    OfVertices<std::uint32_t> vertices;
    std::uint32_t outside;  // 4 * cell + corner of the cell that stays
  };
  // The number of a boundary vertex, valid in one visit: nothing to reset between insertions.
  struct Number {
    std::uint32_t visit = 0;
    std::uint32_t number = 0;
  };

  // Arrays only grow, and have their counts beside them.
  template <class Element>
  static void make_room(std::vector<Element>& array, std::size_t count) {
    if (count > array.size()) array.resize(2 * count + 64);
  }

  static constexpr std::uint32_t kMatrixSide = 64;  // boundary vertices that the matrix can hold
  static constexpr std::uint32_t kMatrix = kMatrixSide * kMatrixSide;

  // Strictly beyond the hull facet, or in its plane and in conflict within it. There the finite
  // cell behind the facet answers: its orthosphere cuts the plane in the facet's.
  [[nodiscard]] bool in_conflict_at_infinity(const Cell& record, std::uint32_t site) const {
    const std::size_t infinite = cells_.corner_at_infinity(record);
    Corners<A> corners = record.corners;
    corners[infinite] = site;
    const Sign side = orient<A, D>(sites_, corners);
    if (side != Sign::zero) return side == Sign::positive;
    const std::uint32_t inside = record.neighbours[infinite] / 4;
    return orthoball::in_conflict<A, D>(sites_, cells_[inside].corners, site);
  }

  // Breadth-first: the list of dead cells is the queue.
  void find(std::uint32_t site, std::uint32_t start) {
    make_room(places_, 1);
    places_[0] = start;
    dead_count_ = 1;
    facet_count_ = 0;
    cells_.set_dead(start, true);
    for (std::size_t next = 0; next < dead_count_; ++next) spread(places_[next], site);
  }

  // From a dead cell over its facets. What lies beyond is dead, too, or dies now, or stays.
  void spread(std::uint32_t cell, std::uint32_t site) {
    const Cell& record = cells_[cell];
    std::uint32_t alive = 0;
    std::uint32_t finite = 0;
    Corners<A> apexes;
    unrolled<std::size_t{A + 1}>([&](std::size_t i) {
      const std::uint32_t beyond = record.neighbours[i] / 4;
      const std::uint32_t apex = cells_[beyond].corners[record.neighbours[i] % 4];
      const bool is_finite = (apex & cells_.infinity()) == 0;
      apexes[i] = is_finite ? apex : site;
      finite |= std::uint32_t{is_finite} << i;
      alive |= std::uint32_t{!cells_.is_dead(beyond)} << i;
    });
    GlancedSides sides;
    if (can_glance_ && cells_.is_finite(record)) {
      sides = glanced_power_sides_across(sites_, record.corners, apexes, site);
    }
    std::uint32_t dying = sides.positive & finite & alive;
    for (std::uint32_t open = alive & ~((sides.positive | sides.negative) & finite); open != 0;
         open &= open - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(open));
      const std::uint32_t beyond = record.neighbours[i] / 4;
      const bool is_tie = ((sides.zero & finite) >> i & 1U) != 0;
      const bool dies = is_tie ? perturbed_conflict<A, D>(sites_, cells_[beyond].corners, site)
                               : in_conflict(beyond, site);
      dying |= std::uint32_t{dies} << i;
    }
    list(record, dying, alive & ~dying);
  }

  // Adds the neighbours of a dead cell to the dead cells and the boundary.
  void list(const Cell& record, std::uint32_t dying, std::uint32_t staying) {
    make_room(places_, dead_count_ + A + 1);
    make_room(boundary_, facet_count_ + A + 1);
    std::size_t dead_count = dead_count_;
    std::size_t facet_count = facet_count_;
    unrolled<std::size_t{A + 1}>([&](std::size_t i) {
      const std::uint32_t beyond = record.neighbours[i] / 4;
      const std::uint32_t dies = dying >> i & 1U;
      cells_.set_dead(beyond, (staying >> i & 1U) == 0);
      places_[dead_count] = beyond;
      dead_count += dies;
      Facet& facet = boundary_[facet_count];
      for (std::size_t k = 0; k < A; ++k) facet.vertices[k] = record.corners[kFacet[i][k]];
      facet.outside = record.neighbours[i];
      facet_count += staying >> i & 1U;
    });
    dead_count_ = dead_count;
    facet_count_ = facet_count;
  }

  // (i, kFacet[i]...) is an even permutation of the corners.
  static constexpr auto kFacet = [] {
    if constexpr (A == 1) return std::array<std::array<std::size_t, 1>, 2>{{{1}, {0}}};
    if constexpr (A == 2)
      return std::array<std::array<std::size_t, 2>, 3>{{{1, 2}, {2, 0}, {0, 1}}};
    if constexpr (A == 3) {
      return std::array<std::array<std::size_t, 3>, 4>{
          {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    }
  }();

  void number_vertices() {
    ++visit_;
    make_room(facet_numbers_, facet_count_);
    std::uint32_t count = 0;
    for (std::size_t f = 0; f < facet_count_; ++f) {
      for (std::size_t k = 0; k < A; ++k) {
        Number& known = numbers_[boundary_[f].vertices[k]];
        const bool is_new = known.visit != visit_;
        const std::uint32_t number = is_new ? count : known.number;
        known = {visit_, number};
        facet_numbers_[f][k] = number;
        count += is_new ? 1 : 0;
      }
    }
    number_count_ = count;
  }

  // Vertices of dead cells that are not on the boundary have lost their power cell.
  void note_swallowed(std::vector<std::uint32_t>& swallowed) {
    for (const std::uint32_t cell : std::span(places_).first(dead_count_)) {
      for (const std::uint32_t vertex : cells_[cell].corners) {
        if (numbers_[vertex].visit == visit_) continue;
        numbers_[vertex].visit = visit_;
        swallowed.push_back(vertex);
      }
    }
  }

  // places_[f] becomes the cell at facet f.
  void place_new_cells() {
    if (dead_count_ > facet_count_) {
      cells_.release(std::span(places_).first(dead_count_).subspan(facet_count_));
    }
    make_room(places_, facet_count_);
    for (std::size_t f = dead_count_; f < facet_count_; ++f) places_[f] = cells_.acquire();
  }

  void write(std::size_t f, const Cell& record) {
    cells_[places_[f]] = record;
    cells_.set_dead(places_[f], false);
    const std::uint32_t outside = boundary_[f].outside;
    const std::uint32_t at = A == 1 ? 1 - outside % 4 : 0;
    cells_[outside / 4].neighbours[outside % 4] = 4 * places_[f] + at;
  }

  void restar_by_matrix(std::uint32_t site) {
    if constexpr (A == 2) make_room(left_of_, 2 * std::size_t{number_count_});
    for (std::size_t f = 0; f < facet_count_; ++f) {
      const std::uint32_t facet = 4 * places_[f];
      const auto& n = facet_numbers_[f];
      for (std::uint32_t k = 0; k < A; ++k) left_of_[ridge(n, k)] = facet + k + 1;
    }
    for (std::size_t f = 0; f < facet_count_; ++f) {
      const auto& n = facet_numbers_[f];
      Cell record;
      record.corners[0] = site;
      record.neighbours[0] = boundary_[f].outside;
      for (std::uint32_t k = 0; k < A; ++k) {
        record.corners[k + 1] = boundary_[f].vertices[k];
        record.neighbours[k + 1] = left_of_[reversed_ridge(n, k)];
      }
      write(f, record);
    }
  }

  // The place in the matrix of a facet's ridge opposite vertex k, and of the same ridge as the
  // facet beyond sees it.
  [[nodiscard]] static std::uint32_t ridge(const OfVertices<std::uint32_t>& n, std::uint32_t k) {
    if constexpr (A == 2) return 2 * n[1 - k] + k;
    return n[(k + 1) % A] * kMatrixSide + n[(k + 2) % A];
  }
  [[nodiscard]] static std::uint32_t reversed_ridge(const OfVertices<std::uint32_t>& n,
                                                    std::uint32_t k) {
    if constexpr (A == 2) return 2 * n[1 - k] + (1 - k);
    return n[(k + 2) % A] * kMatrixSide + n[(k + 1) % A];
  }

  // For the rare region with so many vertices that a matrix would not pay.
  void restar_by_sorting(std::uint32_t site) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> facets;  // at each ridge two
    for (std::size_t f = 0; f < facet_count_; ++f) {
      const auto& vertices = boundary_[f].vertices;
      Cell record{};
      record.corners[0] = site;
      std::copy(vertices.begin(), vertices.end(), record.corners.begin() + 1);
      record.neighbours[0] = boundary_[f].outside;
      write(f, record);
      for (std::uint32_t k = 0; k < A; ++k) {
        const auto [low, high] = std::minmax(vertices[(k + 1) % A], vertices[(k + 2) % A]);
        facets.emplace_back(std::uint64_t{low} << 32U | high, 4 * places_[f] + k + 1);
      }
    }
    std::sort(facets.begin(), facets.end());
    for (std::size_t i = 0; i < facets.size(); i += 2) {
      cells_.join(facets[i].second, facets[i + 1].second);
    }
  }

  // Two cells, each with the site in the place of the corner that its outside neighbour lacks.
  // Neighbours on a line lie at opposite ends of both.
  void restar_on_line(std::uint32_t site) {
    for (std::size_t f = 0; f < 2; ++f) {
      const std::uint32_t at = 1 - boundary_[f].outside % 4;
      Cell record{};
      record.corners[at] = site;
      record.corners[1 - at] = boundary_[f].vertices[0];
      record.neighbours[at] = boundary_[f].outside;
      record.neighbours[1 - at] = 4 * places_[1 - f] + at;
      write(f, record);
    }
  }

  CellStore<A>& cells_;
  const Sites<D>& sites_;
  const bool can_glance_ = can_glance_across();
  std::uint32_t visit_ = 0;
  std::uint32_t number_count_ = 0;
  std::size_t dead_count_ = 0;
  std::size_t facet_count_ = 0;
  std::vector<std::uint32_t> places_;  // the dead cells, then where the new ones go
  std::vector<Facet> boundary_;
  std::vector<OfVertices<std::uint32_t>> facet_numbers_;
  std::vector<Number> numbers_;         // [vertex]
  std::vector<std::uint32_t> left_of_;  // [place of a directed ridge] facet to its left
};

}  // namespace orthoball
