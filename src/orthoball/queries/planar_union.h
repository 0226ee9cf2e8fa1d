// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"

namespace orthoball {

/// A piece of the boundary of a disk's part: an arc of its circle, on the boundary of the union, or
/// a segment that it shares with the part of a neighbour.
struct DiskPiece {
  std::array<double, 2> from{}, to{};  ///< its ends
  double turn = 0.0;   ///< of an arc, counterclockwise, in [0, 2 pi] radians; of a segment 0
  SiteId neighbour{};  ///< of a segment the other disk's row; of an arc none

  [[nodiscard]] bool is_arc() const { return !neighbour.exists(); }
};

/// The part that a disk has of a union: the disk cut by its power cell.
struct DiskPart {
  SiteId row;
  std::array<double, 2> centre{};  ///< of the disk
  double radius = 0.0;
  std::vector<DiskPiece> boundary;  ///< counterclockwise; each begins where the one before ends
};

/// An arc of the boundary of a union: boundary[piece] of parts[part].
struct OutlineArc {
  std::uint32_t part = 0, piece = 0;
};

/// A union of disks in the plane as it is drawn. In input units.
struct PlanarUnion {
  std::vector<DiskPart> parts;  ///< of the disks that have one, along the vertices
  /// Closed curves with the union to the left: outer ones counterclockwise, around holes clockwise.
  std::vector<std::vector<OutlineArc>> outline;
};

/// The union of the disks whose dual complex is K_index. What borders what is exact, points are
/// rounded: a point that several parts have in common is the same in all of them.
///
/// Linear in the number of simplices.
/// @param alpha2  length^2 in input units, as for union_of_balls.
/// @throws InputError for an index beyond the spectrum's size or an alpha2 that is not finite.
[[nodiscard]] PlanarUnion planar_union(const Filtration<2>& filtration, std::uint32_t index,
                                       double alpha2);

}  // namespace orthoball
