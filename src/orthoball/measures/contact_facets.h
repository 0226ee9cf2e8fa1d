// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/bit_run.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/lens.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// The common facet of the power cells of two balls, inside the union, and what is around it. In
/// the plane the facet is a piece of a line, its circle two points.
template <int D>
struct ContactFacet {
  std::array<std::uint32_t, 2> ends{};  ///< the vertices, ascending: ball 0 and 1 below
  Lens<D> lens;
  double area = 0.0;  ///< of the facet inside the union
  double bend = 0.0;  ///< the angle between the outward normals at the circle, in [0, pi] radians
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

/// A triangle with an edge in space, and what follows it counterclockwise.
struct ApexOfEdge {
  std::uint32_t vertex = 0;  ///< the triangle's third
  bool is_in = false;        ///< the triangle is in the complex
  bool cell_is_in = false;   ///< as is the cell between it and the next one
};

/// The contact facets of the union of balls that is dual to one alpha complex, each on demand.
///
/// Lengths are those of Sites. Refers to the filtration; immutable; any number of threads may use
/// it. 40 bytes a vertex in space and a bit a simplex.
template <int D>
class ContactFacets {
 public:
  /// @param alpha2  added to the weights, in the unit of Sites.
  ContactFacets(const Filtration<D>& filtration, std::uint32_t index, double alpha2);

  /// [vertex]: the balls; radius 0 for those that are empty.
  [[nodiscard]] std::span<const Sphere<D>> spheres() const { return spheres_; }

  /// Room for the work on many edges, to be kept from call to call.
  struct Room {
    std::vector<ApexOfEdge> around;  ///< the edge at hand
    // Angles to be computed: of these vectors, to be added so often to these sums.
    RawVector<double> x, y, times, angles;  ///< [angle]
    RawVector<std::uint32_t> added_to;      ///< [angle]
    std::size_t angle_count = 0;
    std::vector<double> sums;
  };
  /// The facets of edges of the complex: out[i] is that of edges[i]. A few hundred at once are
  /// fastest. Linear in the cells around the edges.
  void measure(std::span<const SimplexId> edges, std::span<ContactFacet<D>> out, Room& room) const;

 private:
  [[nodiscard]] bool is_in(SimplexId simplex) const {
    return bit_at(is_in_complex_.data(), simplex.row());
  }
  [[nodiscard]] bool is_interior(SimplexId simplex) const {
    return filtration_->interior(simplex) <= index_;
  }
  [[nodiscard]] ContactFacet<2> in_plane(SimplexId edge) const;

  const Filtration<D>* filtration_;
  std::uint32_t index_;
  RawVector<Sphere<D>> spheres_;
  RawVector<std::uint64_t> is_in_complex_;  // bit per simplex: all that is read of most of them
};

template <>
ContactFacet<2> ContactFacets<2>::in_plane(SimplexId edge) const;
template <>
void ContactFacets<2>::measure(std::span<const SimplexId>, std::span<ContactFacet<2>>, Room&) const;
template <>
void ContactFacets<3>::measure(std::span<const SimplexId>, std::span<ContactFacet<3>>, Room&) const;

extern template class ContactFacets<2>;  // defined in contact_facets.cpp
extern template class ContactFacets<3>;

}  // namespace orthoball
