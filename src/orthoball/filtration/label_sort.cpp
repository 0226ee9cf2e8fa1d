// SPDX-License-Identifier: MIT
//
// American flag sort: most significant digit first, in place. Digits begin at the highest bit in
// which the keys at hand differ, so common exponents cost one look and no pass; a bucket of a few
// is sorted by insertion. Memory is what this is for: tens of millions of labels are sorted beside
// everything else that a filtration holds.
//
// McIlroy, Bostic, McIlroy. Engineering radix sort. Computing Systems 6 (1993).
#include "orthoball/filtration/label_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "orthoball/radix_sort.h"

namespace orthoball {
namespace {

constexpr std::size_t kFew = 24;
constexpr int kMostDigitBits = 8;

void sort_few(std::span<double> labels, std::span<std::uint32_t> rows) {
  for (std::size_t i = 1; i < labels.size(); ++i) {
    const double label = labels[i];
    const std::uint32_t row = rows[i];
    const std::uint64_t key = ordered_key(label);
    std::size_t place = i;
    for (; place > 0 && key < ordered_key(labels[place - 1]); --place) {
      labels[place] = labels[place - 1];
      rows[place] = rows[place - 1];
    }
    labels[place] = label;
    rows[place] = row;
  }
}

// Bits in which any two keys differ.
std::uint64_t differing_bits(std::span<const double> labels) {
  const std::uint64_t first = ordered_key(labels[0]);
  std::uint64_t differing = 0;
  for (const double label : labels) differing |= ordered_key(label) ^ first;
  return differing;
}

}  // namespace

void sort_labels(std::span<double> labels, std::span<std::uint32_t> rows) {
  if (labels.size() <= kFew) return sort_few(labels, rows);
  const int top = static_cast<int>(std::bit_width(differing_bits(labels)));
  if (top == 0) return;
  // About eight labels a bucket where there are few.
  const int digit_bits =
      std::min({kMostDigitBits, top, static_cast<int>(std::bit_width(labels.size())) - 3});
  const int shift = top - digit_bits;
  const std::size_t mask = (std::size_t{1} << digit_bits) - 1;
  const auto digit = [&](double label) {
    return static_cast<std::size_t>(ordered_key(label) >> shift) & mask;
  };

  std::array<std::uint32_t, std::size_t{1} << kMostDigitBits> next{};
  std::array<std::uint32_t, std::size_t{1} << kMostDigitBits> end{};
  for (const double label : labels) ++end[digit(label)];
  std::uint32_t sum = 0;
  for (std::size_t value = 0; value <= mask; ++value) {
    next[value] = sum;
    sum += end[value];
    end[value] = sum;
  }
  // Every label that is put in its bucket puts out one that is not, until one comes home.
  for (std::size_t value = 0; value <= mask; ++value) {
    while (next[value] < end[value]) {
      const std::size_t hole = next[value];
      double label = labels[hole];
      std::uint32_t row = rows[hole];
      for (std::size_t to = digit(label); to != value; to = digit(label)) {
        const std::size_t place = next[to]++;
        std::swap(label, labels[place]);
        std::swap(row, rows[place]);
      }
      labels[hole] = label;
      rows[hole] = row;
      ++next[value];
    }
  }
  std::size_t begin = 0;
  for (std::size_t value = 0; value <= mask; ++value) {
    const std::size_t size = end[value] - begin;
    if (size > 1) sort_labels(labels.subspan(begin, size), rows.subspan(begin, size));
    begin = end[value];
  }
}

}  // namespace orthoball
