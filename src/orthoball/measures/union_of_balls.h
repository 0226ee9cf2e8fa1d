// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// Where two balls of a union touch: the common facet of their power cells inside the union.
struct Contact {
  std::array<SiteId, 2> rows;   ///< ascending
  double area = 0.0;            ///< of the facet; length^2, in the plane its length
  double exposed_length = 0.0;  ///< of their circle on the surface; in the plane the number
                                ///< of their two points there
};

/// How volume and area change with single balls. Where balls just touch, from outside or inside,
/// an area has no derivative, and what stands here is that of balls a little larger.
struct UnionDerivatives {
  // dV / d radius is the ball's area.
  std::vector<double> area_by_radius;    ///< [row]; length^(D-2)
  std::vector<double> volume_by_centre;  ///< [D * row + axis]; length^(D-1)
  std::vector<double> area_by_centre;    ///< [D * row + axis]; length^(D-2)
};

/// The union of balls of squared radius weight + alpha2: its measures and those of each ball's
/// part, which is the ball cut by its power cell. In input units, infinite beyond the double range.
///
/// In the plane `volume` is the area of the union and `area` its perimeter. Balls of negative
/// squared radius are empty; they, hidden balls and duplicates of earlier rows have no part.
///
/// Which balls meet is decided exactly; the measures err by a few 2^-53 of the area and volume of
/// the balls for every neighbour, as long as lengths differ by less than 2^400 in size. Totals are
/// the sums of the parts.
struct UnionOfBalls {
  std::uint32_t index = 0;         ///< of the alpha complex that is dual to the union
  double alpha2 = 0.0;             ///< length^2
  double volume = 0.0;             ///< length^D
  double area = 0.0;               ///< of the surface, voids included; length^(D-1)
  double mean_curvature = 0.0;     ///< in space: integral of (k1 + k2) / 2, see below; length
  std::int64_t euler = 0;          ///< Euler number of the union
  std::vector<double> volumes;     ///< [row]
  std::vector<double> areas;       ///< [row]
  std::vector<Contact> contacts;   ///< by rows; empty unless wanted
  UnionDerivatives derivatives{};  ///< empty unless wanted
};
// Mean curvature counts the arcs in which spheres meet, with - length x angle between the outward
// normals / 2.

/// What else is wanted of a union, and how it is computed.
struct UnionOptions {
  bool contacts = false;
  bool derivatives = false;
  Threads threads{};
};

/// The union of the balls whose dual complex is K_index.
///
/// Each ball's part is measured from where it ends: at its sphere, and at the facets that its power
/// cell has in common with others. An edge of the complex is a facet, walked around once; what
/// covers the circle and disk there is told by the triangles and tetrahedra around the edge.
///
/// Linear in the simplices around edges of K_index; the same on any number of threads.
/// @param alpha2  length^2 in input units; any number between the label of the index and the next.
/// @throws InputError for an index beyond the spectrum's size or an alpha2 that is not finite.
/// @cite edelsbrunner_1995
template <int D>
[[nodiscard]] UnionOfBalls union_of_balls(const Filtration<D>& filtration, std::uint32_t index,
                                          double alpha2, const UnionOptions& options);

extern template UnionOfBalls union_of_balls<2>(const Filtration<2>&, std::uint32_t, double,
                                               const UnionOptions&);  // in union_of_balls.cpp
extern template UnionOfBalls union_of_balls<3>(const Filtration<3>&, std::uint32_t, double,
                                               const UnionOptions&);

}  // namespace orthoball
