// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "orthoball/exact/perturbation.h"
#include "orthoball/triangulation/cell_store.h"

namespace orthoball {

/// The cells that one site invalidates, and their replacement by cells at that site.
///
/// The cells in conflict form a ball around the site (perturbation leaves no ties), so they are
/// found by a search over neighbours, and each facet of the ball's boundary makes one new cell with
/// the site. Facets of new cells at the site are matched by the ridge they do not share with the
/// boundary walk: a matrix over the ball's boundary vertices, numbered as they are met, holds for
/// each directed ridge the facet to its left; its twin is the reversed ridge. No hashing, no
/// allocation once the arrays have grown.
template <int A, int D>
class ConflictRegion {
 public:
  ConflictRegion(CellStore<A>& cells, const Sites<D>& sites)
      : cells_(cells), sites_(sites), number_of_(sites.size() + 1, 0), twins_(kMatrix) {}

  /// Whether `site` is in conflict with `cell`. Exact.
  [[nodiscard]] bool in_conflict(std::uint32_t cell, std::uint32_t site) const {
    const auto& record = cells_[cell];
    const std::size_t infinite = cells_.corner_at_infinity(record);
    if (infinite > A) return orthoball::in_conflict<A, D>(sites_, record.corners, site);
    // At infinity: strictly beyond the hull facet, or in its plane and in conflict within it. There
    // the finite cell behind the facet answers: its orthosphere cuts the plane in the facet's.
    Corners<A> corners = record.corners;
    corners[infinite] = site;
    const Sign side = orient<A, D>(sites_, corners);
    if (side != Sign::zero) return side == Sign::positive;
    const std::uint32_t inside = record.neighbours[infinite] / 4;
    return orthoball::in_conflict<A, D>(sites_, cells_[inside].corners, site);
  }

  /// Replaces the cells in conflict with `site`, found from `start`, which is one of them. Appends
  /// to `swallowed` the vertices that no longer have a cell. Returns one of the new cells.
  std::uint32_t insert(std::uint32_t site, std::uint32_t start,
                       std::vector<std::uint32_t>& swallowed) {
    find(site, start);
    number_boundary_vertices();
    if (!sites_.is_unweighted()) note_swallowed(swallowed);
    restar();
    return boundary_.back().cell;
  }

 private:
  // A facet of the region's boundary, as the new cell over it.
  struct BoundaryFacet {
    Corners<A> corners;     // the dead cell's, with the site in the place of the corner inside
    std::uint32_t outside;  // 4 * cell + corner on the other side
    std::uint32_t site_at;  // which corner is the site
    std::uint32_t cell;     // number given to the new cell
  };

  static constexpr std::size_t kMatrixSide = 64;  // boundary vertices that the matrix can hold
  static constexpr std::size_t kMatrix = kMatrixSide * kMatrixSide;

  // Breadth-first: dead_ is the queue. Marks: 2 visit for a tested cell, 2 visit + 1 in conflict.
  void find(std::uint32_t site, std::uint32_t start) {
    visit_ += 2;
    dead_.clear();
    boundary_.clear();
    dead_.push_back(start);
    cells_.mark(start) = visit_ + 1;
    for (std::size_t next = 0; next < dead_.size(); ++next) {
      const auto record = cells_[dead_[next]];
      for (std::size_t i = 0; i <= A; ++i) {
        const std::uint32_t outside = record.neighbours[i];
        std::uint32_t& mark = cells_.mark(outside / 4);
        if (mark == visit_ + 1) continue;
        if (mark != visit_) {
          if (in_conflict(outside / 4, site)) {
            mark = visit_ + 1;
            dead_.push_back(outside / 4);
            continue;
          }
          mark = visit_;
        }
        BoundaryFacet facet{record.corners, outside, static_cast<std::uint32_t>(i), 0};
        facet.corners[i] = site;
        boundary_.push_back(facet);
      }
    }
  }

  // A vertex is on the boundary if its number points back at it: nothing to reset between visits.
  [[nodiscard]] bool is_numbered(std::uint32_t vertex) const {
    const std::uint32_t number = number_of_[vertex];
    return number < numbered_.size() && numbered_[number] == vertex;
  }

  void number_boundary_vertices() {
    numbered_.clear();
    for (const BoundaryFacet& facet : boundary_) {
      for (std::size_t i = 0; i <= A; ++i) {
        const std::uint32_t vertex = facet.corners[i];
        if (i == facet.site_at || is_numbered(vertex)) continue;
        number_of_[vertex] = static_cast<std::uint32_t>(numbered_.size());
        numbered_.push_back(vertex);
      }
    }
  }

  // Vertices of dead cells that are not on the boundary have lost their power cell.
  void note_swallowed(std::vector<std::uint32_t>& swallowed) {
    for (const std::uint32_t cell : dead_) {
      for (const std::uint32_t vertex : cells_[cell].corners) {
        if (is_numbered(vertex)) continue;
        number_of_[vertex] = static_cast<std::uint32_t>(numbered_.size());
        numbered_.push_back(vertex);
        swallowed.push_back(vertex);
      }
    }
  }

  // The directed ridge that a facet at the site, opposite `corner`, shares with the boundary, as a
  // place in the matrix, and the place of its reverse.
  [[nodiscard]] std::pair<std::size_t, std::size_t> ridge(const BoundaryFacet& facet,
                                                          std::size_t corner,
                                                          std::size_t side) const {
    const std::size_t at = facet.site_at;
    if constexpr (A == 1) {
      return at < corner ? std::pair<std::size_t, std::size_t>{0, 1}
                         : std::pair<std::size_t, std::size_t>{1, 0};
    } else if constexpr (A == 2) {
      const std::size_t vertex = number_of_[facet.corners[3 - at - corner]];
      const bool even = (at + 1) % 3 == corner;
      return {2 * vertex + (even ? 0 : 1), 2 * vertex + (even ? 1 : 0)};
    } else {
      // (at, corner, from, to) is an even permutation of the corners.
      static constexpr std::uint8_t kFrom[4][4] = {
          {0, 2, 3, 1}, {3, 0, 0, 2}, {1, 3, 0, 0}, {2, 0, 1, 0}};
      const std::size_t from = kFrom[at][corner];
      const std::size_t to = 6 - at - corner - from;
      const std::size_t a = number_of_[facet.corners[from]];
      const std::size_t b = number_of_[facet.corners[to]];
      return {a * side + b, b * side + a};
    }
  }

  void restar() {
    // Dead cells give their places to new ones while their lines are in the cache.
    std::size_t reused = 0;
    for (BoundaryFacet& facet : boundary_) {
      facet.cell = reused < dead_.size() ? dead_[reused++] : cells_.acquire();
      auto& record = cells_[facet.cell];
      record.corners = facet.corners;
      cells_.mark(facet.cell) = 0;
      cells_.join(4 * facet.cell + facet.site_at, facet.outside);
    }
    for (; reused < dead_.size(); ++reused) cells_.release(dead_[reused]);

    const std::size_t side = A < 3 ? 2 : numbered_.size();
    const std::size_t places = A < 3 ? 2 * numbered_.size() + 2 : side * side;
    if (A < 3 || side <= kMatrixSide) {
      if (places > twins_.size()) twins_.resize(places);
      join_by_matrix(side);
    } else {
      join_by_sorting(side);
    }
  }

  void join_by_matrix(std::size_t side) {
    for (const BoundaryFacet& facet : boundary_) {
      for (std::size_t i = 0; i <= A; ++i) {
        if (i == facet.site_at) continue;
        twins_[ridge(facet, i, side).first] = 4 * facet.cell + static_cast<std::uint32_t>(i);
      }
    }
    for (const BoundaryFacet& facet : boundary_) {
      for (std::size_t i = 0; i <= A; ++i) {
        if (i == facet.site_at) continue;
        cells_[facet.cell].neighbours[i] = twins_[ridge(facet, i, side).second];
      }
    }
  }

  // For the rare region with so many vertices that a matrix would not pay.
  void join_by_sorting(std::size_t side) {
    std::vector<std::pair<std::size_t, std::uint32_t>> facets;  // by ridge
    for (const BoundaryFacet& facet : boundary_) {
      for (std::size_t i = 0; i <= A; ++i) {
        if (i == facet.site_at) continue;
        facets.emplace_back(ridge(facet, i, side).first,
                            4 * facet.cell + static_cast<std::uint32_t>(i));
      }
    }
    std::sort(facets.begin(), facets.end());
    for (const BoundaryFacet& facet : boundary_) {
      for (std::size_t i = 0; i <= A; ++i) {
        if (i == facet.site_at) continue;
        const std::pair<std::size_t, std::uint32_t> twin{ridge(facet, i, side).second, 0};
        cells_[facet.cell].neighbours[i] =
            std::lower_bound(facets.begin(), facets.end(), twin)->second;
      }
    }
  }

  CellStore<A>& cells_;
  const Sites<D>& sites_;
  std::uint32_t visit_ = 0;
  std::vector<std::uint32_t> dead_;
  std::vector<BoundaryFacet> boundary_;
  std::vector<std::uint32_t> numbered_;   // [number] boundary vertex
  std::vector<std::uint32_t> number_of_;  // [vertex]
  std::vector<std::uint32_t> twins_;      // [ridge] facet to its left
};

}  // namespace orthoball
