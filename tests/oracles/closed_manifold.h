// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orthoball::oracles {

/// What a mesh file says of its surface, or in the plane of its outline.
struct MeshFile {
  /// Why it is no oriented closed manifold; empty if it is one.
  std::vector<std::string> faults;
  /// What the surface encloses: positive where facets turn counterclockwise seen from outside, and
  /// edges have the inside on their left.
  double volume = 0.0;
  std::size_t facets = 0;
};

/// Reads a binary PLY as the program writes it, and nothing else. A manifold has every side of a
/// triangle once in each direction, no triangle twice, and around every vertex one ring of
/// triangles; in the plane one edge comes to every vertex and one leaves it. No two vertices are in
/// one place, and all are used.
[[nodiscard]] MeshFile mesh_file(std::string_view ply, int dimension);

}  // namespace orthoball::oracles
