// SPDX-License-Identifier: MIT
#include "orthoball/queries/locate.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "orthoball/queries/containment.h"
#include "orthoball/queries/regions.h"

namespace orthoball {

template <int D>
std::vector<Location<D>> locate(const AlphaComplex<D>& complex, const WeightedPoints& points,
                                Threads threads) {
  const Filtration<D>& filtration = complex.filtration();
  const std::vector<SimplexId> simplices = simplices_at(filtration, points, threads);
  const std::vector<BoundaryPoint<D>> nearest = nearest_on_boundary(complex, points, threads);
  std::vector<std::pair<SiteId, std::uint32_t>> region_of_row;
  std::uint32_t number = 0;
  for (const Region& region : regions(complex, JoinedBy::vertices)) {
    ++number;
    for (const SiteId row : region.rows) region_of_row.emplace_back(row, number);
  }
  std::sort(region_of_row.begin(), region_of_row.end());
  std::vector<Location<D>> result(points.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {simplices[i], 0, nearest[i]};
    if (!simplices[i].exists() || !complex.contains(simplices[i])) continue;
    const std::pair row(filtration.rows(simplices[i])[0], std::uint32_t{0});
    result[i].region = std::lower_bound(region_of_row.begin(), region_of_row.end(), row)->second;
  }
  return result;
}

template std::vector<Location<2>> locate<2>(const AlphaComplex<2>&, const WeightedPoints&, Threads);
template std::vector<Location<3>> locate<3>(const AlphaComplex<3>&, const WeightedPoints&, Threads);

}  // namespace orthoball
