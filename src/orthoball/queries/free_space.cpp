// SPDX-License-Identifier: MIT
#include "orthoball/queries/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "orthoball/error.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/measures/compensated_sum.h"

namespace orthoball {
namespace {

// A triangle in space laid into the plane: the first corner at the origin, the second on the axis.
std::array<Sphere<2>, 3> in_plane(const std::array<Sphere<3>, 3>& corners) {
  const LensFrame frame(corners[0], corners[1]);
  const Beyond third = frame.beyond(corners[2]);
  const double off = std::sqrt(dot(third.apex, third.apex));
  const std::array<std::array<double, 2>, 3> at{
      {{0.0, 0.0}, {frame.lens().distance, 0.0}, {third.along[0], off}}};
  std::array<Sphere<2>, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = {at[i], corners[i].weight, corners[i].radius};
  return result;
}

}  // namespace

template <int D>
FreeSpace<D>::FreeSpace(const Filtration<D>& filtration, std::uint32_t index, double alpha2)
    : filtration_(&filtration), index_(index), balls_(filtration, index, alpha2) {
  if (!filtration.is_coarse()) return;
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                   "voids and pockets are told by all values of a filtration; this one is coarse");
}

template <int D>
typename FreeSpace<D>::Corners FreeSpace<D>::corners(SimplexId cell) const {
  Corners corners;
  const auto vertices = filtration_->vertices(cell);
  for (std::size_t i = 0; i <= D; ++i) corners[i] = ball(vertices[i]);
  return corners;
}

template <int D>
FacesInComplex FreeSpace<D>::faces_in_complex(SimplexId cell) const {
  FacesInComplex faces;
  const auto facets = filtration_->facets(cell);
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    if (is_in(facets[i])) faces.facets |= 1U << i;
  }
  if constexpr (D == 3) {
    for (std::uint32_t i = 0; i < 3; ++i) {  // three triangles have all edges
      const auto edges = filtration_->facets(facets[i]);
      for (std::uint32_t k = 0; k < 3; ++k) {  // edge k is without corner k of the triangle
        const std::uint32_t left_out = k < i ? k : k + 1;
        if (is_in(edges[k])) faces.edges |= 1U << (5U - kEdgeSlot[i][left_out]);
      }
    }
  }
  return faces;
}

template <int D>
FreePart FreeSpace<D>::part(std::span<const SimplexId> cells) const {
  std::map<VertexId, double> exposed;  // of each sphere, as an angle
  CompensatedSum volume, area;
  for (const SimplexId cell : cells) {
    const CellGap<D> gap = cell_gap(corners(cell), faces_in_complex(cell));
    volume.add(gap.volume);
    const auto vertices = filtration_->vertices(cell);
    for (std::size_t i = 0; i <= D; ++i) {
      if (is_in(SimplexId(vertices[i].row()))) exposed[vertices[i]] += gap.exposed[i];
    }
  }
  FreePart part;
  const InputUnits areas = units(D - 1);
  for (const auto& [vertex, angle] : exposed) {
    const double r = ball(vertex).radius;
    const double own = angle * (D == 3 ? r * r : r);
    volume.add(-own * r / D);
    area.add(own);
    part.lining.push_back(
        {filtration_->triangulation().sites().row(vertex.row()), areas({own, 0.0})});
  }
  std::sort(part.lining.begin(), part.lining.end(),
            [](const LiningBall& a, const LiningBall& b) { return a.row < b.row; });
  part.volume = units(D)(volume.value());
  part.area = areas(area.value());
  return part;
}

template <int D>
std::vector<Sphere<D>> FreeSpace<D>::lining(std::span<const SimplexId> cells) const {
  std::set<VertexId> vertices;
  for (const SimplexId cell : cells) {
    for (const VertexId vertex : filtration_->vertices(cell)) {
      if (is_in(SimplexId(vertex.row()))) vertices.insert(vertex);
    }
  }
  std::vector<Sphere<D>> balls;
  balls.reserve(vertices.size());
  for (const VertexId vertex : vertices) balls.push_back(ball(vertex));
  return balls;
}

template <int D>
std::array<double, std::size_t{D}> FreeSpace<D>::orthocentre(SimplexId cell) const {
  constexpr double kTolerance = 1e-6;  // of squares of lengths
  const Corners of_cell = corners(cell);
  auto centre = point_of_equal_power<D>(of_cell);
  double square = 0.0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double way = centre[axis] - of_cell[0].x[axis];
    square += way * way;
  }
  const double weight = of_cell[0].weight;
  const double rho2 = balls_.from_input(filtration_->alpha2(filtration_->enters(cell)), 2);
  const double error = std::abs(square - weight - rho2);
  if (!(error <= kTolerance * (square + std::abs(weight)))) {
    centre.fill(std::numeric_limits<double>::quiet_NaN());
  }
  return centre;
}

template <int D>
std::vector<InscribedBall<D>> FreeSpace<D>::empty_balls(std::span<const SimplexId> cells) const {
  std::vector<InscribedBall<D>> candidates;
  for (const SimplexId cell : cells) {
    const auto of_cell = corners(cell);
    candidates.push_back(ball_around<D>(orthocentre(cell), of_cell));
  }
  const std::vector<Sphere<D>> around = lining(cells);
  const auto is_larger = [](const InscribedBall<D>& a, const InscribedBall<D>& b) {
    return a.radius > b.radius;
  };
  const auto is_held_by = [](const InscribedBall<D>& small, const InscribedBall<D>& large) {
    double square = 0.0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double way = small.centre[axis] - large.centre[axis];
      square += way * way;
    }
    return square <= large.radius * large.radius;
  };
  std::stable_sort(candidates.begin(), candidates.end(), is_larger);
  std::vector<InscribedBall<D>> chosen;
  for (const InscribedBall<D>& candidate : candidates) {
    if (!(candidate.radius > 0.0)) continue;
    const auto holds = [&](const InscribedBall<D>& large) { return is_held_by(candidate, large); };
    if (std::any_of(chosen.begin(), chosen.end(), holds)) continue;
    const InscribedBall<D> empty = ball_around<D>(candidate.centre, around);
    if (empty.radius > 0.0) chosen.push_back(empty);
  }
  std::stable_sort(chosen.begin(), chosen.end(), is_larger);
  const InputUnits lengths = units(1);
  for (InscribedBall<D>& one : chosen) {
    one.radius = lengths({one.radius, 0.0});
    for (double& x : one.centre) x = lengths({x, 0.0});
  }
  return chosen;
}

template <>
double FreeSpace<2>::part_of_facet(SimplexId facet) const {
  const auto ends = filtration_->vertices(facet);
  double length = lens(ball(ends[0]), ball(ends[1])).distance;
  for (const VertexId end : ends) {
    if (is_in(SimplexId(end.row()))) length -= ball(end).radius;
  }
  return units(1)({length, 0.0});
}

template <>
double FreeSpace<3>::part_of_facet(SimplexId facet) const {
  const auto vertices = filtration_->vertices(facet);
  const auto edges = filtration_->facets(facet);
  FacesInComplex faces;
  std::array<Sphere<3>, 3> corners;
  for (std::uint32_t i = 0; i < 3; ++i) {
    corners[i] = ball(vertices[i]);
    if (is_in(edges[i])) faces.facets |= 1U << i;
  }
  const CellGap<2> gap = cell_gap(in_plane(corners), faces);
  double area = gap.volume;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_in(SimplexId(vertices[i].row()))) continue;
    area -= gap.exposed[i] * corners[i].radius * corners[i].radius / 2;
  }
  return units(2)({area, 0.0});
}

template class FreeSpace<2>;
template class FreeSpace<3>;

}  // namespace orthoball
