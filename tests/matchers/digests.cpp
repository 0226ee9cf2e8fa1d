// SPDX-License-Identifier: MIT
#include "matchers/digests.h"

#include <bit>
#include <cmath>
#include <cstdio>

#include "orthoball/filtration/filter.h"
#include "orthoball/measures/molecular_surface.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/queries/pockets.h"
#include "orthoball/queries/voids.h"
#include "orthoball/signatures/signature.h"

namespace orthoball::matchers {

void Digest::add(std::uint64_t number) {
  state_ = (state_ ^ number) * 0x9E3779B97F4A7C15ULL;
  state_ ^= state_ >> 29U;
}
void Digest::add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

std::uint64_t Digest::value() const {
  Digest both = *this;
  both.add(set_);
  return both.state_ * 0xD1B54A32D192ED03ULL;
}

std::string Digest::text() const {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value()));
  return text;
}

namespace {

template <int D>
Digest of_row(const WeightedPoints& points, SiteId row) {
  Digest digest;
  for (std::size_t axis = 0; axis < D; ++axis) {
    digest.add(points.coordinates()[D * row.row() + axis] + 0.0);  // -0 is 0
  }
  if (!points.weights().empty()) digest.add(points.weights()[row.row()] + 0.0);
  if (!points.weights_low().empty()) digest.add(points.weights_low()[row.row()] + 0.0);
  return digest;
}

template <int A, int D>
void add_cells(const RegularTriangulation<D>& triangulation, Digest& digest) {
  for (const CellRecord<A>& cell : triangulation.template cells<A>()) {
    for (const std::uint32_t corner : cell.corners) digest.add(std::uint64_t{corner});
    for (const std::uint32_t facet : cell.neighbours) digest.add(std::uint64_t{facet});
  }
}

}  // namespace

template <int D>
Digest digest(const RegularTriangulation<D>& triangulation, const WeightedPoints& points) {
  Digest digest;
  for (std::uint32_t vertex = 0; vertex < triangulation.vertex_count(); ++vertex) {
    digest.add(of_row<D>(points, triangulation.sites().row(vertex)).value());
  }
  for (const SiteId row : triangulation.hidden()) digest.add_to_set(of_row<D>(points, row));
  for (const Duplicate& duplicate : triangulation.duplicates()) {
    digest.add_to_set(of_row<D>(points, duplicate.row));
  }
  add_cells<1>(triangulation, digest);
  add_cells<2>(triangulation, digest);
  if constexpr (D == 3) add_cells<3>(triangulation, digest);
  return digest;
}

template <int D>
Digest digest(const Filtration<D>& filtration, Threads threads) {
  Digest digest;
  for (const double alpha2 : filtration.spectrum()) digest.add(alpha2);
  const Filter<D> filter(filtration, threads);
  for (const SimplexId simplex : filter.simplices()) {
    digest.add(std::uint64_t{simplex.row()} << 1U | (filtration.is_attached(simplex) ? 1U : 0U));
    digest.add(std::uint64_t{filtration.enters(simplex)});
    digest.add(std::uint64_t{filtration.regular(simplex)} << 32U | filtration.interior(simplex));
  }
  return digest;
}

template <int D>
Digest signatures_digest(const Filtration<D>& filtration, Threads threads) {
  Digest digest;
  const auto add = [&](const auto& numbers) {
    for (const std::uint32_t number : numbers) digest.add(std::uint64_t{number});
  };
  scan_signatures<D>(
      filtration,
      [&](const Signature<D>& signature) {
        add(signature.betti);
        add(signature.singular);
        add(signature.regular);
        add(signature.interior);
        digest.add(signature.volume);
        digest.add(signature.area_singular);
        digest.add(signature.area_regular);
        digest.add(signature.length);
      },
      threads);
  return digest;
}

template <int D>
Digest balls_digest(const Filtration<D>& filtration, Threads threads) {
  Digest digest;
  const std::uint32_t index = filtration.spectrum_size() / 2;
  if (index == 0) return digest;
  const double alpha2 = filtration.alpha2(index);
  if (!std::isfinite(alpha2)) return digest;
  const UnionOfBalls balls =
      union_of_balls(filtration, index, alpha2,
                     UnionOptions{.contacts = true, .derivatives = true, .threads = threads});
  for (const double number : {balls.volume, balls.area, balls.mean_curvature}) digest.add(number);
  digest.add(static_cast<std::uint64_t>(balls.euler));
  if constexpr (D == 3) {
    const MolecularSurface surface =
        molecular_surface(filtration, balls, std::sqrt(std::abs(alpha2)) / 2, threads);
    for (const double number : {surface.volume, surface.area}) digest.add(number);
  }
  for (const SiteId row : filtration.triangulation().sites().rows()) {
    digest.add(balls.volumes[row.row()]);
    digest.add(balls.areas[row.row()]);
    digest.add(balls.derivatives.area_by_radius[row.row()]);
    for (std::size_t axis = 0; axis < D; ++axis) {
      digest.add(balls.derivatives.volume_by_centre[D * row.row() + axis]);
      digest.add(balls.derivatives.area_by_centre[D * row.row() + axis]);
    }
  }
  for (const Contact& contact : balls.contacts) {
    Digest of_one;
    of_one.add(contact.area);
    of_one.add(contact.exposed_length);
    digest.add_to_set(of_one);
  }
  for (const auto& one : voids(filtration, index, alpha2, VoidsOf::balls, threads)) {
    Digest of_one;
    for (const double number : {one.volume, one.area, one.largest_ball_radius}) of_one.add(number);
    of_one.add(std::uint64_t{one.born} << 32U | one.dies);
    for (const SimplexId cell : one.cells) of_one.add(std::uint64_t{cell.row()});
    digest.add_to_set(of_one);
  }
  for (const Pocket& pocket : pockets(filtration, index, alpha2, threads)) {
    Digest of_one;
    of_one.add(pocket.volume);
    of_one.add(pocket.area);
    for (const Mouth& mouth : pocket.mouths) of_one.add(mouth.area);
    digest.add_to_set(of_one);
  }
  return digest;
}

template Digest digest<2>(const RegularTriangulation<2>&, const WeightedPoints&);
template Digest digest<3>(const RegularTriangulation<3>&, const WeightedPoints&);
template Digest digest<2>(const Filtration<2>&, Threads);
template Digest digest<3>(const Filtration<3>&, Threads);
template Digest signatures_digest<2>(const Filtration<2>&, Threads);
template Digest signatures_digest<3>(const Filtration<3>&, Threads);
template Digest balls_digest<2>(const Filtration<2>&, Threads);
template Digest balls_digest<3>(const Filtration<3>&, Threads);

}  // namespace orthoball::matchers
