// SPDX-License-Identifier: MIT
//
// The order of the unattached simplices is known; the attached ones are sorted in among them. These
// are dealt to stretches of indices, by number, and each stretch, whose indices fit the cache, is
// then put together by itself: counted, the attached ones put first at each index, then the others.
// That is by number where an index has one unattached simplex, of which all the others are faces;
// elsewhere the two are merged.
#include "orthoball/filtration/filter_order.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <utility>

#include "orthoball/raw_vector.h"

namespace orthoball {
namespace {

constexpr unsigned kStretchBits = 15;  // indices of a stretch
constexpr std::uint32_t kStretch = std::uint32_t{1} << kStretchBits;

// An attached simplex, and its index within the stretch: 6 bytes.
struct Attached {
  std::array<std::uint16_t, 2> simplex;
  std::uint16_t index;
};

class FilterOrder {
 public:
  FilterOrder(std::span<const SimplexId> order, const RankedBits& starts,
              std::span<const std::uint32_t> enters, std::span<const std::uint64_t> is_attached,
              Threads threads, std::span<SimplexId> filter)
      : order_(order),
        starts_(starts),
        enters_(enters),
        is_attached_(is_attached),
        threads_(threads.for_work(filter.size(), kLeastPart)),
        filter_(filter),
        stretches_(starts.count() / kStretch + 1) {}

  std::vector<std::uint64_t> fill() {
    index_starts_.resize(filter_.size() / 64 + 1, 0);
    set_start(filter_.size());
    deal_attached();
    parallel_for(threads_, stretches_, [&](std::size_t stretch) { fill_stretch(stretch); });
    return std::move(index_starts_);
  }

 private:
  static constexpr std::size_t kLeastPart = std::size_t{1} << 17U;

  // Simplices of a stretch: where they begin in each of the two orders.
  struct Begin {
    std::uint32_t attached;
    std::uint32_t unattached;
  };

  void set_start(std::size_t place) {
    std::atomic_ref(index_starts_[place / 64])
        .fetch_or(std::uint64_t{1} << place % 64, std::memory_order_relaxed);
  }
  template <class Visit>
  void for_each_attached(std::size_t part, const Visit& visit) const;
  void deal_attached();
  [[nodiscard]] std::uint32_t first_unattached(std::size_t stretch) const;
  void fill_stretch(std::size_t stretch);
  void merge_shared(std::size_t begin, std::size_t end, std::uint32_t first_index,
                    const std::vector<std::uint32_t>& ends);

  std::span<const SimplexId> order_;
  const RankedBits& starts_;
  std::span<const std::uint32_t> enters_;
  std::span<const std::uint64_t> is_attached_;
  Threads threads_;
  std::span<SimplexId> filter_;
  std::size_t stretches_;
  std::vector<std::uint64_t> index_starts_;
  RawVector<Attached> attached_;
  std::vector<std::uint32_t> begins_;  // [stretch]: of its attached simplices; and behind the last
};

// By number, those of one of as many parts as there are threads.
template <class Visit>
void FilterOrder::for_each_attached(std::size_t part, const Visit& visit) const {
  const std::size_t words = is_attached_.size();
  const std::size_t parts = threads_.count();
  for (std::size_t word = words * part / parts; word < words * (part + 1) / parts; ++word) {
    for (std::uint64_t rest = is_attached_[word]; rest != 0; rest &= rest - 1) {
      visit(static_cast<std::uint32_t>(64 * word) +
            static_cast<std::uint32_t>(std::countr_zero(rest)));
    }
  }
}

// A counting sort by stretch, in which every part of the simplices has its own places.
void FilterOrder::deal_attached() {
  std::vector<std::vector<std::uint32_t>> next(threads_.count());
  parallel_for(threads_, next.size(), [&](std::size_t part) {
    next[part].resize(stretches_, 0);
    for_each_attached(
        part, [&](std::uint32_t simplex) { ++next[part][enters_[simplex] >> kStretchBits]; });
  });
  std::uint32_t first = 0;
  for (std::size_t stretch = 0; stretch < stretches_; ++stretch) {
    begins_.push_back(first);
    for (auto& of_part : next) first += std::exchange(of_part[stretch], first);
  }
  begins_.push_back(first);
  attached_.resize(first);
  parallel_for(threads_, next.size(), [&](std::size_t part) {
    for_each_attached(part, [&](std::uint32_t simplex) {
      const std::uint32_t index = enters_[simplex];
      attached_[next[part][index >> kStretchBits]++] = {
          {static_cast<std::uint16_t>(simplex), static_cast<std::uint16_t>(simplex >> 16U)},
          static_cast<std::uint16_t>(index & (kStretch - 1))};
    });
  });
}

// The place in the order of the first whose index is not before the stretch.
std::uint32_t FilterOrder::first_unattached(std::size_t stretch) const {
  const std::size_t rank = std::max<std::size_t>(kStretch * stretch, 1) - 1;  // indices from 1 on
  return rank < starts_.count() ? starts_.number_of(static_cast<std::uint32_t>(rank))
                                : static_cast<std::uint32_t>(order_.size());
}

void FilterOrder::fill_stretch(std::size_t stretch) {
  const auto first_index = static_cast<std::uint32_t>(kStretch * stretch);
  const std::uint32_t begin = first_unattached(stretch);
  const std::uint32_t end = first_unattached(stretch + 1);
  const std::span<const Attached> attached =
      std::span(attached_).subspan(begins_[stretch], begins_[stretch + 1] - begins_[stretch]);
  const auto index_before = starts_.rank(begin) - first_index;  // less than that of the first

  std::vector<std::uint32_t> ends(std::min(kStretch, starts_.count() + 1 - first_index), 0);
  for (const Attached& one : attached) ++ends[one.index];
  std::uint32_t index = index_before;
  for (std::uint32_t i = begin; i < end; ++i) {
    index += starts_.contains(i) ? 1U : 0U;
    ++ends[index];
  }
  std::uint32_t place = begins_[stretch] + begin;
  for (std::uint32_t& count : ends) {
    if (count != 0) set_start(place);
    place += std::exchange(count, place);
  }
  for (const Attached& one : attached) {
    filter_[ends[one.index]++] = SimplexId(std::uint32_t{one.simplex[1]} << 16U | one.simplex[0]);
  }
  index = index_before;
  bool is_shared = false;
  for (std::uint32_t i = begin; i < end; ++i) {
    const bool starts = starts_.contains(i);
    is_shared |= !starts;
    index += starts ? 1U : 0U;
    filter_[ends[index]++] = order_[i];
  }
  if (is_shared) merge_shared(begin, end, first_index, ends);
}

// At indices of several unattached simplices the attached ones before are merged with them.
void FilterOrder::merge_shared(std::size_t begin, std::size_t end, std::uint32_t first_index,
                               const std::vector<std::uint32_t>& ends) {
  for (std::size_t i = begin; i < end;) {
    std::size_t next = i + 1;
    while (next < end && !starts_.contains(static_cast<std::uint32_t>(next))) ++next;
    if (next - i > 1) {
      const std::uint32_t index = starts_.rank(static_cast<std::uint32_t>(i)) + 1 - first_index;
      SimplexId* const last = filter_.data() + ends[index];
      SimplexId* const middle = last - (next - i);
      SimplexId* const first =
          filter_.data() +
          (index == 0 ? begins_[first_index >> kStretchBits] + begin : ends[index - 1]);
      if (first != middle && *middle < *(middle - 1)) std::inplace_merge(first, middle, last);
    }
    i = next;
  }
}

}  // namespace

std::vector<std::uint64_t> fill_filter(std::span<const SimplexId> order, const RankedBits& starts,
                                       std::span<const std::uint32_t> enters,
                                       std::span<const std::uint64_t> is_attached, Threads threads,
                                       std::span<SimplexId> filter) {
  return FilterOrder(order, starts, enters, is_attached, threads, filter).fill();
}

}  // namespace orthoball
