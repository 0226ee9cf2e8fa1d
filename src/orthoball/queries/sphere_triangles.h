// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace orthoball {

/// A convex polyhedron of triangles with its corners on the unit sphere.
struct SphereTriangles {
  std::vector<std::array<double, 3>> corners;     ///< [corner][axis]
  std::vector<std::array<std::uint32_t, 3>> all;  ///< counterclockwise as seen from outside
};

/// An icosahedron whose triangles are divided in four until none is further from the sphere than
/// `tolerance`, > 0: 20 * 4^k triangles, about 7 / tolerance.
[[nodiscard]] SphereTriangles sphere_triangles(double tolerance);

}  // namespace orthoball
