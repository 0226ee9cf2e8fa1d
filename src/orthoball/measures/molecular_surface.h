// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// The solvent-excluded body of a molecule and its molecular surface: all points that no probe
/// reaches whose centre stays outside the union of the accessible balls. In input units.
///
/// Its surface is convex where the probe touches one ball, toroidal where it rolls on two, concave
/// where it rests on three. Voids that a probe fits in count, as they do in the union.
///
/// Closed forms in every case, also where the surface would meet itself: tori are cut at their
/// axis, and probes that reach through the triangle they rest on, or into each other, at the planes
/// between them. Errors are those of rounding: of the volume a few 2^-53 of the accessible union's,
/// of which it is a difference, of areas a few 2^-53 times probe^2 for every arc and triangle. So
/// of a probe 1000 times as large as the balls the volume has some 7 digits, and none that is a
/// million times as large. All is infinite where the union's volume or area is.
struct MolecularSurface {
  double probe = 0.0;   ///< radius; length
  double volume = 0.0;  ///< of the body; length^3
  double area = 0.0;    ///< sum of the three below; length^2
  double convex_area = 0.0;
  double toroidal_area = 0.0;
  double concave_area = 0.0;
};

/// The molecular surface of balls in space under a spherical probe.
///
/// What a probe leaves of the union of accessible balls is told by the point of its surface that is
/// nearest: a point of a sphere, of an arc of a circle or one where three spheres meet. In the
/// pieces of the union around these it is that sphere, circle or point, and in the cells of the
/// dual complex the nearest of the points where three meet. See
/// docs/derivations/molecular_surface.md.
///
/// Nearly linear in the boundary of the dual complex for probes as large as the balls, see
/// probes_at_rest.h; the same on any number of threads.
/// @param accessible  union_of_balls of the filtration, whose weights belong to radii with the
///                    probe's added, see with_probe.
/// @param probe       its radius; input units. With 0 the surface is that of the union.
/// @throws InputError for a probe that is negative or not finite.
/// @cite connolly_1983  @cite quan_stamm_2016
[[nodiscard]] MolecularSurface molecular_surface(const Filtration<3>& filtration,
                                                 const UnionOfBalls& accessible, double probe,
                                                 Threads threads = {});

}  // namespace orthoball
