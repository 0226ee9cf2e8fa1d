// SPDX-License-Identifier: MIT
#include "orthoball/measures/ball_part.h"

#include <algorithm>
#include <cmath>

#include "orthoball/measures/angle.h"

namespace orthoball {
// In the plane, from the foot of the centre, the edge is on a line at `off`; a right triangle with
// legs `off` and u has the solid angle atan2(u, off) - atan2(u height, off l), l the distance of
// the end from the centre. The ball takes the part of it within the disk, whose sectors of angle
// phi have (1 - height / radius) phi.
ConePart cone_over_edge(const FromCentre& from, const FromCentre& to, const FromCentre& normal,
                        double height, double radius) {
  const FromCentre along = difference(to, from);
  const double length = std::sqrt(inner(along, along));
  if (!(length > 0.0)) return {};
  const FromCentre unit{along[0] / length, along[1] / length, along[2] / length};
  const double signed_off = inner(cross_product(from, unit), normal);
  const double off = std::abs(signed_off), sign = signed_off < 0.0 ? -1.0 : 1.0;
  const double disk2 = std::max(0.0, (radius - height) * (radius + height));
  const double kept = std::min(1.0, height / radius);
  ConePart part;
  const auto add_outside = [&](double u0, double u1) {
    const auto tilt = [&](double u) {
      const double l = std::sqrt(height * height + off * off + u * u);
      return std::copysign(angle_from_x_axis(off * l, std::abs(u) * height), u);
    };
    const double turn = angle_from_x_axis(off * off + u0 * u1, off * (u1 - u0));
    part.disk += disk2 * turn / 2;
    part.solid_angle += kept * turn - (tilt(u1) - tilt(u0));
  };
  const double begin = inner(from, unit), end = begin + length;
  if (off * off >= disk2) {
    add_outside(begin, end);
  } else {
    const double half = std::sqrt(disk2 - off * off);
    const double first = std::clamp(-half, begin, end), last = std::clamp(half, begin, end);
    if (begin < first) add_outside(begin, first);
    part.disk += off * (last - first) / 2;
    if (last < end) add_outside(last, end);
  }
  return {sign * part.disk, sign * part.solid_angle};
}

CutTetrahedron::CutTetrahedron(const std::array<FromCentre, 4>& corners,
                               const std::array<std::uint32_t, 4>& numbers)
    : corners_(corners.begin(), corners.end()), faces_(4) {
  // The corners of each face, counterclockwise seen from outside.
  constexpr std::array<std::array<std::uint32_t, 3>, 4> kOutward{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    Boundary& face = faces_[i];
    const auto& loop = kOutward[i];
    for (std::size_t k = 0; k < 3; ++k) face.edges.emplace_back(loop[k], loop[(k + 1) % 3]);
    // From the lowest number on, and turned round once if need be.
    std::array<std::uint32_t, 3> sorted = loop;
    const auto by_number = [&](std::uint32_t a, std::uint32_t b) {
      return numbers[a] < numbers[b];
    };
    std::rotate(sorted.begin(), std::min_element(sorted.begin(), sorted.end(), by_number),
                sorted.end());
    const bool is_turned = by_number(sorted[2], sorted[1]);
    if (is_turned) std::swap(sorted[1], sorted[2]);
    FromCentre normal = cross_product(difference(corners[sorted[1]], corners[sorted[0]]),
                                      difference(corners[sorted[2]], corners[sorted[0]]));
    const double norm = std::sqrt(inner(normal, normal));
    if (!(norm > 0.0)) continue;  // no area
    for (double& x : normal) x /= is_turned ? -norm : norm;
    face.normal = normal;
    face.offset = inner(normal, corners[sorted[0]]);
  }
}

std::uint32_t CutTetrahedron::crossing(std::uint32_t inside, std::uint32_t outside) {
  for (const auto& [edge, corner] : crossings_) {
    if (edge.first == inside && edge.second == outside) return corner;
  }
  const double share = beyond_[inside] / (beyond_[inside] - beyond_[outside]);
  const FromCentre a = corners_[inside], b = corners_[outside];
  FromCentre corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = a[i] + share * (b[i] - a[i]);
  const auto number = static_cast<std::uint32_t>(corners_.size());
  corners_.push_back(corner);
  crossings_.push_back({{inside, outside}, number});
  return number;
}

void CutTetrahedron::cut(const FromCentre& normal, double offset) {
  crossings_.clear();
  beyond_.resize(corners_.size());
  bool is_any_outside = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    beyond_[i] = inner(corners_[i], normal) - offset;
    is_any_outside |= beyond_[i] > 0.0;
  }
  if (!is_any_outside) return;
  const auto is_outside = [&](std::uint32_t corner) { return beyond_[corner] > 0.0; };
  Boundary cap{normal, offset, {}};
  auto& [leaves, enters] = room_;
  for (Boundary& face : faces_) {
    leaves.clear();
    enters.clear();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < face.edges.size(); ++i) {
      const auto [from, to] = face.edges[i];
      if (is_outside(from) && is_outside(to)) continue;
      std::uint32_t begin = from, end = to;
      if (is_outside(to)) leaves.push_back(end = crossing(from, to));
      if (is_outside(from)) enters.push_back(begin = crossing(to, from));
      face.edges[kept++] = {begin, end};
    }
    face.edges.resize(kept);
    // As many leave as enter, and all are on one line: any pairs have the same sum.
    for (std::size_t i = 0; i < std::min(leaves.size(), enters.size()); ++i) {
      face.edges.emplace_back(leaves[i], enters[i]);
      cap.edges.emplace_back(enters[i], leaves[i]);
    }
  }
  if (!cap.edges.empty()) faces_.push_back(std::move(cap));
}

CutTetrahedron::Face CutTetrahedron::face(std::size_t i, double radius) const {
  const Boundary& boundary = faces_[i];
  Face face;
  if (boundary.normal == FromCentre{}) return face;
  face.sign = boundary.offset < 0.0 ? -1.0 : 1.0;
  face.height = std::abs(boundary.offset);
  for (const auto& [from, to] : boundary.edges) {
    const ConePart part =
        cone_over_edge(corners_[from], corners_[to], boundary.normal, face.height, radius);
    face.part.disk += part.disk;
    face.part.solid_angle += part.solid_angle;
  }
  return face;
}

}  // namespace orthoball
