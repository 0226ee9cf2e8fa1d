// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/parallel.h"
#include "orthoball/topology/betti.h"

namespace orthoball {

/// Everything that is counted and measured of the alpha complex at one index of the spectrum.
///
/// Lengths, areas and volumes are in input units; each is a compensated sum rounded once, so that
/// the last index agrees with the convex hull to 1e-12 relative. In the plane `volume` is the area
/// of the triangles and the areas are lengths of edges (`length` is then unused, 0). Where the
/// sites span less than R^D, volume is 0 and the top simplices end as singular ones.
template <int D>
struct Signature {
  std::uint32_t index = 0;  ///< 0..s
  double alpha2 = 0.0;      ///< label of the index, -infinity for 0; length^2
  BettiNumbers<D> betti{};  ///< components, tunnels[, voids]
  std::int64_t euler = 0;   ///< vertices - edges + triangles - tetrahedra
  /// [dimension] numbers of simplices by role; their sums are the simplices of the triangulation.
  ByDimension<D> exterior{}, singular{}, regular{}, interior{};
  double volume = 0.0;         ///< of the cells in the complex; length^D
  double area_singular = 0.0;  ///< of singular facets, one side each; length^(D-1)
  double area_regular = 0.0;   ///< of regular facets, one side each; length^(D-1)
  double area = 0.0;           ///< two-sided: area_regular + 2 area_singular; length^(D-1)
  double length = 0.0;  ///< sum of edge length x complementary angle; mean width x 4 pi; D = 3
};

/// Calls `visit` with the signature of every index 1..s in order (index 0, the empty complex, is
/// not visited), from the caller's thread. O(n) time; about 180 bytes of extra memory a site
/// in space. Small works stay on one thread.
template <int D>
void scan_signatures(const Filtration<D>& filtration,
                     const std::function<void(const Signature<D>&)>& visit, Threads threads = {});

/// The signatures at the given indices (0..s, any order, repeats allowed), in that order; one scan.
/// @throws InputError for an index beyond s.
template <int D>
[[nodiscard]] std::vector<Signature<D>> signatures(const Filtration<D>& filtration,
                                                   std::span<const std::uint32_t> indices,
                                                   Threads threads = {});

}  // namespace orthoball
