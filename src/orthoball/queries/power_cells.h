// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// A box with its sides along the axes; length.
template <int D>
struct Box {
  std::array<double, std::size_t{D}> lower{};  ///< [axis]
  std::array<double, std::size_t{D}> upper{};  ///< [axis]
};

/// A facet of a power cell: a polygon, in the plane a side.
struct PowerFacet {
  SiteId neighbour;         ///< whose power cell is behind it; none where the box or the ball is
  std::uint8_t side = 0;    ///< of the box: 2 * axis + (0: the lower, 1: the upper)
  std::uint32_t begin = 0;  ///< of its corners in `loops`
  std::uint32_t end = 0;    ///< one behind the last
};

/// The power cell of one site, cut by a box or by the site's ball: where no other site has a
/// smaller power distance. Convex. In input units; in the plane volumes are areas, areas lengths.
template <int D>
struct PowerCell {
  SiteId row;
  double volume = 0.0;            ///< length^D
  double area = 0.0;              ///< of its whole surface; length^(D-1)
  double exposed_area = 0.0;      ///< of that, what is on the box or on the sphere
  std::uint32_t facet_count = 0;  ///< neighbours with a facet in common
  bool is_clipped = false;        ///< the box or the ball cuts it, or it lies beyond
  // Its surface, closed; nothing unless wanted, or where the volume is 0.
  std::vector<std::array<double, std::size_t{D}>> corners;
  /// In the plane counterclockwise, facet i from corner i to the next.
  std::vector<PowerFacet> facets;
  /// Corners of facets; counterclockwise as seen from outside, of sides the two ends.
  std::vector<std::uint32_t> loops;
};

/// What else is wanted of power cells, and how they are computed.
struct PowerCellOptions {
  static constexpr double kLeastTolerance = 1e-4, kLargestTolerance = 0.5;
  bool surfaces = true;     ///< their corners and facets
  double tolerance = 0.02;  ///< of spheres: the largest distance of a surface from them, by radius
  Threads threads{};
};

/// The box around all balls of squared radius weight + alpha2, and around the centres of those
/// that have none, each side moved out by a tenth of the longest; by 1/2 around a single point.
/// Without sites a box from 0 to 0.
/// @throws InputError for an alpha2 that is not finite.
template <int D>
[[nodiscard]] Box<D> box_around(const Filtration<D>& filtration, double alpha2);

/// The power cells of all vertices, cut by a box, by row. Hidden sites and duplicates of earlier
/// rows have none. Flat ones, without an inside, have volume 0 and no facets; what is on their two
/// sides are neighbours of each other.
///
/// Which cells are neighbours is decided exactly but where a facet's place in the box is concerned;
/// the box is full, and both sides of a facet are equal, but for rounding: a few 2^-53 of volumes
/// and areas, as long as lengths differ by less than 2^400 in size. Linear in the neighbours but
/// for their facets: quadratic for a cell that has very many. The same on any number of threads.
/// @throws InputError for a box whose upper side is not above the lower, or not finite.
/// @cite aurenhammer_1987
template <int D>
[[nodiscard]] std::vector<PowerCell<D>> power_cells(const Filtration<D>& filtration,
                                                    const Box<D>& box,
                                                    const PowerCellOptions& options);

/// The power cells of the vertices whose balls are not empty, each cut by its ball: what they have
/// of the union, by row. Numbers are those of the union, not of the surfaces, which are a polytope
/// with corners on the sphere, cut by the same planes: inside the ball, and no further from its
/// surface than the tolerance says. Facets that two of these have in common may differ as much.
/// @param balls  a union of the filtration's balls, with its contacts.
/// @throws InputError for a tolerance that is not from kLeastTolerance to kLargestTolerance.
template <int D>
[[nodiscard]] std::vector<PowerCell<D>> power_cells_in_balls(const Filtration<D>& filtration,
                                                             const UnionOfBalls& balls,
                                                             const PowerCellOptions& options);

extern template Box<2> box_around(const Filtration<2>&, double);  // defined in power_cells.cpp
extern template Box<3> box_around(const Filtration<3>&, double);
extern template std::vector<PowerCell<2>> power_cells(const Filtration<2>&, const Box<2>&,
                                                      const PowerCellOptions&);
extern template std::vector<PowerCell<3>> power_cells(const Filtration<3>&, const Box<3>&,
                                                      const PowerCellOptions&);
extern template std::vector<PowerCell<2>> power_cells_in_balls(const Filtration<2>&,
                                                               const UnionOfBalls&,
                                                               const PowerCellOptions&);
extern template std::vector<PowerCell<3>> power_cells_in_balls(const Filtration<3>&,
                                                               const UnionOfBalls&,
                                                               const PowerCellOptions&);

}  // namespace orthoball
