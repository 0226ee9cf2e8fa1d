// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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
      : begins_((largest >> kIndexStretchBits) + 2, 0) {
    for_each([&](std::uint32_t index) { ++begins_[(index >> kIndexStretchBits) + 1]; });
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    lower_bits_.resize(begins_.back());
    std::vector<std::uint32_t> next = begins_;
    for_each([&](std::uint32_t index) {
      lower_bits_[next[index >> kIndexStretchBits]++] =
          static_cast<std::uint16_t>(index & (kIndexStretch - 1));
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

}  // namespace orthoball
