// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/lens.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// The common facet of the power cells of two balls, inside the union, and what is around it. In
/// the plane the facet is a piece of a line, its circle two points.
template <int D>
struct ContactFacet {
  Lens<D> lens;
  double area = 0.0;  ///< of the facet inside the union
  /// In space the angle of the arcs of the circle that are on the surface of the union, in [0, 2
  /// pi] radians; in the plane the number of the two points that are.
  double exposed = 0.0;
  /// [ball]: how much of all directions at each centre is not exposed because of this edge, in
  /// steradians or radians. The exposed part of a sphere is what the edges at a centre leave of 4
  /// pi or 2 pi.
  std::array<double, 2> taken{};
  /// Over the exposed arcs, the integral of the point seen from the circle's centre by the angle;
  /// in the plane the sum of the points seen from their middle.
  std::array<double, std::size_t{D}> moment{};
};

/// A triangle with an edge, and what follows it counterclockwise.
struct ApexOfEdge {
  std::uint32_t vertex = 0;  ///< the triangle's third
  bool is_in = false;        ///< the triangle is in the complex
  bool cell_is_in = false;   ///< as is the cell between it and the next one
};

/// The contact facets of the union of balls that is dual to one alpha complex, each on demand.
///
/// Lengths are those of Sites. Refers to the filtration; immutable; any number of threads may use
/// it. 40 bytes a vertex in space.
template <int D>
class ContactFacets {
 public:
  /// @param alpha2  added to the weights, in the unit of Sites.
  ContactFacets(const Filtration<D>& filtration, std::uint32_t index, double alpha2);

  /// [vertex]: the balls; radius 0 for those that are empty.
  [[nodiscard]] std::span<const Sphere<D>> spheres() const { return spheres_; }

  /// Room for what is around an edge, to be kept from call to call.
  using Room = std::vector<ApexOfEdge>;
  /// The facet of an edge of the complex, whose ends are ball 0 and 1 in ascending order.
  /// Linear in the cells around the edge.
  [[nodiscard]] ContactFacet<D> facet(SimplexId edge, Room& room) const;

 private:
  [[nodiscard]] bool is_in(SimplexId simplex) const {
    return filtration_->enters(simplex) <= index_;
  }

  const Filtration<D>* filtration_;
  std::uint32_t index_;
  RawVector<Sphere<D>> spheres_;
};

template <>
ContactFacet<2> ContactFacets<2>::facet(SimplexId edge, Room& room) const;
template <>
ContactFacet<3> ContactFacets<3>::facet(SimplexId edge, Room& room) const;

extern template class ContactFacets<2>;  // defined in contact_facets.cpp
extern template class ContactFacets<3>;

}  // namespace orthoball
