// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filter_steps.h"

#include <bit>
#include <span>

namespace orthoball {

template <int D>
FilterSteps<D>::FilterSteps(const Filtration<D>& filtration)
    : filtration_(&filtration), starts_(filtration.size() / 64 + 1, 0) {
  const std::span<const SimplexId> filter = filtration.filter();
  std::uint32_t index = 0;
  for (std::size_t position = 0; position < filter.size(); ++position) {
    const std::uint32_t enters = filtration.enters(filter[position]);
    starts_[position / 64] |= std::uint64_t{enters != index} << position % 64;
    index = enters;
  }
  starts_[filter.size() / 64] |= std::uint64_t{1} << filter.size() % 64;  // ends the last step
}

template <int D>
bool FilterSteps<D>::next() {
  const std::span<const SimplexId> filter = filtration_->filter();
  if (end_ == filter.size()) return false;
  const SimplexTable<D>& table = filtration_->table();
  ++index_;
  entering_ = {};
  do {
    const std::uint32_t simplex = filter[end_].row();
    std::size_t dimension = 0;
    for (int k = 1; k <= D; ++k) dimension += simplex >= table.first(k) ? 1U : 0U;
    ++entering_[dimension];
    ++end_;
  } while ((starts_[end_ / 64] >> end_ % 64 & 1U) == 0);
  return true;
}

template class FilterSteps<2>;
template class FilterSteps<3>;

}  // namespace orthoball
