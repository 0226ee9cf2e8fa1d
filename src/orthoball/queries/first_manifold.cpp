// SPDX-License-Identifier: MIT
#include "orthoball/queries/first_manifold.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "orthoball/queries/star_parts.h"
#include "orthoball/topology/keyed_simplices.h"

namespace orthoball {

template <int D>
std::optional<std::uint32_t> first_manifold(const Filtration<D>& filtration, std::uint32_t from,
                                            const std::vector<bool>& may_be) {
  const KeyedSimplices cells(filtration, D);
  const auto records = filtration.triangulation().template cells<D>();
  if (records.empty()) return {};
  std::vector<bool> solid(records.size());
  std::vector<std::uint64_t> later;
  for (std::uint32_t cell = 0; cell < records.size(); ++cell) {
    solid[cell] = cells.enters(cell) <= from;
    if (!solid[cell]) later.push_back(cells.key(cell));
  }
  std::sort(later.begin(), later.end());

  StarParts<D> stars(filtration, std::move(solid));
  std::size_t next = 0;
  for (std::uint32_t index = from; index <= filtration.spectrum_size(); ++index) {
    for (; next < later.size() && later[next] >> 32U <= index; ++next) {
      stars.turn(std::array{static_cast<std::uint32_t>(later[next])});
    }
    if (may_be[index] && stars.offending_count() == 0) return index;
  }
  return {};
}

template std::optional<std::uint32_t> first_manifold<2>(const Filtration<2>&, std::uint32_t,
                                                        const std::vector<bool>&);
template std::optional<std::uint32_t> first_manifold<3>(const Filtration<3>&, std::uint32_t,
                                                        const std::vector<bool>&);

}  // namespace orthoball
