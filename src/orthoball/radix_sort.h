// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "orthoball/parallel.h"
#include "orthoball/places_of_parts.h"
#include "orthoball/raw_vector.h"

namespace orthoball {

/// A row number with the 64-bit key it is sorted by.
struct KeyedRow {
  std::uint64_t key;
  std::uint32_t row;
};

namespace radix_sort_detail {

inline constexpr unsigned kDigitBits = 11;
inline constexpr std::size_t kDigits = 3;  // sorted by at a time

// Sorts a few by inserting one after the other.
inline void insertion_sort(std::span<KeyedRow> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const KeyedRow row = rows[i];
    std::size_t to = i;
    for (; to > 0 && row.key < rows[to - 1].key; --to) rows[to] = rows[to - 1];
    rows[to] = row;
  }
}

// `spare` is as long as `rows`.
inline void sort(std::span<KeyedRow> rows, std::span<KeyedRow> spare) {
  constexpr std::size_t kFew = 24;
  if (rows.size() <= kFew) return insertion_sort(rows);
  constexpr std::size_t kMany = 1024;  // for which the counts below pay
  if (rows.size() < kMany) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const KeyedRow& a, const KeyedRow& b) { return a.key < b.key; });
    return;
  }
  std::uint64_t differences = 0;
  for (const KeyedRow& row : rows) differences |= row.key ^ rows[0].key;
  const auto top = static_cast<unsigned>(std::bit_width(differences));
  constexpr unsigned kBits = kDigitBits * kDigits;
  const unsigned low = top > kBits ? top - kBits : 0;  // bits below do not matter yet

  constexpr std::size_t kValues = std::size_t{1} << kDigitBits;
  const auto digit = [&](const KeyedRow& row, std::size_t place) {
    return static_cast<std::size_t>(row.key >> (low + kDigitBits * place)) & (kValues - 1);
  };
  std::vector<std::array<std::uint32_t, kValues>> counts(kDigits);
  for (const KeyedRow& row : rows) {
    for (std::size_t place = 0; place < kDigits; ++place) ++counts[place][digit(row, place)];
  }
  std::span<KeyedRow> from = rows, to = spare;
  for (std::size_t place = 0; place < kDigits; ++place) {
    auto& next = counts[place];
    if (next[digit(rows[0], place)] == rows.size()) continue;
    std::uint32_t first = 0;
    for (std::uint32_t& count : next) first += std::exchange(count, first);
    for (const KeyedRow& row : from) to[next[digit(row, place)]++] = row;
    std::swap(from, to);
  }
  if (from.data() != rows.data()) std::copy(from.begin(), from.end(), rows.begin());
  if (low == 0) return;
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin + 1;
    while (end < rows.size() && rows[end].key >> low == rows[begin].key >> low) ++end;
    if (end - begin > 1) {
      sort(rows.subspan(begin, end - begin), spare.subspan(begin, end - begin));
    }
    begin = end;
  }
}

// The same on several threads: deals the rows to ranges of keys, by the highest bits in which keys
// differ, and sorts the ranges side by side.
inline void sort_in_ranges(std::span<KeyedRow> rows, std::span<KeyedRow> spare, Threads threads) {
  const std::size_t parts = threads.count();
  std::vector<std::uint64_t> differences(parts, 0);
  parallel_parts(threads, rows.size(), parts,
                 [&](std::size_t part, std::size_t begin, std::size_t end) {
                   std::uint64_t of_part = 0;
                   for (std::size_t i = begin; i < end; ++i) of_part |= rows[i].key ^ rows[0].key;
                   differences[part] = of_part;
                 });
  std::uint64_t all = 0;
  for (const std::uint64_t of_part : differences) all |= of_part;
  const auto top = static_cast<unsigned>(std::bit_width(all));
  // Ranges of some thousand rows, which the caches hold.
  const unsigned bits =
      std::min({static_cast<unsigned>(std::bit_width(rows.size() >> 12U)), kDigitBits, top});
  const std::size_t ranges = std::size_t{1} << bits;
  const auto range_of = [&](const KeyedRow& row) {
    return bits == 0 ? 0 : static_cast<std::size_t>(row.key >> (top - bits)) & (ranges - 1);
  };

  // [part][range]: how many rows, then where the next goes.
  std::vector<std::vector<std::uint32_t>> next(parts, std::vector<std::uint32_t>(ranges, 0));
  parallel_parts(threads, rows.size(), parts,
                 [&](std::size_t part, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) ++next[part][range_of(rows[i])];
                 });
  std::vector<std::uint32_t> begins(ranges + 1, 0);
  find_places_of_parts(next, begins);
  parallel_parts(threads, rows.size(), parts,
                 [&](std::size_t part, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     spare[next[part][range_of(rows[i])]++] = rows[i];
                   }
                 });
  parallel_for(threads, ranges, [&](std::size_t range) {
    const std::size_t begin = begins[range], count = begins[range + 1] - begin;
    sort(spare.subspan(begin, count), rows.subspan(begin, count));
    std::copy_n(spare.begin() + static_cast<std::ptrdiff_t>(begin), count,
                rows.begin() + static_cast<std::ptrdiff_t>(begin));
  });
}

}  // namespace radix_sort_detail

/// Sorts fewer than 2^32 rows by key, ascending and stably: by the 33 highest bits in which keys
/// differ, least significant digits first, then runs of those that agree in these likewise. Several
/// threads first deal rows to ranges by the highest bits of all, so keys that crowd in one range
/// are sorted by one thread; the result is the same. O(n) time, O(n) extra memory.
inline void radix_sort(RawVector<KeyedRow>& rows, Threads threads = Threads(1)) {
  RawVector<KeyedRow> spare(rows.size());
  threads = threads.for_work(rows.size(), 1U << 14U);
  if (threads.count() == 1) return radix_sort_detail::sort(rows, spare);
  radix_sort_detail::sort_in_ranges(rows, spare, threads);
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
