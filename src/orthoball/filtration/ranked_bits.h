// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace orthoball {

/// A set of numbers below a fixed size that tells how many of them are less than a given one, and
/// so numbers its own elements. 12 bytes for 64 numbers; all questions in constant time.
class RankedBits {
 public:
  RankedBits() = default;
  /// Of no numbers; all that will be added are below `size`.
  explicit RankedBits(std::size_t size) : words_(size / 64 + 1, 0) {}
  /// Those whose bits are set, 64 to a word, the lowest first; no number is added to them.
  explicit RankedBits(std::vector<std::uint64_t> words) : words_(std::move(words)) { count_all(); }

  void add(std::uint32_t number) { words_[number / 64] |= std::uint64_t{1} << number % 64; }
  /// After the last `add`, before the first `rank`.
  /// @return how many numbers there are, if that is below 2^32.
  std::size_t count_all() {
    std::size_t sum = 0;
    before_.resize(words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) {
      before_[i] = static_cast<std::uint32_t>(sum);
      sum += ones(words_[i]);
    }
    return sum;
  }

  [[nodiscard]] bool contains(std::uint32_t number) const {
    return (words_[number / 64] >> number % 64 & 1U) != 0;
  }
  [[nodiscard]] std::size_t word_count() const { return words_.size(); }
  /// How many numbers there are, after count_all.
  [[nodiscard]] std::uint32_t count() const {
    return words_.empty() ? 0 : before_.back() + ones(words_.back());
  }
  /// How many of the numbers are less.
  [[nodiscard]] std::uint32_t rank(std::uint32_t number) const {
    const std::uint64_t below = (std::uint64_t{1} << number % 64) - 1;
    return before_[number / 64] + ones(words_[number / 64] & below);
  }
  /// Calls `visit(number)` for every number, ascending.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for_each(0, words_.size(), visit);
  }
  /// The same for the numbers from 64 * begin to 64 * end - 1.
  template <class Visit>
  void for_each(std::size_t begin, std::size_t end, const Visit& visit) const {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::uint64_t rest = words_[i]; rest != 0; rest &= rest - 1) {
        visit(static_cast<std::uint32_t>(64 * i) +
              static_cast<std::uint32_t>(std::countr_zero(rest)));
      }
    }
  }

 private:
  // Without an instruction that older machines lack.
  [[nodiscard]] static std::uint32_t ones(std::uint64_t word) {
    word -= word >> 1U & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + (word >> 2U & 0x3333333333333333U);
    word = (word + (word >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
    return static_cast<std::uint32_t>(word * 0x0101010101010101U >> 56U);
  }

  std::vector<std::uint64_t> words_;   // [number / 64]
  std::vector<std::uint32_t> before_;  // [number / 64]: how many numbers are in the words before
};

}  // namespace orthoball
