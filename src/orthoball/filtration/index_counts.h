// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orthoball {

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
      : begins_((largest >> kStretchBits) + 2, 0) {
    for_each([&](std::uint32_t index) { ++begins_[(index >> kStretchBits) + 1]; });
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    lower_bits_.resize(begins_.back());
    std::vector<std::uint32_t> next = begins_;
    for_each([&](std::uint32_t index) {
      lower_bits_[next[index >> kStretchBits]++] =
          static_cast<std::uint16_t>(index & (kStretch - 1));
    });
    counts_.resize(kStretch);
  }

  /// Occurrences of `index`; calls must ascend.
  [[nodiscard]] std::uint32_t count(std::uint32_t index) {
    if (index >= end_) count_stretch(index >> kStretchBits);
    return counts_[index & (kStretch - 1)];
  }

 private:
  static constexpr unsigned kStretchBits = 14;
  static constexpr std::uint32_t kStretch = std::uint32_t{1} << kStretchBits;

  void count_stretch(std::uint32_t stretch) {
    std::fill(counts_.begin(), counts_.end(), 0U);
    for (std::uint32_t i = begins_[stretch]; i < begins_[stretch + 1]; ++i) {
      ++counts_[lower_bits_[i]];
    }
    end_ = (std::uint64_t{stretch} + 1) << kStretchBits;
  }

  std::vector<std::uint32_t> begins_;      // [stretch of indices]: of its occurrences
  std::vector<std::uint16_t> lower_bits_;  // [occurrence] of its index
  std::vector<std::uint32_t> counts_;      // [lower bits], of the stretch before end_
  std::uint64_t end_ = 0;                  // of the indices counted
};

}  // namespace orthoball
