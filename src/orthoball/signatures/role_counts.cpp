// SPDX-License-Identifier: MIT
#include "orthoball/signatures/role_counts.h"

namespace orthoball {

template <int D>
RoleChangeCounts<D>::RoleChangeCounts(const Filtration<D>& filtration, int dimension) {
  const std::uint32_t first = filtration.table().first(dimension);
  const auto count = static_cast<std::uint32_t>(filtration.count(dimension));
  regular = {filtration.never(), [&](const auto& visit) {
               for (std::uint32_t i = 0; i < count; ++i) {
                 visit(filtration.regular(SimplexId(first + i)));
               }
             }};
  interior = {filtration.never(), [&](const auto& visit) {
                for (std::uint32_t i = 0; i < count; ++i) {
                  visit(filtration.interior(SimplexId(first + i)));
                }
              }};
}

template struct RoleChangeCounts<2>;
template struct RoleChangeCounts<3>;

}  // namespace orthoball
