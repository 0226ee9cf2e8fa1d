// SPDX-License-Identifier: MIT
#include "orthoball/signatures/role_counts.h"

namespace orthoball {

template <int D>
RoleCounts<D>::RoleCounts(const Filtration<D>& filtration) {
  for (int k = 0; k <= D; ++k) {
    total_[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(filtration.count(k));
  }
  const auto counts = [&](int k, auto index_of) -> IndexCounts {
    const std::uint32_t first = filtration.table().first(k);
    const auto count = static_cast<std::uint32_t>(filtration.count(k));
    return {filtration.never(), [&](const auto& visit) {
              for (std::uint32_t i = 0; i < count; ++i) visit(index_of(SimplexId(first + i)));
            }};
  };
  for (std::size_t k = 0; k < becoming_regular_.size(); ++k) {
    becoming_regular_[k] =
        counts(static_cast<int>(k), [&](SimplexId simplex) { return filtration.regular(simplex); });
  }
  for (std::size_t k = 0; k < becoming_interior_.size(); ++k) {
    becoming_interior_[k] = counts(static_cast<int>(k),
                                   [&](SimplexId simplex) { return filtration.interior(simplex); });
  }
}

template <int D>
void RoleCounts<D>::advance(const ByDimension<D>& entering) {
  ++index_;
  for (std::size_t k = 0; k < entering.size(); ++k) entered_[k] += entering[k];
  for (std::size_t k = 0; k < becoming_regular_.size(); ++k) {
    regular_ever_[k] += becoming_regular_[k].count(index_);
  }
  for (std::size_t k = 0; k < becoming_interior_.size(); ++k) {
    interior_[k] += becoming_interior_[k].count(index_);
  }
  // Every cell makes each of its facets regular or, being the second there, interior.
  regular_ever_[D - 1] = (D + 1) * entered_[D] - interior_[D - 1];
  regular_ever_[D] = interior_[D] = entered_[D];  // a cell is interior as soon as it enters
}

template <int D>
std::int64_t RoleCounts<D>::euler() const {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < entered_.size(); ++k) {
    sum += k % 2 == 0 ? std::int64_t{entered_[k]} : -std::int64_t{entered_[k]};
  }
  return sum;
}

template class RoleCounts<2>;
template class RoleCounts<3>;

}  // namespace orthoball
