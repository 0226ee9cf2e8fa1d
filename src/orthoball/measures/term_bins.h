// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "orthoball/filtration/index_counts.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// Terms of N sums over a spectrum, dealt out to stretches of its indices (kIndexStretch of them).
///
/// Terms come in an order that suits their making; read stretch after stretch, those of one are
/// in that order and lie together: 8 N + 2 bytes each. Several parts of them may be dealt out at
/// the same time, each by one thread; parts are read one after the other, so that their number
/// does not show.
template <std::size_t N>
class TermBins {
 public:
  static constexpr std::size_t kBytes = N * sizeof(double) + sizeof(std::uint16_t);

  /// Empties the bins and makes room.
  /// @param first   the first stretch.
  /// @param counts  [part][stretch - first]: how many terms will come at most.
  void prepare(std::uint32_t first, const std::vector<std::span<const std::uint32_t>>& counts) {
    first_ = first;
    parts_ = counts.size();
    stretches_ = counts.front().size();
    begins_.resize(parts_ * stretches_);
    std::size_t size = 0;
    for (std::size_t stretch = 0; stretch < stretches_; ++stretch) {
      for (std::size_t part = 0; part < parts_; ++part) {
        begins_[part * stretches_ + stretch] = size;
        size += counts[part][stretch] * kBytes;
      }
    }
    if (size > bytes_.size()) {
      bytes_ = RawVector<std::byte>();  // not both at a time
      bytes_.resize(size);
    }
    ends_ = begins_;
  }

  /// Deals out terms of one part.
  class Dealer {
   public:
    Dealer(TermBins& bins, std::size_t part)
        : bytes_(bins.bytes_.data()),
          ends_(bins.ends_.data() + part * bins.stretches_),
          first_(bins.first_) {}
    /// To be called some terms ahead.
    void approach(std::uint32_t index) const {
      __builtin_prefetch(bytes_ + ends_[(index >> kIndexStretchBits) - first_] + kBytes, 1);
    }
    /// @param tag  0..15, given back with the term.
    /// @param values  points to N doubles.
    void deal(std::uint32_t index, unsigned tag, const void* values) {
      std::size_t& end = ends_[(index >> kIndexStretchBits) - first_];
      std::byte* to = bytes_ + end;
      end += kBytes;
      std::memcpy(to, values, N * sizeof(double));
      const auto place =
          static_cast<std::uint16_t>((index % kIndexStretch) | tag << kIndexStretchBits);
      std::memcpy(to + N * sizeof(double), &place, sizeof place);
    }

   private:
    std::byte* bytes_;
    std::size_t* ends_;
    std::uint32_t first_;
  };

  /// Calls `visit(place, tag, values)` for all terms of a stretch in order; `place` is the index
  /// within the stretch, `values` points to N doubles that need not be aligned.
  template <class Visit>
  [[gnu::always_inline]] void for_each(std::uint32_t stretch, const Visit& visit) const {
    for (std::size_t part = 0; part < parts_; ++part) {
      const std::size_t bin = part * stretches_ + (stretch - first_);
      const std::byte* end = bytes_.data() + ends_[bin];
      for (const std::byte* at = bytes_.data() + begins_[bin]; at != end; at += kBytes) {
        std::uint16_t place = 0;
        std::memcpy(&place, at + N * sizeof(double), sizeof place);
        visit(place % kIndexStretch, place >> kIndexStretchBits, at);
      }
    }
  }

 private:
  std::uint32_t first_ = 0;
  std::size_t parts_ = 0, stretches_ = 0;
  RawVector<std::byte> bytes_;
  std::vector<std::size_t> begins_, ends_;  // [part][stretch - first], in bytes_
};

}  // namespace orthoball
