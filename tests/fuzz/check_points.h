// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "fuzz/points_from_bytes.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/triangulation/verify.h"

namespace orthoball::fuzz {

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
}

}  // namespace orthoball::fuzz
