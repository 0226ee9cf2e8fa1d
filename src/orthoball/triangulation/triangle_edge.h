// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// One directed edge of one triangle, seen from one of the (at most two) tetrahedra at the
/// triangle: the edge `from` `to` of the triangle `from` `to` `third`, all corners of `cell`.
/// A regular value of eight bytes; it means something together with the TriangleEdges it is of.
struct TriangleEdge {
  std::uint32_t cell = kOutside;
  std::uint8_t from = 0, to = 1, third = 2, apex = 3;  ///< the corners 0..3 in some order

  [[nodiscard]] bool exists() const { return cell != kOutside; }
  friend bool operator==(const TriangleEdge&, const TriangleEdge&) = default;
};

/// Walks over the triangles and edges of a triangulation of space: a view of its cells, which must
/// stay. Every step is O(1) and reads at most two cells.
///
/// Two steps are all that is needed: `next_edge` goes around a triangle, `next_triangle` around an
/// edge. The second is made of two halves, through the cell and to its neighbour, because on the
/// hull only the first exists. Vertices are numbers of sites of the triangulation.
/// @cite dobkin_laszlo_1989  @cite mucke_1993
class TriangleEdges {
 public:
  /// Without triangles unless the sites span space.
  explicit TriangleEdges(const RegularTriangulation<3>& triangulation)
      : cells_(triangulation.cells<3>()) {}

  /// The triangle opposite corner `facet` of `cell`, counterclockwise as seen from outside the
  /// cell, at its first edge.
  [[nodiscard]] static TriangleEdge triangle(std::uint32_t cell, std::uint32_t facet) {
    constexpr std::array<std::array<std::uint8_t, 3>, 4> kOutward{
        {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    const auto& corners = kOutward[facet];
    return {cell, corners[0], corners[1], corners[2], static_cast<std::uint8_t>(facet)};
  }

  /// The edge's two vertices, then the third of the triangle, then the fourth of the cell.
  [[nodiscard]] std::array<std::uint32_t, 4> vertices(const TriangleEdge& at) const {
    const auto& corners = cells_[at.cell].corners;
    return {corners[at.from], corners[at.to], corners[at.third], corners[at.apex]};
  }

  /// The edge that begins where this one ends, in the same triangle. Three steps go around it.
  [[nodiscard]] static TriangleEdge next_edge(const TriangleEdge& at) {
    return {at.cell, at.to, at.third, at.from, at.apex};
  }
  /// The same edge in the other direction.
  [[nodiscard]] static TriangleEdge reversed(const TriangleEdge& at) {
    return {at.cell, at.to, at.from, at.third, at.apex};
  }
  /// The same edge in the other triangle of the cell that has it.
  [[nodiscard]] static TriangleEdge other_triangle(const TriangleEdge& at) {
    return {at.cell, at.from, at.to, at.apex, at.third};
  }
  /// The same edge of the same triangle, seen from its other cell; none on the hull.
  [[nodiscard]] TriangleEdge other_side(const TriangleEdge& at) const {
    const auto& cell = cells_[at.cell];
    const std::uint32_t beyond = cell.neighbours[at.apex];
    if (beyond == kOutside) return {};
    const auto& corners = cells_[beyond / 4].corners;
    const auto corner_of = [&](std::uint32_t vertex) -> std::uint8_t {
      return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : corners[2] == vertex ? 2 : 3;
    };
    const std::uint8_t from = corner_of(cell.corners[at.from]);
    const std::uint8_t to = corner_of(cell.corners[at.to]);
    const auto apex = static_cast<std::uint8_t>(beyond % 4);
    return {beyond / 4, from, to, static_cast<std::uint8_t>(6 - from - to - apex), apex};
  }
  /// The same edge in the next triangle around it, through the cell; none where that triangle is on
  /// the hull (it is `other_triangle` then).
  [[nodiscard]] TriangleEdge next_triangle(const TriangleEdge& at) const {
    return other_side(other_triangle(at));
  }

  /// The edge once in each cell around it, in the order of `next_triangle`: from `at`, or from the
  /// hull where the edge is on the hull. There the triangles are one more than the cells: the last
  /// is `other_triangle` of the last. Linear in the cells around the edge.
  [[nodiscard]] std::vector<TriangleEdge> ring(const TriangleEdge& at) const;

  /// The triangles opposite the vertex `from`, in its cells: a sphere around a vertex inside, a
  /// disc around one on the hull. Counterclockwise as seen from outside. O(k log k) for k cells.
  [[nodiscard]] std::vector<TriangleEdge> link(const TriangleEdge& at) const;

  /// The triangles of the convex hull, one edge of each, counterclockwise as seen from outside, by
  /// cell. Linear in the cells of the triangulation.
  [[nodiscard]] std::vector<TriangleEdge> hull() const;
  /// From an edge of a triangle on the hull: the edge reversed, in the other triangle on the hull.
  /// Linear in the cells around the edge.
  [[nodiscard]] TriangleEdge next_on_hull(const TriangleEdge& at) const;

 private:
  std::span<const CellRecord<3>> cells_;
};

}  // namespace orthoball
