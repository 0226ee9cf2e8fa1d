// SPDX-License-Identifier: MIT
//
// Sums over the edges of the complex (contact_facets.h). By the divergence theorem the part of a
// ball is 1/D of radius times exposed area and of height times area of its contact facets; its
// exposed area is what the edges leave of all directions. Edges are measured side by side and added
// one after the other, so that sums do not depend on threads.
//
// Edelsbrunner. The union of balls and its dual shape. Discrete & Computational Geometry 13 (1995).
// Edelsbrunner, Koehl. The weighted-volume derivative of a space-filling diagram. PNAS 100 (2003);
// here derivatives follow from the facets, their arcs and the ends of these.
#include "orthoball/measures/union_of_balls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/contact_facets.h"
#include "orthoball/measures/input_units.h"

namespace orthoball {
namespace {

template <int D>
class Union {
 public:
  Union(const Filtration<D>& filtration, std::uint32_t index, double alpha2,
        const UnionOptions& options)
      : filtration_(filtration),
        index_(index),
        options_(options),
        facets_(filtration, index, alpha2, options.threads) {
    result_.index = index;
    result_.alpha2 = alpha2;
  }

  UnionOfBalls measured() {
    const std::size_t vertices = filtration_.count(0);
    taken_.resize(vertices, 0.0);
    beside_.resize(vertices, 0.0);
    if (options_.derivatives) {
      turned_.resize(vertices, 0.0);
      pushed_.resize(D * vertices, 0.0);
      dragged_.resize(D * vertices, 0.0);
    }
    add_edges();
    add_vertices();
    count();
    if (options_.contacts) sort_contacts();
    return std::move(result_);
  }

 private:
  static constexpr double kAllDirections = (D == 3 ? 4 : 2) * std::numbers::pi;

  [[nodiscard]] InputUnits units(int power) const { return facets_.units(power); }
  static double in(const InputUnits& units, double value) { return units({value, 0.0}); }
  [[nodiscard]] bool is_in(SimplexId simplex) const {
    return filtration_.enters(simplex) <= index_;
  }

  void add_edges();
  void add(const ContactFacet<D>& facet);
  void add_to_derivatives(const ContactFacet<D>& facet);
  void add_vertices();
  void count();
  void sort_contacts();

  const Filtration<D>& filtration_;
  std::uint32_t index_;
  UnionOptions options_;
  ContactFacets<D> facets_;
  std::vector<double> taken_;    // [vertex]: of all directions
  std::vector<double> beside_;   // [vertex]: heights times areas of facets
  std::vector<double> turned_;   // [vertex]: what arcs take from the derivative by the radius
  std::vector<double> pushed_;   // [D * vertex + axis]: integral of the normal over the surface
  std::vector<double> dragged_;  // [D * vertex + axis]: what arcs take from that by the centre
  CompensatedSum bends_;         // of the arcs, for the mean curvature
  UnionOfBalls result_;
};

template <int D>
void Union<D>::add_edges() {
  const std::uint32_t first = filtration_.table().first(1);
  RawVector<SimplexId> edges;
  for (std::uint32_t edge = 0; edge < filtration_.count(1); ++edge) {
    if (is_in(SimplexId(first + edge))) edges.push_back(SimplexId(first + edge));
  }
  for_each_facet<D>(facets_, edges, options_.threads,
                    [&](const ContactFacet<D>& facet) { add(facet); });
}

template <int D>
void Union<D>::add(const ContactFacet<D>& facet) {
  const auto& ends = facet.ends;
  for (std::size_t end = 0; end < 2; ++end) {
    taken_[ends[end]] += facet.taken[end];
    beside_[ends[end]] += facet.lens.height[end] * facet.area;
  }
  if constexpr (D == 3) {
    bends_.add(facet.bend * facet.lens.radius * facet.exposed / 2);
  }
  if (options_.contacts) {
    const Sites<D>& sites = filtration_.triangulation().sites();
    Contact contact{{sites.row(ends[0]), sites.row(ends[1])}, facet.area, facet.exposed};
    if (D == 3) contact.exposed_length *= facet.lens.radius;
    if (contact.rows[1] < contact.rows[0]) std::swap(contact.rows[0], contact.rows[1]);
    result_.contacts.push_back(contact);
  }
  if (options_.derivatives) add_to_derivatives(facet);
}

// A moving ball pushes its surface outwards; by the divergence theorem the integral of the normal
// over it is that over the facets, turned round. Where two surfaces meet, at angle phi between
// their normals, area vanishes at tan(phi / 2) times the speeds of both.
template <int D>
void Union<D>::add_to_derivatives(const ContactFacet<D>& facet) {
  const auto& ends = facet.ends;
  const Lens<D>& lens = facet.lens;
  const double r0 = facets_.spheres()[ends[0]].radius, r1 = facets_.spheres()[ends[1]].radius;
  const double d = lens.distance;
  // tan(phi / 2) times the circle's radius: finite where balls touch.
  double tangent = d > 0.0 ? (d - (r0 - r1)) * (d + (r0 - r1)) / (2 * d) : 0.0;
  if (D == 2) tangent = lens.radius > 0.0 ? tangent / lens.radius : 0.0;
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t vertex = ends[end];
    const double r = end == 0 ? r0 : r1;
    const double outwards = end == 0 ? 1.0 : -1.0;
    turned_[vertex] += tangent * facet.exposed;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double normal = outwards * lens.axis[axis];
      pushed_[D * vertex + axis] -= facet.area * normal;
      if (r > 0.0) {
        dragged_[D * vertex + axis] +=
            tangent / r * (lens.height[end] * facet.exposed * normal + facet.moment[axis]);
      }
    }
  }
}

template <int D>
void Union<D>::add_vertices() {
  const RegularTriangulation<D>& triangulation = filtration_.triangulation();
  const std::size_t rows = triangulation.site_count();
  const InputUnits volumes = units(D), areas = units(D - 1), lower = units(D - 2);
  result_.volumes.assign(rows, 0.0);
  result_.areas.assign(rows, 0.0);
  UnionDerivatives& derivatives = result_.derivatives;
  if (options_.derivatives) {
    derivatives.area_by_radius.assign(rows, 0.0);
    derivatives.volume_by_centre.assign(D * rows, 0.0);
    derivatives.area_by_centre.assign(D * rows, 0.0);
  }
  CompensatedSum volume, area, curvature;
  for (std::uint32_t vertex = 0; vertex < filtration_.count(0); ++vertex) {
    if (!is_in(SimplexId(vertex))) continue;
    const std::size_t row = triangulation.sites().row(vertex).row();
    const double r = facets_.spheres()[vertex].radius;
    const bool is_interior = filtration_.interior(SimplexId(vertex)) <= index_;
    const double exposed = is_interior ? 0.0 : std::max(0.0, kAllDirections - taken_[vertex]);
    const double own_area = exposed * (D == 3 ? r * r : r);
    const double own_volume = (r * own_area + beside_[vertex]) / D;
    result_.areas[row] = in(areas, own_area);
    result_.volumes[row] = in(volumes, std::max(0.0, own_volume));
    area.add(own_area);
    volume.add(own_volume);
    curvature.add(exposed * r);
    if (!options_.derivatives) continue;
    derivatives.area_by_radius[row] = in(lower, (D == 3 ? 2 * r : 1.0) * exposed - turned_[vertex]);
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double pushed = pushed_[std::size_t{D} * vertex + axis];
      derivatives.volume_by_centre[D * row + axis] = in(areas, pushed);
      derivatives.area_by_centre[D * row + axis] =
          r > 0.0 ? in(lower, (D - 1) / r * pushed - dragged_[std::size_t{D} * vertex + axis])
                  : 0.0;
    }
  }
  result_.volume = volumes(volume.value());
  result_.area = areas(area.value());
  if constexpr (D == 3) {
    result_.mean_curvature = units(1)(curvature.value() - bends_.value());
  }
}

template <int D>
void Union<D>::count() {
  for (int dimension = 0; dimension <= D; ++dimension) {
    const auto enters = filtration_.enters().subspan(filtration_.table().first(dimension),
                                                     filtration_.count(dimension));
    const auto in = std::count_if(enters.begin(), enters.end(),
                                  [&](std::uint32_t index) { return index <= index_; });
    result_.euler += dimension % 2 == 0 ? in : -in;
  }
}

template <int D>
void Union<D>::sort_contacts() {
  const InputUnits areas = units(D - 1), lengths = units(D - 2);
  for (Contact& contact : result_.contacts) {
    contact.area = in(areas, contact.area);
    contact.exposed_length = in(lengths, contact.exposed_length);
  }
  std::sort(result_.contacts.begin(), result_.contacts.end(),
            [](const Contact& a, const Contact& b) { return a.rows < b.rows; });
}

}  // namespace

template <int D>
UnionOfBalls union_of_balls(const Filtration<D>& filtration, std::uint32_t index, double alpha2,
                            const UnionOptions& options) {
  return Union<D>(filtration, index, alpha2, options).measured();
}

template UnionOfBalls union_of_balls<2>(const Filtration<2>&, std::uint32_t, double,
                                        const UnionOptions&);
template UnionOfBalls union_of_balls<3>(const Filtration<3>&, std::uint32_t, double,
                                        const UnionOptions&);

}  // namespace orthoball
