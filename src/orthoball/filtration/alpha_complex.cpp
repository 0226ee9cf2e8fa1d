// SPDX-License-Identifier: MIT
#include "orthoball/filtration/alpha_complex.h"

#include <algorithm>
#include <string>

#include "orthoball/error.h"

namespace orthoball {

template <int D>
AlphaComplex<D>::AlphaComplex(const Filtration<D>& filtration, std::uint32_t index)
    : filtration_(&filtration), index_(index) {
  if (index > filtration.spectrum_size()) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "index " + std::to_string(index) + " is beyond the spectrum; it has " +
                         std::to_string(filtration.spectrum_size()) + " entries");
  }
}

template <int D>
std::vector<SimplexId> AlphaComplex<D>::simplices(int dimension, Role role) const {
  const std::uint32_t first = filtration_->table().first(dimension);
  const auto count = static_cast<std::uint32_t>(filtration_->count(dimension));
  std::vector<SimplexId> result;
  for (std::uint32_t simplex = first; simplex < first + count; ++simplex) {
    if (this->role(SimplexId(simplex)) == role) result.emplace_back(simplex);
  }
  return result;
}

template <int D>
BoundaryIndex<D>::BoundaryIndex(const Filtration<D>& filtration) {
  for (int dimension = 0; dimension < D; ++dimension) {
    const auto at = static_cast<std::size_t>(dimension);
    first_[at] = filtration.table().first(dimension);
    std::vector<IndexInterval> intervals(filtration.count(dimension));
    for (std::uint32_t i = 0; i < intervals.size(); ++i) {
      const SimplexId simplex(first_[at] + i);
      intervals[i] = {filtration.enters(simplex), dimension == D - 1 ? filtration.interior(simplex)
                                                                     : filtration.regular(simplex)};
    }
    trees_[at] = IntervalTree(intervals);
  }
}

template <int D>
std::vector<SimplexId> BoundaryIndex<D>::simplices(int dimension, std::uint32_t index) const {
  const auto at = static_cast<std::size_t>(dimension);
  std::vector<SimplexId> result;
  trees_[at].for_each_containing(index,
                                 [&](std::uint32_t row) { result.emplace_back(first_[at] + row); });
  std::sort(result.begin(), result.end());
  return result;
}

template class AlphaComplex<2>;
template class AlphaComplex<3>;
template class BoundaryIndex<2>;
template class BoundaryIndex<3>;

}  // namespace orthoball
