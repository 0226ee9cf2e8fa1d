// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"
#include "orthoball/queries/free_space.h"

namespace orthoball {

/// A bounded component of the complement of a union of balls, or of an alpha shape; in the plane a
/// hole. In input units.
///
/// It lives from the index at which the last triangle (in the plane: edge) closes it to that at
/// which its last cell fills it. Where a triangle divides a void in two, the one that is filled
/// first is born there: these are the pairs of persistent homology. Of two that are filled at the
/// same index, that whose last cell has the smaller number counts as the first.
template <int D>
struct Void {
  double volume = 0.0;               ///< length^D
  double area = 0.0;                 ///< length^(D-1)
  std::vector<LiningBall> lining;    ///< by row; of an alpha shape, the vertices around, area 0
  std::vector<SimplexId> cells;      ///< of the triangulation, outside the complex; ascending
  std::uint32_t born = 0, dies = 0;  ///< indices of the spectrum
  double born_alpha2 = 0.0, dies_alpha2 = 0.0;  ///< their labels; length^2
  /// The largest ball inside: exact but for rounding where the lining balls are equal; otherwise
  /// hardly any void has one that is larger by more than 1 % (see largest_ball.h). Radius 0
  /// where none was found, and in voids of an alpha shape: what bounds a ball there are facets and
  /// edges, too.
  std::array<double, std::size_t{D}> largest_ball_centre{};
  double largest_ball_radius = 0.0;  ///< length
};

/// What the voids are holes of. Both have the same voids, made of the same cells; those of the
/// shape are larger by what the balls cover of them.
enum class VoidsOf {
  balls,  ///< the union of balls
  shape,  ///< the alpha shape, the polyhedron that the union contains
};

/// The voids at one index, largest first; equal volumes by the lowest row. Their number is betti
/// D - 1 of the complex. Which cells are whose is exact; measures are as those of UnionOfBalls.
///
/// Time grows little faster than the number of simplices.
/// @param alpha2  length^2, as for union_of_balls.
/// @throws InputError for an index beyond the spectrum's size.
/// @cite edelsbrunner_1995  @cite liang_1998_cavities
template <int D>
[[nodiscard]] std::vector<Void<D>> voids(const Filtration<D>& filtration, std::uint32_t index,
                                         double alpha2, VoidsOf of, Threads threads = {});

extern template std::vector<Void<2>> voids<2>(const Filtration<2>&, std::uint32_t, double, VoidsOf,
                                              Threads);  // in voids.cpp
extern template std::vector<Void<3>> voids<3>(const Filtration<3>&, std::uint32_t, double, VoidsOf,
                                              Threads);

}  // namespace orthoball
