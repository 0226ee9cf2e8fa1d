// SPDX-License-Identifier: MIT
//
// Distribution by the place of each key between the least and the greatest, into about as many
// parts as there are keys; parts of more than a few again. Then every key is near its place and
// insertion finishes.
#include "orthoball/filtration/key_sort.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

namespace orthoball {
namespace {

constexpr std::size_t kFew = 24;
constexpr int kMostDigitBits = 12;

}  // namespace

void insert_in_order(std::span<std::uint64_t> keys, std::span<std::uint32_t> rows) {
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const std::uint64_t key = keys[i];
    if (keys[i - 1] <= key) continue;
    const std::uint32_t row = rows[i];
    std::size_t place = i;
    for (; place > 0 && key < keys[place - 1]; --place) {
      keys[place] = keys[place - 1];
      rows[place] = rows[place - 1];
    }
    keys[place] = key;
    rows[place] = row;
  }
}

void KeySorter::sort(std::span<std::uint64_t> keys, std::span<std::uint32_t> rows) {
  distribute(keys, rows);
  insert_in_order(keys, rows);
}

void KeySorter::distribute(std::span<std::uint64_t> keys, std::span<std::uint32_t> rows) {
  if (keys.size() <= kFew) return;
  std::uint64_t least = keys[0];
  std::uint64_t greatest = keys[0];
  for (const std::uint64_t key : keys) {
    least = std::min(least, key);
    greatest = std::max(greatest, key);
  }
  if (least == greatest) return;
  const auto range_bits = static_cast<int>(std::bit_width(greatest - least));
  const int shift = std::max(
      0, range_bits - std::min(kMostDigitBits, static_cast<int>(std::bit_width(keys.size()))));
  const auto digit = [&](std::uint64_t key) {
    return static_cast<std::size_t>((key - least) >> shift);
  };

  std::vector<std::uint32_t> next(digit(greatest) + 1, 0);
  for (const std::uint64_t key : keys) ++next[digit(key)];
  std::uint32_t first = 0;
  for (std::uint32_t& count : next) first += std::exchange(count, first);
  if (spare_keys_.size() < keys.size()) {
    spare_keys_.resize(keys.size());
    spare_rows_.resize(keys.size());
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::uint32_t place = next[digit(keys[i])]++;
    spare_keys_[place] = keys[i];
    spare_rows_[place] = rows[i];
  }
  std::copy_n(spare_keys_.begin(), keys.size(), keys.begin());
  std::copy_n(spare_rows_.begin(), rows.size(), rows.begin());
  if (shift == 0) return;
  std::size_t begin = 0;
  for (const std::uint32_t end : next) {
    const std::size_t size = end - begin;
    if (size > kFew) distribute(keys.subspan(begin, size), rows.subspan(begin, size));
    begin = end;
  }
}

}  // namespace orthoball
