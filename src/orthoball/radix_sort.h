// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "orthoball/raw_vector.h"

namespace orthoball {

/// A row number with the 64-bit key it is sorted by.
struct KeyedRow {
  std::uint64_t key;
  std::uint32_t row;
};

/// Sorts by key, ascending and stably: least significant digits first, digits on which all keys
/// agree left out. O(n) time, O(n) extra memory.
inline void radix_sort(RawVector<KeyedRow>& rows) {
  constexpr unsigned kDigitBits = 11;
  constexpr std::size_t kDigits = 6;  // of 11 bits in 64
  constexpr std::size_t kValues = std::size_t{1} << kDigitBits;
  const auto digit = [](std::uint64_t key, std::size_t place) {
    return static_cast<std::size_t>(key >> (kDigitBits * place)) & (kValues - 1);
  };

  std::vector<std::array<std::size_t, kValues>> counts(kDigits);
  for (const KeyedRow& row : rows) {
    for (std::size_t place = 0; place < kDigits; ++place) ++counts[place][digit(row.key, place)];
  }
  RawVector<KeyedRow> sorted(rows.size());
  for (std::size_t place = 0; place < kDigits; ++place) {
    auto& next = counts[place];
    if (rows.empty() || next[digit(rows[0].key, place)] == rows.size()) continue;
    std::size_t first = 0;
    for (std::size_t& count : next) first += std::exchange(count, first);
    for (const KeyedRow& row : rows) sorted[next[digit(row.key, place)]++] = row;
    rows.swap(sorted);
  }
}

/// A 64-bit key that orders doubles as < does; -0 comes before 0. Not for NaN.
[[nodiscard]] inline std::uint64_t ordered_key(double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  const std::uint64_t sign = std::uint64_t{1} << 63U;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// The double that ordered_key made `key` of.
[[nodiscard]] inline double number_of_key(std::uint64_t key) {
  const std::uint64_t sign = std::uint64_t{1} << 63U;
  return std::bit_cast<double>((key & sign) != 0 ? key & ~sign : ~key);
}

}  // namespace orthoball
