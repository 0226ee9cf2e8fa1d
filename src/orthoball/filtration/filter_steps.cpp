// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filter_steps.h"

#include <span>

namespace orthoball {

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
  } while (!filtration_->starts_index(end_));
  return true;
}

template class FilterSteps<2>;
template class FilterSteps<3>;

}  // namespace orthoball
