// SPDX-License-Identifier: MIT
//
// A sort by index that leaves simplices of one index by number, which is by dimension. They are
// dealt to stretches of indices in the order of their numbers, and each stretch, which fits the
// second cache where indices have few simplices each, is sorted by counting. Both steps keep the
// order of what they do not tell apart.
#include "orthoball/filtration/filter.h"

#include <algorithm>
#include <utility>

#include "orthoball/places_of_parts.h"

namespace orthoball {
namespace {

constexpr unsigned kStretchBits = 16;  // indices of a stretch
constexpr std::size_t kStretch = std::size_t{1} << kStretchBits;
constexpr std::size_t kLeastPart = std::size_t{1} << 15U;  // simplices for a thread of its own

class FilterOrder {
 public:
  FilterOrder(std::span<const std::uint32_t> enters, std::uint32_t last_index, Threads threads,
              std::span<SimplexId> order)
      : enters_(enters),
        index_count_(std::size_t{last_index} + 1),
        threads_(threads.for_work(enters.size(), kLeastPart)),
        order_(order),
        begins_((last_index >> kStretchBits) + 2, 0),
        lower_bits_(enters.size()) {}

  void fill() {
    deal();
    parallel_for(threads_, stretch_count(), [&](std::size_t stretch) { sort(stretch); });
  }

 private:
  [[nodiscard]] std::size_t stretch_count() const { return begins_.size() - 1; }
  void deal();
  void sort(std::size_t stretch);

  std::span<const std::uint32_t> enters_;  // [simplex]
  std::size_t index_count_;
  Threads threads_;
  std::span<SimplexId> order_;           // at last sorted in each stretch; before, by number
  std::vector<std::uint32_t> begins_;    // [stretch]: in the order; and the end
  RawVector<std::uint16_t> lower_bits_;  // of the index of each as it was dealt
};

// Every part of the simplices has places of its own in each stretch.
void FilterOrder::deal() {
  std::vector<std::vector<std::uint32_t>> next(threads_.count());  // [part][stretch]
  parallel_parts(threads_, enters_.size(), next.size(),
                 [&](std::size_t part, std::size_t begin, std::size_t end) {
                   std::vector<std::uint32_t> counts(stretch_count(), 0);
                   for (std::size_t i = begin; i < end; ++i) ++counts[enters_[i] >> kStretchBits];
                   next[part] = std::move(counts);
                 });
  find_places_of_parts(next, begins_);
  parallel_parts(threads_, enters_.size(), next.size(),
                 [&](std::size_t part, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const std::uint32_t place = next[part][enters_[i] >> kStretchBits]++;
                     order_[place] = SimplexId(static_cast<std::uint32_t>(i));
                     lower_bits_[place] = static_cast<std::uint16_t>(enters_[i]);
                   }
                 });
}

void FilterOrder::sort(std::size_t stretch) {
  const std::size_t begin = begins_[stretch], size = begins_[stretch + 1] - begin;
  const std::span<SimplexId> simplices = order_.subspan(begin, size);
  const std::span<const std::uint16_t> indices = std::span(lower_bits_).subspan(begin, size);
  std::vector<std::uint32_t> next(std::min(kStretch, index_count_ - stretch * kStretch), 0);
  for (const std::uint16_t index : indices) ++next[index];
  std::uint32_t first = 0;
  for (std::uint32_t& place : next) first += std::exchange(place, first);
  RawVector<SimplexId> sorted(size);
  for (std::size_t i = 0; i < size; ++i) sorted[next[indices[i]]++] = simplices[i];
  std::copy(sorted.begin(), sorted.end(), simplices.begin());
}

}  // namespace

template <int D>
Filter<D>::Filter(const Filtration<D>& filtration, Threads threads)
    : filtration_(&filtration), simplices_(filtration.size()) {
  FilterOrder(filtration.enters(), filtration.spectrum_size(), threads, simplices_).fill();
}

template <int D>
std::size_t Filter<D>::complex_size(std::uint32_t index) const {
  const auto beyond = std::upper_bound(
      simplices_.begin(), simplices_.end(), index,
      [&](std::uint32_t i, SimplexId simplex) { return i < filtration_->enters(simplex); });
  return static_cast<std::size_t>(beyond - simplices_.begin());
}

template <int D>
std::vector<SimplexId> Filter<D>::by_rows() const {
  struct Keyed {
    FewOf<SiteId, D> rows;
    SimplexId simplex;
  };
  std::vector<SimplexId> sorted(simplices_.begin(), simplices_.end());
  std::vector<Keyed> tied;
  for (std::size_t begin = 0; begin < sorted.size();) {
    const auto is_tied = [&](SimplexId simplex) {
      return filtration_->enters(simplex) == filtration_->enters(sorted[begin]) &&
             filtration_->dimension(simplex) == filtration_->dimension(sorted[begin]);
    };
    std::size_t end = begin + 1;
    while (end < sorted.size() && is_tied(sorted[end])) ++end;
    if (end - begin > 1) {
      tied.clear();
      for (std::size_t i = begin; i < end; ++i) {
        tied.push_back({filtration_->rows(sorted[i]), sorted[i]});
      }
      std::sort(tied.begin(), tied.end(), [](const Keyed& a, const Keyed& b) {
        return std::lexicographical_compare(a.rows.begin(), a.rows.end(), b.rows.begin(),
                                            b.rows.end());
      });
      for (std::size_t i = begin; i < end; ++i) sorted[i] = tied[i - begin].simplex;
    }
    begin = end;
  }
  return sorted;
}

template class Filter<2>;
template class Filter<3>;

}  // namespace orthoball
