// SPDX-License-Identifier: MIT
//
// The pieces of contact_facets.cpp, seen from the other side: from a cell that is not in the
// complex. A facet in the complex has a simplex over it, to the point where its spheres meet;
// around an edge in the complex what these leave of the cell's dihedral angle is a wedge of a
// double cone.
#include "orthoball/measures/cell_gap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "orthoball/filtration/edge_ring.h"

namespace orthoball {
double cell_volume(const std::array<Sphere<2>, 3>& c) {
  const double ax = c[1].x[0] - c[0].x[0], ay = c[1].x[1] - c[0].x[1];
  const double bx = c[2].x[0] - c[0].x[0], by = c[2].x[1] - c[0].x[1];
  return std::abs(ax * by - ay * bx) / 2;
}

double cell_volume(const std::array<Sphere<3>, 4>& c) {
  std::array<std::array<double, 3>, 3> d{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) d[i][axis] = c[i + 1].x[axis] - c[0].x[axis];
  }
  return std::abs(d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                  d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                  d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
         6;
}

CellGap<2> cell_gap(const std::array<Sphere<2>, 3>& corners, FacesInComplex faces) {
  CellGap<2> gap;
  gap.volume = cell_volume(corners);
  for (std::size_t opposite = 0; opposite < 3; ++opposite) {
    const std::size_t i = (opposite + 1) % 3, j = (opposite + 2) % 3;
    gap.exposed[opposite] += corner_angle(corners[opposite], corners[i], corners[j]);
    if ((faces.facets >> opposite & 1U) == 0) continue;
    const Lens<2> pair = lens(corners[i], corners[j]);
    gap.volume -= pair.distance * pair.radius / 2;
    gap.exposed[i] -= angle(pair.opening(0));
    gap.exposed[j] -= angle(pair.opening(1));
  }
  return gap;
}

CellGap<3> cell_gap(const std::array<Sphere<3>, 4>& corners, FacesInComplex faces) {
  CellGap<3> gap;
  gap.volume = cell_volume(corners);
  for (std::uint32_t slot = 0; slot < 6; ++slot) {
    const std::array<std::size_t, 2> ends{kEdgeCorners[slot][0], kEdgeCorners[slot][1]};
    const std::array<std::size_t, 2> others{kEdgeCorners[5 - slot][0], kEdgeCorners[5 - slot][1]};
    const LensFrame frame(corners[ends[0]], corners[ends[1]]);
    const std::array<Beyond, 2> beyond{frame.beyond(corners[others[0]]),
                                       frame.beyond(corners[others[1]])};
    const HalfPlane turn{dot(beyond[0].apex, beyond[1].apex),
                         std::abs(cross(beyond[0].apex, beyond[1].apex))};
    const double dihedral = angle(turn);
    for (const std::size_t end : ends) gap.exposed[end] += dihedral;
    if ((faces.edges >> slot & 1U) == 0) continue;

    double wedge = dihedral;  // less the simplices over facets
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t third = others[k];
      if ((faces.facets >> others[1 - k] & 1U) == 0) continue;
      std::array<std::size_t, 3> order{ends[0], ends[1], third};
      std::sort(order.begin(), order.end());
      const Chord chord = frame.chord(
          beyond[k], meeting_height(corners[order[0]], corners[order[1]], corners[order[2]]));
      wedge -= angle(chord.half_angle());
      // Each of the facet's edges tells a third of the simplex over it, and at each end the edge
      // with the smaller circle tells the solid angle.
      gap.volume -= frame.lens().distance * chord.apex_distance * chord.half / 18;
      for (std::size_t end = 0; end < 2; ++end) {
        const double own = rough_circle2(corners[ends[end]], corners[ends[1 - end]]);
        const double other = rough_circle2(corners[ends[end]], corners[third]);
        if (own < other || (own == other && ends[1 - end] < third)) {
          gap.exposed[ends[end]] -=
              2 * angle(frame.half_solid_angle(chord, end, corners[ends[end]].radius));
        }
      }
    }
    gap.volume -= frame.lens().distance * frame.lens().radius2 * wedge / 6;
    for (std::size_t end = 0; end < 2; ++end) {
      const double r = corners[ends[end]].radius;
      if (r > 0.0) gap.exposed[ends[end]] -= (r - frame.lens().height[end]) / r * wedge;
    }
  }
  // Three dihedral angles less pi are a solid one.
  for (double& exposed : gap.exposed) exposed -= std::numbers::pi;
  return gap;
}

double facet_size(const std::array<Sphere<2>, 3>& corners, std::size_t opposite) {
  return lens(corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]).distance;
}

double facet_size(const std::array<Sphere<3>, 4>& corners, std::size_t opposite) {
  const std::size_t i = (opposite + 1) % 4, j = (opposite + 2) % 4, k = (opposite + 3) % 4;
  const LensFrame frame(corners[i], corners[j]);
  const InLens apex = frame.beyond(corners[k]).apex;
  return frame.lens().distance * std::sqrt(dot(apex, apex)) / 2;
}

}  // namespace orthoball
