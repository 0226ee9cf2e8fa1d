// SPDX-License-Identifier: MIT
#include "orthoball/measures/contribution_stream.h"

#include <algorithm>
#include <bit>
#include <span>

namespace orthoball {
namespace {

// Groups of simplices by the leading bits of their numbers: few enough for all their ends to stay
// in the processor's caches, many enough for the sites of one to do so.
constexpr unsigned kGroupBits = 11;

}  // namespace

template <int D, class Contribution>
ContributionStream<D, Contribution>::ContributionStream(const Filtration<D>& filtration,
                                                        const Contributions<D>& contributions,
                                                        int dimension)
    : filtration_(&filtration),
      contributions_(contributions),
      first_(filtration.table().first(dimension)),
      count_(static_cast<std::uint32_t>(filtration.count(dimension))) {}

template <int D, class Contribution>
void ContributionStream<D, Contribution>::fill_window() {
  const std::span<const SimplexId> filter = filtration_->filter();
  wanted_.resize(std::min<std::size_t>(kWindow, count_) + 1);  // one more to write in vain
  std::size_t wanted = 0;
  while (position_ < filter.size() && wanted + 1 < wanted_.size()) {
    const std::uint32_t simplex = filter[position_++].row();
    wanted_[wanted] = simplex;
    wanted += simplex - first_ < count_ ? 1 : 0;
  }

  const auto bits = static_cast<unsigned>(std::bit_width(count_));
  const unsigned shift = bits > kGroupBits ? bits - kGroupBits : 0;
  std::vector<std::size_t> group_ends((std::size_t{1} << kGroupBits) + 1, 0);
  for (std::size_t i = 0; i < wanted; ++i) ++group_ends[((wanted_[i] - first_) >> shift) + 1];
  for (std::size_t g = 1; g < group_ends.size(); ++g) group_ends[g] += group_ends[g - 1];
  grouped_.resize(wanted);
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t group = (wanted_[i] - first_) >> shift;
    grouped_[group_ends[group]++] = {wanted_[i], static_cast<std::uint32_t>(i)};
  }

  window_.resize(wanted);
  next_ = 0;
  contributions_.measure(grouped_, window_);
}

template class ContributionStream<2, CellContribution<2>>;
template class ContributionStream<2, FacetContribution>;
template class ContributionStream<2, EdgeContribution>;
template class ContributionStream<3, CellContribution<3>>;
template class ContributionStream<3, FacetContribution>;
template class ContributionStream<3, EdgeContribution>;

}  // namespace orthoball
