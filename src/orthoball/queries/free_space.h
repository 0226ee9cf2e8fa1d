// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/measures/cell_gap.h"
#include "orthoball/measures/input_units.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/inscribed_ball.h"

namespace orthoball {

/// A ball at a void or pocket, and how much of its surface that has. In the plane its arc.
struct LiningBall {
  SiteId row;
  double area = 0.0;  ///< length^(D-1)
};

/// What a union of balls leaves free of some cells, in input units.
struct FreePart {
  double volume = 0.0;  ///< length^D
  double area = 0.0;    ///< of the balls, there; length^(D-1)
  /// The corners of the cells that are in the complex, by row. Where pieces of the union reach out
  /// of the cells, single areas may be below 0, and a small volume, too.
  std::vector<LiningBall> lining;
};

/// Measures what the union of balls that is dual to one alpha complex leaves free, in sets of cells
/// outside the complex.
///
/// Volume and area are sums over the cells, as those of UnionOfBalls are over the complex: exact
/// where no piece of the union reaches from cells of the set into others, as in voids.
/// Refers to the filtration. Immutable; any number of threads may use it.
template <int D>
class FreeSpace {
 public:
  /// [corner]: the balls of a cell, in the order of its vertices.
  using Corners = std::array<Sphere<D>, std::size_t{D} + 1>;

  /// @param alpha2  length^2 in input units.
  FreeSpace(const Filtration<D>& filtration, std::uint32_t index, double alpha2);

  /// Of cells outside the complex. Error: a few 2^-53 of their volume and of the balls' areas.
  [[nodiscard]] FreePart part(std::span<const SimplexId> cells) const;
  /// Of a facet of such cells that is outside the complex: its area less that in the balls, by the
  /// same sum; length^(D-1).
  [[nodiscard]] double part_of_facet(SimplexId facet) const;

  /// Balls that show the space in such cells, in input units: around the points of equal power to
  /// the corners of every cell, as large as the balls at all corners allow. The largest first;
  /// those whose centre a larger one holds are left out. Display only. Quadratic at worst.
  [[nodiscard]] std::vector<InscribedBall<D>> empty_balls(std::span<const SimplexId> cells) const;

  /// In the units of ScaledBalls: the orthocentre of a cell; not finite where the cell is so flat
  /// that rounding decides where it is.
  [[nodiscard]] std::array<double, std::size_t{D}> orthocentre(SimplexId cell) const;
  /// In the units of ScaledBalls: the balls at the corners of a cell, by vertex.
  [[nodiscard]] Corners corners(SimplexId cell) const;
  /// In the units of ScaledBalls: those at the corners of cells that are in the complex, by vertex.
  [[nodiscard]] std::vector<Sphere<D>> lining(std::span<const SimplexId> cells) const;
  [[nodiscard]] const Sphere<D>& ball(VertexId vertex) const {
    return balls_.spheres()[vertex.row()];
  }
  /// From these units. @param power  1 for lengths, 2 for areas, 3 for volumes.
  [[nodiscard]] InputUnits units(int power) const { return balls_.units(power); }
  /// Whether a simplex is in the complex.
  [[nodiscard]] bool is_in(SimplexId simplex) const {
    return filtration_->enters(simplex) <= index_;
  }

 private:
  [[nodiscard]] FacesInComplex faces_in_complex(SimplexId cell) const;

  const Filtration<D>* filtration_;
  std::uint32_t index_;
  ScaledBalls<D> balls_;
};

/// The order of voids and pockets: the largest volume first, then the lowest row around; a volume
/// that is no number last.
template <class Region>
[[nodiscard]] bool is_listed_before(const Region& a, const Region& b) {
  const auto volume = [](const Region& one) {
    return std::isnan(one.volume) ? -std::numeric_limits<double>::infinity() : one.volume;
  };
  const auto row = [](const Region& one) {
    return one.lining.empty() ? SiteId() : one.lining[0].row;
  };
  return volume(a) != volume(b) ? volume(a) > volume(b) : row(a) < row(b);
}

// Each dimension has its own, defined in free_space.cpp.
template <>
double FreeSpace<2>::part_of_facet(SimplexId facet) const;
template <>
double FreeSpace<3>::part_of_facet(SimplexId facet) const;

extern template class FreeSpace<2>;  // defined in free_space.cpp
extern template class FreeSpace<3>;

}  // namespace orthoball
