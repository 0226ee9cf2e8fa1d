// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/triangulation/cell_store.h"
#include "orthoball/triangulation/conflict_search.h"

namespace orthoball {

/// Zeros, of which only those that are written or read cost memory.
class UntouchedWords {
 public:
  explicit UntouchedWords(std::size_t size)
      : size_(size),
        words_(static_cast<std::uint32_t*>(std::calloc(size + 1, sizeof(std::uint32_t)))) {
    if (words_ == nullptr) throw std::bad_alloc();
  }
  [[nodiscard]] std::uint32_t* data() const { return words_.get(); }
  void clear() { std::fill_n(words_.get(), size_, 0U); }

 private:
  struct Free {
    void operator()(std::uint32_t* memory) const { std::free(memory); }
  };
  std::size_t size_;
  std::unique_ptr<std::uint32_t[], Free> words_;
};

/// The number of each vertex on a boundary, by order of appearance, with nothing to reset between
/// boundaries: what an earlier one left bears another stamp. Four bytes a vertex, of which only
/// those that are met cost memory.
class BoundaryNumbers {
 public:
  static constexpr std::uint32_t kMost = 256;  // numbers to a boundary

  /// The numbers of one boundary; at most kMost are told apart.
  class Numbering {
   public:
    /// The number of a vertex, the next one where it has none yet.
    [[nodiscard]] std::uint32_t number(std::uint32_t vertex) {
      // The mark of a number that has been given is below count_, others are at least kMost: no
      // branch, which would be mispredicted every third time, and a short way from count to count.
      const std::uint32_t mark = marks_[vertex] ^ stamp_;
      const std::uint32_t number = std::min(mark, count_);
      count_ += mark >= kMost ? 1U : 0U;
      marks_[vertex] = stamp_ | number;
      return number;
    }
    /// Below kMost for a vertex that has appeared, and only for these.
    [[nodiscard]] std::uint32_t mark(std::uint32_t vertex) const { return marks_[vertex] ^ stamp_; }
    /// Notes that a vertex has appeared; whether for the first time.
    bool note(std::uint32_t vertex) {
      const bool is_new = (marks_[vertex] ^ stamp_) >= kMost;
      if (is_new) marks_[vertex] = stamp_;
      return is_new;
    }

   private:
    friend class BoundaryNumbers;
    Numbering(std::uint32_t* marks, std::uint32_t stamp) : marks_(marks), stamp_(stamp) {}

    std::uint32_t* marks_;
    std::uint32_t stamp_;
    std::uint32_t count_ = 0;
  };

  explicit BoundaryNumbers(std::size_t vertices) : marks_(vertices) {}

  /// Ends the numbering before.
  [[nodiscard]] Numbering of_new_boundary() {
    stamp_ += kMost;
    if (stamp_ == 0) {  // all stamps have been used
      marks_.clear();
      stamp_ = kMost;
    }
    return {marks_.data(), stamp_};
  }

 private:
  UntouchedWords marks_;  // [vertex] stamp and number
  std::uint32_t stamp_ = 0;
};

/// The cells that one site invalidates, and their replacement by cells at that site.
///
/// Each facet of the boundary of the conflict region gets a new cell with the site, in the place of
/// a dead one while there are any. New cells are neighbours if they share a ridge of the boundary:
/// in space boundary vertices are numbered as they are met and a matrix over these numbers holds,
/// for each directed ridge, the facet to its left; its twin is the facet at the reversed ridge. In
/// the plane the facets that begin and end at a vertex are twins. No hashing, and no allocation
/// once arrays have grown.
template <int A, int D>
class ConflictRegion {
 public:
  /// What became of a site.
  enum class Outcome { inserted, hidden, postponed };

  /// Keeps references. Several may work on one store at the same time, each in a territory of its
  /// own.
  ConflictRegion(CellStore<A>& cells, const Sites<D>& sites)
      : cells_(cells),
        sites_(sites),
        search_(cells, sites),
        supply_(cells),
        numbers_(cells.infinity() + std::size_t{1}),
        left_of_(A == 3 ? kMatrix : cells.infinity() + std::size_t{1}) {}

  /// Replaces the cells in conflict with `site`, which the cell `found` contains. Appends to
  /// `hidden` the site, if it is hidden, or else the vertices that no longer have a cell. Postponed
  /// if a cell outside the territory is in conflict, or there is no room for new cells and
  /// `may_grow` does not allow for more; then nothing has changed.
  Outcome insert(std::uint32_t site, std::uint32_t found, const Territory<A, D>& territory,
                 bool may_grow, std::vector<std::uint32_t>& hidden) {
    // Where weights do not differ, what is in a cell is in its ball.
    const bool is_certain = sites_.is_unweighted() && cells_.is_finite(cells_[found]);
    if (!is_certain && !in_conflict<A, D>(cells_, sites_, found, site)) {
      hidden.push_back(site);
      return Outcome::hidden;
    }
    if (!search_.find(site, found, territory)) return Outcome::postponed;
    if (!place_new_cells(may_grow)) {
      search_.revive();
      return Outcome::postponed;
    }
    restar(site, hidden);
    return Outcome::inserted;
  }
  /// One of the cells of the site inserted last, from which a walk to `goal` is short: of up to
  /// kLookedAt of them, that of which one corner is nearest to it. Undefined unless the last site
  /// was inserted.
  [[nodiscard]] std::uint32_t new_cell_towards(std::uint32_t goal) const {
    const std::span<const Facet> boundary = search_.boundary();
    const std::size_t stride = (boundary.size() + kLookedAt - 1) / kLookedAt;
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < boundary.size(); f += stride) {
      const std::uint32_t corner = boundary[f].vertices[0];
      if (corner == cells_.infinity()) continue;  // which has no position
      const double square = square_distance(sites_[corner], sites_[goal]);
      nearest = square < least ? f : nearest;
      least = std::min(square, least);
    }
    return places_[nearest];
  }

  [[nodiscard]] CellSupply<A>& supply() { return supply_; }

 private:
  using Cell = CellRecord<A>;
  using Facet = BoundaryFacet<A>;
  using Numbers = std::array<std::uint32_t, std::size_t{A}>;  // of a facet's vertices

  static constexpr std::uint32_t kMatrixSide = 64;  // boundary vertices that the matrix can hold
  static constexpr std::uint32_t kMatrix = kMatrixSide * kMatrixSide;
  // A triangulated sphere has two triangles a vertex, less four.
  static constexpr std::size_t kMatrixFacets = 2 * kMatrixSide - 4;
  static constexpr std::uint32_t kCellsAtOnce = 1024;
  static constexpr std::size_t kLookedAt = 8;  // new cells, see new_cell_towards

  static double square_distance(const Site<D>& a, const Site<D>& b) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      sum += (a.x[axis] - b.x[axis]) * (a.x[axis] - b.x[axis]);
    }
    return sum;
  }

  // places_[f] becomes the cell at facet f; false if cells are lacking.
  bool place_new_cells(bool may_grow) {
    const std::span<const std::uint32_t> dead = search_.dead();
    const std::size_t count = search_.boundary().size();
    if (count > dead.size() && supply_.size() < count - dead.size()) {
      if (!may_grow) return false;
      supply_.add(static_cast<std::uint32_t>(std::max<std::size_t>(count, kCellsAtOnce)));
    }
    if (places_.size() < count) places_.resize(2 * count);
    const std::size_t reused = std::min(count, dead.size());
    std::copy_n(dead.begin(), reused, places_.begin());
    for (std::size_t f = reused; f < count; ++f) places_[f] = supply_.acquire();
    for (const std::uint32_t cell : dead.subspan(reused)) supply_.release(cell);
    return true;
  }

  void restar(std::uint32_t site, std::vector<std::uint32_t>& swallowed) {
    if constexpr (A == 3) {
      if (search_.boundary().size() <= kMatrixFacets) {
        const auto numbering = number_boundary();
        if (!sites_.is_unweighted()) note_swallowed(numbering, swallowed);
        return restar_by_matrix(site);
      }
    }
    if (!sites_.is_unweighted()) {
      auto numbering = numbers_.of_new_boundary();
      for (const Facet& facet : search_.boundary()) {
        for (const std::uint32_t vertex : facet.vertices) numbering.note(vertex);
      }
      note_swallowed(numbering, swallowed);
    }
    if constexpr (A == 1) restar_on_line(site);
    if constexpr (A == 2) restar_in_plane(site);
    if constexpr (A == 3) restar_by_sorting(site);
  }

  // Fills facet_numbers_, and the matrix with the facets to the left of ridges.
  typename BoundaryNumbers::Numbering number_boundary() {
    const std::span<const Facet> boundary = search_.boundary();
    if (facet_numbers_.size() < boundary.size()) facet_numbers_.resize(2 * boundary.size());
    Numbers* const facet_numbers = facet_numbers_.data();
    std::uint32_t* const left_of = left_of_.data();
    const std::uint32_t* const places = places_.data();
    auto numbering = numbers_.of_new_boundary();
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      const auto& vertices = boundary[f].vertices;
      Numbers n;
      for (std::size_t k = 0; k < A; ++k) n[k] = numbering.number(vertices[k]);
      facet_numbers[f] = n;
      const std::uint32_t facet = 4 * places[f] + 1;
      left_of[n[1] * kMatrixSide + n[2]] = facet;
      left_of[n[2] * kMatrixSide + n[0]] = facet + 1;
      left_of[n[0] * kMatrixSide + n[1]] = facet + 2;
    }
    return numbering;
  }

  void restar_by_matrix(std::uint32_t site) {
    const std::span<const Facet> boundary = search_.boundary();
    const Numbers* const facet_numbers = facet_numbers_.data();
    const std::uint32_t* const left_of = left_of_.data();
    const std::uint32_t* const places = places_.data();
    Cell* const cells = &cells_[0];
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      const Numbers n = facet_numbers[f];
      const std::uint32_t outside = boundary[f].outside;
      Words corners;
      std::memcpy(&corners, &boundary[f], sizeof corners);
      corners[0] = site;
      const Words neighbours = {outside, left_of[n[2] * kMatrixSide + n[1]],
                                left_of[n[0] * kMatrixSide + n[2]],
                                left_of[n[1] * kMatrixSide + n[0]]};
      std::memcpy(&cells[places[f]].corners, &corners, sizeof corners);
      std::memcpy(&cells[places[f]].neighbours, &neighbours, sizeof neighbours);
      cells[outside / 4].neighbours[outside % 4] = 4 * places[f];
    }
  }

  // The boundary is a cycle: left_of_[v] is the cell at the facet that begins at v.
  void restar_in_plane(std::uint32_t site) {
    const std::span<const Facet> boundary = search_.boundary();
    std::uint32_t* const left_of = left_of_.data();
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      left_of[boundary[f].vertices[0]] = places_[f];
    }
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      const auto [outside, vertices] = boundary[f];
      const std::uint32_t next = left_of[vertices[1]];
      cells_[places_[f]].corners = {site, vertices[0], vertices[1]};
      cells_[places_[f]].neighbours[0] = outside;
      cells_[places_[f]].neighbours[1] = 4 * next + 2;
      cells_[next].neighbours[2] = 4 * places_[f] + 1;
      cells_[outside / 4].neighbours[outside % 4] = 4 * places_[f];
    }
  }

  // For the rare region with so many vertices that a matrix would not pay.
  void restar_by_sorting(std::uint32_t site) {
    const std::span<const Facet> boundary = search_.boundary();
    std::vector<std::pair<std::uint64_t, std::uint32_t>> facets;  // at each ridge two
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      const auto& [outside, vertices] = boundary[f];
      Cell& cell = cells_[places_[f]];
      cell.corners = {site, vertices[0], vertices[1], vertices[2]};
      cell.neighbours[0] = outside;
      cells_[outside / 4].neighbours[outside % 4] = 4 * places_[f];
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
      const auto [outside, vertices] = search_.boundary()[f];
      const std::uint32_t at = 1 - outside % 4;
      Cell& record = cells_[places_[f]];
      record.corners[at] = site;
      record.corners[1 - at] = vertices[0];
      record.neighbours[at] = outside;
      record.neighbours[1 - at] = 4 * places_[1 - f] + at;
      cells_[outside / 4].neighbours[outside % 4] = 4 * places_[f] + at;
    }
  }

  // Vertices of dead cells that are not on the boundary have lost their power cell. Few have any.
  void note_swallowed(typename BoundaryNumbers::Numbering boundary,
                      std::vector<std::uint32_t>& swallowed) const {
    std::uint32_t marks = 0;
    for (const std::uint32_t cell : search_.dead()) {
      for (const std::uint32_t vertex : cells_[cell].corners) marks |= boundary.mark(vertex);
    }
    if (marks < BoundaryNumbers::kMost) return;
    for (const std::uint32_t cell : search_.dead()) {
      for (const std::uint32_t vertex : cells_[cell].corners) {
        if (boundary.note(vertex)) swallowed.push_back(vertex);
      }
    }
  }

  CellStore<A>& cells_;
  const Sites<D>& sites_;
  ConflictSearch<A, D> search_;
  CellSupply<A> supply_;
  std::vector<std::uint32_t> places_;  // [facet] where its new cell goes
  std::vector<Numbers> facet_numbers_;
  BoundaryNumbers numbers_;
  // In space [place of a directed ridge] the facet to its left, in the plane see restar_in_plane.
  UntouchedWords left_of_;
};

}  // namespace orthoball
