// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/exact/sites.h"
#include "orthoball/ids.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// A row that is equal to an earlier one in centre and weight.
struct Duplicate {
  SiteId row;
  SiteId representative;  ///< the lowest equal row
  friend bool operator==(const Duplicate&, const Duplicate&) = default;
};

/// The neighbour across a facet of the convex hull.
inline constexpr std::uint32_t kOutside = 0xFFFFFFFFU;

/// One cell of a triangulation of affine dimension A: 32 bytes for a tetrahedron.
///
/// Neighbour i lies across the facet opposite corner i. It is written `4 * cell + corner`, where
/// `corner` is the corner of that cell opposite the common facet, or kOutside. Corners ascend, but
/// for the last two, which change places where the cell would be negatively oriented without (only
/// where A is the dimension of space: a triangle in space has no orientation).
template <int A>
struct alignas(A == 3 ? 32 : 4) CellRecord {
  std::array<std::uint32_t, std::size_t{A + 1}> corners;     ///< vertices by number
  std::array<std::uint32_t, std::size_t{A + 1}> neighbours;  ///< 4 * cell + corner, or kOutside
};

/// [cell]: the cells of a triangulation.
template <int A>
using CellArray = RawVector<CellRecord<A>>;

/// The regular (weighted Delaunay) triangulation of weighted points: Del B of the paper.
///
/// Guaranteed: the exact triangulation of the input numbers, ties decided by lowering weights
/// infinitesimally, the largest position most (perturbation.h); so it is unique and depends on the
/// set of sites alone. Vertices are numbered along a space-filling curve, cells by their smallest
/// corners: neighbours in space are neighbours in memory. Immutable; any number of threads may
/// read.
///
/// Sites that span less than R^D (all equal, collinear, coplanar) are triangulated in their span:
/// cells are simplices of affine_dimension().
///
/// Costs about 260 bytes a site in space.  @cite edelsbrunner_shah_1996
template <int D>
class RegularTriangulation {
 public:
  RegularTriangulation() = default;  // of no sites

  /// -1 without sites, otherwise the dimension of their affine hull.
  [[nodiscard]] int affine_dimension() const { return parts_.affine_dimension; }
  /// The vertices by number, with their input rows; hidden and duplicate sites are not among them.
  [[nodiscard]] const Sites<D>& sites() const { return parts_.sites; }
  [[nodiscard]] std::size_t vertex_count() const { return parts_.sites.size(); }
  /// Simplices of dimension affine_dimension().
  [[nodiscard]] std::size_t cell_count() const {
    return parts_.affine_dimension <= 0
               ? vertex_count()
               : parts_.segments.size() + parts_.triangles.size() + parts_.tetrahedra.size();
  }

  /// [cell]: the cells, 1 <= A <= D; empty unless A is affine_dimension(). Valid as long as this.
  template <int A>
  [[nodiscard]] std::span<const CellRecord<A>> cells() const {
    if constexpr (A == 1) return parts_.segments;
    if constexpr (A == 2) return parts_.triangles;
    if constexpr (A == 3) return parts_.tetrahedra;
  }

  /// Rows of the sites whose power cell is empty, ascending. Duplicates are never listed here.
  [[nodiscard]] std::span<const SiteId> hidden() const { return parts_.hidden; }
  /// Every row that is equal to an earlier one, ascending by row.
  [[nodiscard]] std::span<const Duplicate> duplicates() const { return parts_.duplicates; }
  /// Input rows less duplicates; all input rows.
  [[nodiscard]] std::size_t distinct_site_count() const {
    return vertex_count() + parts_.hidden.size();
  }
  [[nodiscard]] std::size_t site_count() const {
    return distinct_site_count() + parts_.duplicates.size();
  }

  /// The arrays of a triangulation, made by `regular_triangulation`, which guarantees them.
  struct Parts {
    int affine_dimension = -1;
    Sites<D> sites;
    CellArray<1> segments;              // empty unless affine_dimension is 1
    CellArray<2> triangles;             // ... 2
    CellArray<3> tetrahedra;            // ... 3
    std::vector<SiteId> hidden;         // ascending
    std::vector<Duplicate> duplicates;  // ascending by row
  };
  explicit RegularTriangulation(Parts parts) : parts_(std::move(parts)) {}

 private:
  Parts parts_;
};

}  // namespace orthoball
