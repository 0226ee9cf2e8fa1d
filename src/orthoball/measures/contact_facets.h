// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/bit_run.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/lens.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/parallel.h"
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
  /// Of the pieces of the union around the edge: the wedges at exposed arcs, and a third of each
  /// tetrahedron over an exposed triangle; in the plane the triangles to the exposed points.
  double pieces = 0.0;
  /// Over the exposed arcs, the integral of the point seen from the circle's centre by the angle;
  /// in the plane the sum of the points seen from their middle.
  std::array<double, std::size_t{D}> moment{};
};

/// A triangle with an edge in space, and what follows it counterclockwise.
struct ApexOfEdge {
  std::uint32_t vertex = 0;  ///< the triangle's third
  bool is_in = false;        ///< the triangle is in the complex
  bool cell_is_in = false;   ///< as is the cell between it and the next one
  std::uint32_t facet = 0;   ///< the triangle, counted from the first; where a side is exposed
};

/// The contact facets of the union of balls that is dual to one alpha complex, each on demand.
///
/// Lengths are those of ScaledBalls. Refers to the filtration; immutable; any number of threads may
/// use it. 40 bytes a vertex, 8 a triangle in space and a bit a simplex.
template <int D>
class ContactFacets {
 public:
  /// @param alpha2  added to the weights, length^2 in input units.
  /// @throws InputError as ScaledBalls does.
  ContactFacets(const Filtration<D>& filtration, std::uint32_t index, double alpha2,
                Threads threads = Threads(1));

  /// From the units of all below. @param power  1 for lengths, 2 for areas, 3 for volumes.
  [[nodiscard]] InputUnits units(int power) const { return balls_.units(power); }
  /// [vertex]: the balls; radius 0 for those that are empty.
  [[nodiscard]] std::span<const Sphere<D>> spheres() const { return balls_.spheres(); }

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
  void find_heights(Threads threads);
  [[nodiscard]] ContactFacet<2> in_plane(SimplexId edge) const;

  const Filtration<D>* filtration_;
  std::uint32_t index_;
  ScaledBalls<D> balls_;
  /// In space, [triangle]: meeting_height() of those on the boundary, the same for their edges.
  RawVector<double> heights_;
  RawVector<std::uint64_t> is_in_complex_;  // bit per simplex: all that is read of most of them
};

/// Calls `visit(facet)` for the facets of edges of the complex in their order, from the caller's
/// thread; they are measured side by side.
template <int D, class Visit>
void for_each_facet(const ContactFacets<D>& facets, std::span<const SimplexId> edges,
                    Threads threads, const Visit& visit) {
  constexpr std::size_t kPart = std::size_t{1} << 10U, kParts = 32, kAtOnce = 128;
  std::vector<ContactFacet<D>> measured(std::min(edges.size(), kPart * kParts));
  for (std::size_t first = 0; first < edges.size(); first += measured.size()) {
    const std::size_t size = std::min(measured.size(), edges.size() - first);
    const std::size_t parts = size / kPart + 1;
    parallel_parts(threads, size, parts, [&](std::size_t, std::size_t begin, std::size_t end) {
      typename ContactFacets<D>::Room room;
      for (std::size_t i = begin; i < end; i += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, end - i);
        facets.measure(edges.subspan(first + i, count), std::span(measured).subspan(i, count),
                       room);
      }
    });
    for (std::size_t i = 0; i < size; ++i) visit(measured[i]);
  }
}

// Each dimension has its own of these, defined in contact_facets.cpp.
template <>
void ContactFacets<2>::find_heights(Threads threads);
template <>
void ContactFacets<3>::find_heights(Threads threads);
template <>
ContactFacet<2> ContactFacets<2>::in_plane(SimplexId edge) const;
template <>
void ContactFacets<2>::measure(std::span<const SimplexId>, std::span<ContactFacet<2>>, Room&) const;
template <>
void ContactFacets<3>::measure(std::span<const SimplexId>, std::span<ContactFacet<3>>, Room&) const;

extern template class ContactFacets<2>;  // defined in contact_facets.cpp
extern template class ContactFacets<3>;

}  // namespace orthoball
