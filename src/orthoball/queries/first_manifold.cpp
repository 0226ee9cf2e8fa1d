// SPDX-License-Identifier: MIT
#include "orthoball/queries/first_manifold.h"

#include <algorithm>
#include <cstddef>

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

  StarParts<D> stars(filtration);
  std::vector<bool> is_offending(filtration.count(0));
  std::size_t offending = 0;
  const auto look_at = [&](std::uint32_t vertex) {
    stars.read(vertex, solid);
    const bool is_now = stars.surplus() > 0;
    if (is_now != is_offending[vertex]) is_now ? ++offending : --offending;
    is_offending[vertex] = is_now;
  };
  for (std::uint32_t vertex = 0; vertex < is_offending.size(); ++vertex) look_at(vertex);

  std::vector<std::uint32_t> changed;  // vertices of cells that entered since it was looked at them
  std::size_t next = 0;
  for (std::uint32_t index = from; index <= filtration.spectrum_size(); ++index) {
    for (; next < later.size() && later[next] >> 32U <= index; ++next) {
      const auto cell = static_cast<std::uint32_t>(later[next]);
      solid[cell] = true;
      const auto& corners = records[cell].corners;
      changed.insert(changed.end(), corners.begin(), corners.end());
    }
    if (!may_be[index]) continue;
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t vertex : changed) look_at(vertex);
    changed.clear();
    if (offending == 0) return index;
  }
  return {};
}

template std::optional<std::uint32_t> first_manifold<2>(const Filtration<2>&, std::uint32_t,
                                                        const std::vector<bool>&);
template std::optional<std::uint32_t> first_manifold<3>(const Filtration<3>&, std::uint32_t,
                                                        const std::vector<bool>&);

}  // namespace orthoball
