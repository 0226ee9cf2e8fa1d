// SPDX-License-Identifier: MIT
//
// The body is the accessible union less a shell: what is nearer to the union's surface than the
// probe's radius. docs/derivations/molecular_surface.md has the formulas, and why nothing else than
// probes at rest reaches into the cells of the dual complex.
//
// Connolly. Analytical molecular surface calculation. Journal of Applied Crystallography 16 (1983).
// Quan, Stamm. Mathematical analysis and calculation of molecular surfaces. Journal of
// Computational Physics 322 (2016), for how probes cut each other.
#include "orthoball/measures/molecular_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "orthoball/error.h"
#include "orthoball/measures/angle.h"
#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/contact_facets.h"
#include "orthoball/measures/probes_at_rest.h"

namespace orthoball {
namespace {

class Surface {
 public:
  Surface(const Filtration<3>& filtration, const UnionOfBalls& accessible, double probe,
          Threads threads)
      : filtration_(filtration),
        accessible_(accessible),
        threads_(threads),
        balls_(filtration, accessible.index, accessible.alpha2),
        probe_(std::min(kFarther, balls_.from_input(probe, 1))) {}

  MolecularSurface measured(double probe) {
    if (std::isinf(accessible_.area) || std::isinf(accessible_.volume)) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      return {probe, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity};
    }
    add_spheres();
    add_arcs();
    add_probes_at_rest();
    const InputUnits volumes = balls_.units(3), areas = balls_.units(2);
    MolecularSurface result;
    result.probe = probe;
    result.volume = std::max(0.0, accessible_.volume - volumes(shell_.value()));
    result.convex_area = areas(convex_.value());
    result.toroidal_area = std::max(0.0, areas(toroidal_.value()));
    result.concave_area = std::max(0.0, areas(concave_.value()));
    result.area = result.convex_area + result.toroidal_area + result.concave_area;
    return result;
  }

 private:
  // Than any two points of any balls are from each other, and of a cube that does not overflow.
  static constexpr double kFarther = 0x1p302;

  void add_spheres();
  void add_arcs();
  void add_arc(const ContactFacet<3>& facet);
  void add_probes_at_rest();

  const Filtration<3>& filtration_;
  const UnionOfBalls& accessible_;
  Threads threads_;
  ScaledBalls<3> balls_;
  double probe_;          // from here on in the units of ScaledBalls
  CompensatedSum shell_;  // volume of the accessible union that is not in the body
  CompensatedSum convex_, toroidal_, concave_;
};

// From the exposed part of a sphere the probe reaches inwards, to the centre at most.
void Surface::add_spheres() {
  const Sites<3>& sites = filtration_.triangulation().sites();
  for (std::uint32_t vertex = 0; vertex < sites.size(); ++vertex) {
    const double exposed = balls_.from_input(accessible_.areas[sites.row(vertex).row()], 2);
    const double radius = balls_.spheres()[vertex].radius;
    if (!(exposed > 0.0 && radius > 0.0)) continue;
    const double depth = std::min(probe_, radius), kept = (radius - depth) / radius;
    shell_.add(exposed * depth * (1.0 + kept + kept * kept) / 3);
    convex_.add(exposed * kept * kept);
  }
}

void Surface::add_arcs() {
  const std::uint32_t first = filtration_.table().first(1);
  RawVector<SimplexId> edges;
  for (std::uint32_t i = 0; i < filtration_.count(1); ++i) {
    const SimplexId edge(first + i);
    if (filtration_.enters(edge) <= accessible_.index &&
        filtration_.interior(edge) > accessible_.index) {
      edges.push_back(edge);
    }
  }
  const ContactFacets<3> facets(filtration_, accessible_.index, accessible_.alpha2, threads_);
  for_each_facet<3>(facets, edges, threads_, [&](const ContactFacet<3>& facet) { add_arc(facet); });
}

// The probe turns about the axis of the two balls, at the distance c from it. Seen from its centre
// the directions between the two centres meet the axis at -h_0 to h_1 from the circle's centre; a
// direction that meets it at x does so at the distance l, l^2 = c^2 + x^2.
void Surface::add_arc(const ContactFacet<3>& facet) {
  const double c = facet.lens.radius, r = probe_;
  if (!(facet.exposed > 0.0 && c > 0.0)) return;
  double area = 0.0, volume = 0.0;
  // Where the probe does not reach the axis.
  const auto add_short_of_axis = [&](double from, double to) {
    if (!(from < to)) return;
    const auto angle = [&](double x) {
      return std::copysign(angle_from_x_axis(c, std::abs(x)), x);
    };
    const auto sine = [&](double x) { return x / std::sqrt(c * c + x * x); };
    const double turn = angle(to) - angle(from), sines = sine(to) - sine(from);
    area += r * (c * turn - r * sines);
    volume += r * r * (c * turn / 2 - r * sines / 3);
  };
  const double begin = -facet.lens.height[0], end = std::max(begin, facet.lens.height[1]);
  const double cusp = c < r ? std::sqrt((r - c) * (r + c)) : 0.0;
  const double first = std::clamp(-cusp, begin, end), last = std::clamp(cusp, begin, end);
  add_short_of_axis(begin, first);
  volume += c * c * (last - first) / 6;
  add_short_of_axis(last, end);
  toroidal_.add(area * facet.exposed);
  shell_.add(volume * facet.exposed);
}

void Surface::add_probes_at_rest() {
  for (const ProbePart& part :
       probes_at_rest(filtration_, accessible_.index, balls_.spheres(), probe_, threads_)) {
    shell_.add(part.volume);
    concave_.add(part.solid_angle * probe_ * probe_);
  }
}

}  // namespace

MolecularSurface molecular_surface(const Filtration<3>& filtration, const UnionOfBalls& accessible,
                                   double probe, Threads threads) {
  if (!(probe >= 0.0 && std::isfinite(probe))) {
    throw InputError(
        InputError::Reason::wrong_argument, InputError::kNoRow,
        "the radius of a probe must be finite and not negative, not " + std::to_string(probe));
  }
  return Surface(filtration, accessible, probe, threads).measured(probe);
}

}  // namespace orthoball
