// SPDX-License-Identifier: MIT
#include "orthoball/signatures/role_counts.h"

namespace orthoball {

template <int D>
RoleChangeCounts<D>::RoleChangeCounts(const Filtration<D>& filtration, int dimension,
                                      Threads threads) {
  const std::uint32_t first = filtration.table().first(dimension);
  const auto counts = [&](const auto& index) {
    return index_counts(
        filtration.never(), filtration.count(dimension), threads,
        [&](std::size_t i) { return index(SimplexId(first + static_cast<std::uint32_t>(i))); });
  };
  regular = counts([&](SimplexId simplex) { return filtration.regular(simplex); });
  interior = counts([&](SimplexId simplex) { return filtration.interior(simplex); });
}

template struct RoleChangeCounts<2>;
template struct RoleChangeCounts<3>;

}  // namespace orthoball
