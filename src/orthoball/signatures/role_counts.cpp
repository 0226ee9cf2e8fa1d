// SPDX-License-Identifier: MIT
#include "orthoball/signatures/role_counts.h"

namespace orthoball {

template <int D>
RoleCounts<D>::RoleCounts(const Filtration<D>& filtration) {
  for (int k = 0; k <= D; ++k) {
    total_[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(filtration.count(k));
  }
  for (int k = 0; k < D; ++k) {
    IndexHistogram regular(filtration.never()), interior(filtration.never());
    const std::uint32_t first = filtration.table().first(k);
    for (std::uint32_t i = 0; i < filtration.count(k); ++i) {
      regular.add(filtration.regular(SimplexId(first + i)));
      interior.add(filtration.interior(SimplexId(first + i)));
    }
    regular.finish();
    interior.finish();
    becoming_regular_[static_cast<std::size_t>(k)] = std::move(regular);
    becoming_interior_[static_cast<std::size_t>(k)] = std::move(interior);
  }
}

template <int D>
void RoleCounts<D>::advance(const ByDimension<D>& entering) {
  ++index_;
  for (std::size_t k = 0; k < entering.size(); ++k) entered_[k] += entering[k];
  for (std::size_t k = 0; k < becoming_regular_.size(); ++k) {
    regular_ever_[k] += becoming_regular_[k].count(index_);
    interior_[k] += becoming_interior_[k].count(index_);
  }
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
