// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/parallel.h"
#include "orthoball/places_of_parts.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// Indices of a spectrum are handled one stretch after the other: so many that what is kept of each
/// stays in the processor's caches, and that the position within one takes 12 bits.
inline constexpr unsigned kIndexStretchBits = 12;
inline constexpr std::uint32_t kIndexStretch = std::uint32_t{1} << kIndexStretchBits;

/// How often each index of a spectrum occurs in a list, asked for in ascending order.
///
/// Two bytes an occurrence: the list is dealt out by the upper bits of its indices, so that only
/// their lower bits need be kept, and counted one stretch of indices after the other in an array
/// that stays in the processor's caches. Linear time.
class IndexCounts {
 public:
  IndexCounts() = default;
  /// @param largest   no index is larger.
  /// @param for_each  for_each(visit) calls visit(index) for every element of the list, in the same
  ///                  order each of the two times it is called.
  template <class ForEach>
  IndexCounts(std::uint32_t largest, const ForEach& for_each)
      : IndexCounts(largest, 1, Threads(1),
                    [&](std::size_t, const auto& visit) { for_each(visit); }) {}
  /// The same of a list in parts: for_each(part, visit) for the elements of a part, from several
  /// threads at once.
  template <class ForEach>
  IndexCounts(std::uint32_t largest, std::size_t parts, Threads threads, const ForEach& for_each)
      : begins_((largest >> kIndexStretchBits) + 2, 0) {
    // [part][stretch]: how many, then where the next goes.
    std::vector<std::vector<std::uint32_t>> next(parts);
    parallel_for(threads, parts, [&](std::size_t part) {
      next[part].assign(begins_.size() - 1, 0);
      std::uint32_t* const counts = next[part].data();
      for_each(part, [&](std::uint32_t index) { ++counts[index >> kIndexStretchBits]; });
    });
    find_places_of_parts(next, begins_);
    lower_bits_.resize(begins_.back());
    parallel_for(threads, parts, [&](std::size_t part) {
      std::uint32_t* const places = next[part].data();
      std::uint16_t* const lower_bits = lower_bits_.data();
      for_each(part, [&](std::uint32_t index) {
        lower_bits[places[index >> kIndexStretchBits]++] =
            static_cast<std::uint16_t>(index & (kIndexStretch - 1));
      });
    });
  }

  /// Occurrences of `index`; calls must ascend.
  [[nodiscard]] std::uint32_t count(std::uint32_t index) {
    if (index >= end_) {
      counts_.resize(kIndexStretch);
      const std::uint32_t stretch = index >> kIndexStretchBits;
      count_stretch(stretch, counts_);
      end_ = (std::uint64_t{stretch} + 1) << kIndexStretchBits;
    }
    return counts_[index & (kIndexStretch - 1)];
  }

  /// Occurrences of all indices of a stretch, kIndexStretch of them from stretch * kIndexStretch;
  /// nothing beyond the largest.
  void count_stretch(std::uint32_t stretch, std::span<std::uint32_t> counts) const {
    std::fill(counts.begin(), counts.end(), 0U);
    if (stretch + std::size_t{1} >= begins_.size()) return;
    for (std::uint32_t i = begins_[stretch]; i < begins_[stretch + 1]; ++i) {
      ++counts[lower_bits_[i]];
    }
  }

 private:
  std::vector<std::uint32_t> begins_;    // [stretch of indices]: of its occurrences
  RawVector<std::uint16_t> lower_bits_;  // [occurrence] of its index
  std::vector<std::uint32_t> counts_;    // [lower bits], of the stretch before end_
  std::uint64_t end_ = 0;                // of the indices counted
};

/// Those of an array, in parts by several threads: get(i) for 0..size - 1.
template <class Get>
[[nodiscard]] IndexCounts index_counts(std::uint32_t largest, std::size_t size, Threads threads,
                                       const Get& get) {
  const std::size_t parts = threads.count();
  return {largest, parts, threads, [&](std::size_t part, const auto& visit) {
            const std::size_t end = size * (part + 1) / parts;
            for (std::size_t i = size * part / parts; i < end; ++i) visit(get(i));
          }};
}

}  // namespace orthoball
