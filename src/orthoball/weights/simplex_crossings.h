// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "orthoball/ids.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/weights/simplex_presence.h"

namespace orthoball {

/// A position in the unit of the points' coordinates.
template <int D>
using Place = std::array<double, std::size_t{D}>;

/// Where simplices of some points meet, in doubles and up to a distance that counts as none.
///
/// Refers to the points. What is found does not depend on the order of rows.
template <int D>
class SimplexCrossings {
 public:
  /// @param near  what is so near to a simplex is on it.
  SimplexCrossings(const WeightedPoints& points, double near) : points_(points), near_(near) {}

  /// The distance that counts as none.
  [[nodiscard]] double near() const { return near_; }
  /// The position of a row.
  [[nodiscard]] Place<D> at(SiteId row) const;
  /// The squared distance of two rows.
  [[nodiscard]] double square(SiteId a, SiteId b) const;
  /// The centroid of the corners.
  [[nodiscard]] Place<D> middle(const SimplexRows& simplex) const;
  /// The corners of the face of a simplex inside which a point lies; empty where it is not on it,
  /// or at a corner.
  [[nodiscard]] SimplexRows face_around(const SimplexRows& simplex, const Place<D>& x) const;

  /// A corner of one that is inside a face of another.
  [[nodiscard]] std::optional<SiteId> corner_on_another(
      const std::vector<SimplexRows>& simplices) const;
  /// Where an edge of one meets an edge or triangle of another, inside of both: the longest such
  /// edge, for those of given simplices are longer than those that cut them.
  [[nodiscard]] std::optional<Place<D>> edge_through_another(
      const std::vector<SimplexRows>& simplices) const;
  /// Two that meet in more than a face that both have, and so exclude each other, which takes no
  /// linear program to see: those with the longest edges, for these cut most. None where no two do.
  [[nodiscard]] std::vector<SimplexRows> meeting(const std::vector<SimplexRows>& simplices) const;

 private:
  // The distance of a corner from the span of the others.
  [[nodiscard]] double height(const SimplexRows& simplex, std::size_t corner) const;
  // Where the edge from a to b passes through a face of at most D corners.
  [[nodiscard]] std::optional<Place<D>> crossing(const Place<D>& a, const Place<D>& b,
                                                 const SimplexRows& simplex) const;
  // Along some axis.
  [[nodiscard]] bool are_apart(const std::vector<Place<D>>& one,
                               const std::vector<Place<D>>& other) const;

  const WeightedPoints& points_;
  double near_;
};

extern template class SimplexCrossings<2>;  // defined in simplex_crossings.cpp
extern template class SimplexCrossings<3>;

}  // namespace orthoball
