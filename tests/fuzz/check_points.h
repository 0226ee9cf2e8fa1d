// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "fuzz/points_from_bytes.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/molecular_surface.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/queries/pockets.h"
#include "orthoball/queries/voids.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/betti.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/triangulation/verify.h"

namespace orthoball::fuzz {

/// Stops the program unless at some indices unions of balls are numbers, never below 0 by part,
/// with as many voids and closed pockets as the complex has.
template <int D>
void check_balls(const Filtration<D>& filtration) {
  const std::uint32_t size = filtration.spectrum_size();
  for (const std::uint32_t index : {std::uint32_t{0}, size / 3, size / 2, size}) {
    const double alpha2 = index == 0 ? -1.0 : filtration.alpha2(index);
    if (!std::isfinite(alpha2)) continue;
    const UnionOfBalls balls =
        union_of_balls(filtration, index, alpha2,
                       UnionOptions{.contacts = true, .derivatives = true, .threads = Threads(1)});
    require(balls.volume >= 0.0 && balls.area >= 0.0 && !std::isnan(balls.mean_curvature),
            "a union is not a number");
    for (const auto* parts : {&balls.volumes, &balls.areas}) {
      require(std::all_of(parts->begin(), parts->end(), [](double x) { return x >= 0.0; }),
              "a ball's part is not a number");
    }
    for (const Contact& contact : balls.contacts) {
      require(contact.area >= 0.0 && contact.exposed_length >= 0.0, "a contact is not a number");
    }
    if constexpr (D == 3) {
      for (const double probe : {0.0, std::sqrt(std::abs(alpha2)) / 2, 1e300}) {
        const MolecularSurface surface = molecular_surface(filtration, balls, probe, Threads(1));
        require(surface.volume >= 0.0 && !std::isnan(surface.area),
                "a molecular surface is not a number");
      }
    }
    const auto voids = orthoball::voids(filtration, index, alpha2, VoidsOf::balls);
    require(voids.size() == betti_numbers(filtration, index)[D - 1], "voids are lost");
    const auto pockets = orthoball::pockets(filtration, index, alpha2);
    require(static_cast<std::size_t>(std::count_if(
                pockets.begin(), pockets.end(),
                [](const Pocket& pocket) { return pocket.mouths.empty(); })) == voids.size(),
            "voids are no pockets");
    for (const auto& one : voids) {
      require(one.volume >= 0.0 && !std::isnan(one.largest_ball_radius), "a void is no number");
    }
  }
}

/// Stops the program unless the triangulation verifies, the filtration is one, and the Betti
/// numbers of every index have the Euler number of its simplices.
template <int D>
void check_points(const WeightedPoints& points) {
  auto triangulation = regular_triangulation<D>(points);
  require_none(verify(triangulation, points));

  const Filtration<D> filtration(std::move(triangulation));
  const Filter<D> filter(filtration);
  std::uint32_t last = 0;
  for (const SimplexId simplex : filter.simplices()) {
    const std::uint32_t enters = filtration.enters(simplex);
    require(enters == last || enters == last + 1, "the filter is not sorted");
    last = enters;
    require(enters <= filtration.regular(simplex), "regular before it enters");
    require(filtration.regular(simplex) <= filtration.interior(simplex), "interior before regular");
    for (const SimplexId facet : filtration.facets(simplex)) {
      require(filtration.enters(facet) <= enters, "a simplex enters before its face");
      require(filtration.regular(facet) <= enters, "a face becomes regular after its coface");
    }
  }
  require(last == filtration.spectrum_size(), "an index that nothing enters at");
  require(std::is_sorted(filtration.spectrum().begin(), filtration.spectrum().end()),
          "labels decrease");

  scan_signatures<D>(filtration, [](const Signature<D>& signature) {
    std::int64_t euler = 0;
    for (std::size_t k = 0; k < D; ++k) {
      euler += (k % 2 == 0 ? 1 : -1) * static_cast<std::int64_t>(signature.betti[k]);
    }
    require(euler == signature.euler, "Betti numbers without the Euler number");
    require(!std::isnan(signature.volume) && !std::isnan(signature.area) &&
                !std::isnan(signature.length),
            "a measure is NaN");
  });
  check_balls(filtration);
}

}  // namespace orthoball::fuzz
