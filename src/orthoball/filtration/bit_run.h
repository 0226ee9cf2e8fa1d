// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace orthoball {

/// Writes bits one after the other into an array of words that are 0, 64 to a word, the lowest
/// first. Several may write into one array at the same time, each its own stretch of bits.
class BitRun {
 public:
  /// @param first  where the first bit goes, counted from the lowest bit of `words[0]`.
  BitRun(std::uint64_t* words, std::size_t first) : word_(words + first / 64), place_(first % 64) {}
  BitRun(const BitRun&) = delete;
  BitRun& operator=(const BitRun&) = delete;
  ~BitRun() {
    if (bits_ != 0) flush();
  }

  void push(bool bit) { push_if(true, bit); }
  /// Writes the bit if it `is_wanted`, without a branch.
  void push_if(bool is_wanted, bool bit) {
    bits_ |= std::uint64_t{is_wanted && bit} << place_;
    place_ += is_wanted ? 1 : 0;
    if (place_ == 64) {
      flush();
      ++word_;
      bits_ = 0;
      place_ = 0;
    }
  }

 private:
  // The first and the last word may be shared with neighbours.
  void flush() const { std::atomic_ref(*word_).fetch_or(bits_, std::memory_order_relaxed); }

  std::uint64_t* word_;
  std::uint64_t bits_ = 0;
  std::size_t place_;
};

/// The bit at a place of such an array.
[[nodiscard]] inline bool bit_at(const std::uint64_t* words, std::size_t place) {
  return (words[place / 64] >> place % 64 & 1U) != 0;
}

}  // namespace orthoball
