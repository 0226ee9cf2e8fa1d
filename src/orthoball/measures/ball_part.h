// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/measures/lens.h"

namespace orthoball {

/// A point or vector in space, seen from the centre of the ball at hand. Any unit of length.
using FromCentre = std::array<double, 3>;

/// What a ball has in common with the cone from its centre over a piece of a plane.
struct ConePart {
  double disk = 0.0;         ///< area of the piece inside the ball, >= 0; length^2
  double solid_angle = 0.0;  ///< of the piece outside the ball; steradians

  /// Of the cone inside the ball. @param height  of the centre over the plane.
  [[nodiscard]] double volume(double height, double radius) const {
    return (height * disk + radius * radius * radius * solid_angle) / 3;
  }
};

/// The share of one directed edge in the cone over a polygon whose boundary it belongs to: these
/// add up for the edges of a boundary, counterclockwise seen along -normal. Exact but for rounding.
/// @param normal  unit normal of the plane.
/// @param height  of the centre over the plane, >= 0.
[[nodiscard]] ConePart cone_over_edge(const FromCentre& from, const FromCentre& to,
                                      const FromCentre& normal, double height, double radius);

/// A tetrahedron of which half-spaces take their parts, for what a ball around the origin has of
/// the rest.
///
/// Which side of a plane a corner is on is asked once, so that the faces always close, and rounding
/// moves corners only: planes that coincide with faces or with each other are no special case. A
/// tetrahedron that rounding turns inside out is negative.
class CutTetrahedron {
 public:
  /// @param corners  positively oriented.
  /// @param numbers  of the corners, all different: two tetrahedra with a common face see it alike.
  CutTetrahedron(const std::array<FromCentre, 4>& corners,
                 const std::array<std::uint32_t, 4>& numbers);

  /// Leaves what has inner product <= offset with the unit vector.
  void cut(const FromCentre& normal, double offset);

  /// A face of the rest, and what the ball has of the cone over it, of which `sign` tells whether
  /// it is added or taken away.
  struct Face {
    double sign = 0.0;
    double height = 0.0;  ///< of the centre over its plane, >= 0
    ConePart part;
  };
  /// The face opposite corner i for i < 4, then those of the cuts.
  [[nodiscard]] std::size_t face_count() const { return faces_.size(); }
  [[nodiscard]] Face face(std::size_t i, double radius) const;

 private:
  struct Boundary {
    FromCentre normal{};  // outward, unit; null for a face without area
    double offset = 0.0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  // directed, of corners
  };
  [[nodiscard]] std::uint32_t crossing(std::uint32_t inside, std::uint32_t outside);

  std::vector<FromCentre> corners_;
  std::vector<Boundary> faces_;
  // Room for one cut.
  std::vector<double> beyond_;  // [corner]: signed distance
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> crossings_;
  std::array<std::vector<std::uint32_t>, 2> room_;  // where a face's edges leave and enter
};

}  // namespace orthoball
