// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orthoball {

/// The points x with normal . x <= offset.
template <int D>
struct HalfSpace {
  std::array<double, std::size_t{D}> normal{};  ///< of any length but 0
  double offset = 0.0;
};

/// A convex polytope that is cut by one half-space after the other: a polyhedron, in the plane a
/// polygon, perhaps empty.
///
/// Its surface is closed whatever rounding does: every side of a facet is that of one other, in the
/// opposite direction. Corners are rounded, by a few 2^-53 of their distance from the origin and of
/// how far the planes that meet there move them together. Which facet a cut leaves is decided in
/// doubles; what may be wrong is as small as that error.
template <int D>
class ConvexPolytope {
 public:
  using Point = std::array<double, std::size_t{D}>;  ///< [axis]
  /// A facet, with a number that whoever cut it gave to it.
  struct Facet {
    std::uint32_t label;
    std::uint32_t begin;  ///< of its corners in loops()
    std::uint32_t end;
  };

  ConvexPolytope() = default;  // empty
  /// The box between two corners. Its facets are labelled `first_label` + 2 * axis + (0: the lower,
  /// 1: the upper).
  ConvexPolytope(const Point& lower, const Point& upper, std::uint32_t first_label);
  /// A polytope with its corners on the unit sphere around the origin and no point of its surface
  /// further from that than `tolerance`, all facets labelled `label`: a polygon with equal sides;
  /// in space an icosahedron whose triangles are divided in four again and again.
  /// @param tolerance  from 0 exclusive to 1: in space about 7 / tolerance triangles.
  static ConvexPolytope in_unit_sphere(double tolerance, std::uint32_t label);

  /// Away from the origin by a factor.
  void scale(double factor);

  /// Takes away what is not in the half-space; the facet that is left there has this label.
  void cut(const HalfSpace<D>& half_space, std::uint32_t label);
  /// Joins corners that only rounding holds apart, by taking away sides much shorter than corners
  /// are far from the origin. What then has no inside is empty. Corners in the plane are in order.
  void join_corners();

  [[nodiscard]] bool is_empty() const { return facets_.empty(); }
  [[nodiscard]] std::span<const Point> corners() const { return corners_; }
  /// In the plane counterclockwise: facet i is from corner i to the next.
  [[nodiscard]] std::span<const Facet> facets() const { return facets_; }
  /// Corners of facets, by number; of a polygon counterclockwise as seen from outside, of a side
  /// in the plane first and last.
  [[nodiscard]] std::span<const std::uint32_t> loops() const { return loops_; }

  /// Length^D, of what the facets enclose.
  [[nodiscard]] double volume() const;
  /// Length^(D-1).
  [[nodiscard]] double area(const Facet& facet) const;

 private:
  // A corner on the side from a corner that stays to one that goes, and what follows it in the new
  // facet.
  struct CutCorner {
    std::uint32_t stays, goes, next;
  };
  [[nodiscard]] bool goes(std::uint32_t corner) const { return excess_[corner] > 0.0; }
  void clear();
  void cut_facets(std::uint32_t label);
  void cut_polygon(const Facet& facet);
  void close(std::uint32_t label);
  [[nodiscard]] std::uint32_t cut_corner(std::uint32_t stays, std::uint32_t goes);
  void add_facet(std::uint32_t label);
  void take_new_facets();

  std::vector<Point> corners_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> loops_;
  // Those of one cut, kept for their room.
  std::vector<double> excess_;  // [corner]: how far beyond the plane, times the normal's length
  std::vector<CutCorner> cut_corners_;  // numbered after the corners
  std::vector<Point> new_corners_;
  std::vector<Facet> new_facets_;
  std::vector<std::uint32_t> new_loops_;
  std::vector<std::uint32_t> numbers_;  // [corner]
};

// Each dimension has its own of these, defined in convex_polytope.cpp.
template <>
void ConvexPolytope<2>::cut_facets(std::uint32_t label);
template <>
void ConvexPolytope<3>::cut_facets(std::uint32_t label);
template <>
double ConvexPolytope<2>::volume() const;
template <>
double ConvexPolytope<3>::volume() const;
template <>
double ConvexPolytope<2>::area(const Facet& facet) const;
template <>
double ConvexPolytope<3>::area(const Facet& facet) const;
template <>
ConvexPolytope<2>::ConvexPolytope(const Point& lower, const Point& upper, std::uint32_t label);
template <>
ConvexPolytope<3>::ConvexPolytope(const Point& lower, const Point& upper, std::uint32_t label);
template <>
ConvexPolytope<2> ConvexPolytope<2>::in_unit_sphere(double tolerance, std::uint32_t label);
template <>
ConvexPolytope<3> ConvexPolytope<3>::in_unit_sphere(double tolerance, std::uint32_t label);

extern template class ConvexPolytope<2>;  // defined in convex_polytope.cpp
extern template class ConvexPolytope<3>;

}  // namespace orthoball
