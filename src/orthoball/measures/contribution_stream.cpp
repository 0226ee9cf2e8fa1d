// SPDX-License-Identifier: MIT
#include "orthoball/measures/contribution_stream.h"

#include <algorithm>
#include <array>
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
  // One more to write in vain.
  std::vector<std::uint32_t> numbers(std::min<std::size_t>(kWindow, count_) + 1);
  std::size_t size = 0;
  while (position_ < filter.size() && size + 1 < numbers.size()) {
    const std::uint32_t number = filter[position_++].row() - first_;
    numbers[size] = number;
    size += number < count_ ? 1U : 0U;
  }
  group(std::span(numbers).first(size));
  measure_groups();
  stretch_begin_ = 0;
}

template <int D, class Contribution>
void ContributionStream<D, Contribution>::group(std::span<const std::uint32_t> numbers) {
  const auto bits = static_cast<unsigned>(std::bit_width(count_));
  const unsigned shift = bits > kGroupBits ? bits - kGroupBits : 0;
  std::vector<std::uint32_t> group_ends((std::size_t{1} << kGroupBits) + 1, 0);
  for (const std::uint32_t number : numbers) ++group_ends[(number >> shift) + 1];
  for (std::size_t g = 1; g < group_ends.size(); ++g) group_ends[g] += group_ends[g - 1];
  grouped_.resize(numbers.size());
  for (std::uint32_t place = 0; place < numbers.size(); ++place) {
    grouped_[group_ends[numbers[place] >> shift]++] = {numbers[place], place};
  }
}

template <int D, class Contribution>
void ContributionStream<D, Contribution>::measure_groups() {
  constexpr std::size_t kAtOnce = 4096;
  std::vector<std::uint32_t> simplices(kAtOnce);
  std::vector<Contribution> results(kAtOnce);
  measured_.resize(grouped_.size());
  place_.resize(grouped_.size());
  std::vector<std::size_t> ends;  // [stretch]: of those dealt to it
  for (std::size_t begin = 0; begin < grouped_.size(); begin += kStretch) ends.push_back(begin);
  for (std::size_t begin = 0; begin < grouped_.size(); begin += kAtOnce) {
    const std::size_t size = std::min(kAtOnce, grouped_.size() - begin);
    for (std::size_t i = 0; i < size; ++i) simplices[i] = first_ + grouped_[begin + i].number;
    contributions_.measure(std::span(simplices).first(size), std::span(results).first(size));
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint32_t place = grouped_[begin + i].place;
      const std::size_t to = ends[place / kStretch]++;
      measured_[to] = results[i];
      place_[to] = static_cast<std::uint16_t>(place % kStretch);
    }
  }
}

template <int D, class Contribution>
void ContributionStream<D, Contribution>::fill_stretch() {
  if (stretch_begin_ == measured_.size()) fill_window();
  const std::size_t size = std::min(kStretch, measured_.size() - stretch_begin_);
  stretch_.resize(size);
  for (std::size_t i = stretch_begin_; i < stretch_begin_ + size; ++i) {
    stretch_[place_[i]] = measured_[i];
  }
  stretch_begin_ += size;
  next_ = 0;
}

template class ContributionStream<2, CellContribution<2>>;
template class ContributionStream<2, FacetContribution>;
template class ContributionStream<2, EdgeContribution>;
template class ContributionStream<3, CellContribution<3>>;
template class ContributionStream<3, FacetContribution>;
template class ContributionStream<3, EdgeContribution>;

}  // namespace orthoball
