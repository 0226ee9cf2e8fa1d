// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace orthoball {

/// Edges by number, ascending: a chain over Z/2.
using EdgeChain = std::vector<std::uint32_t>;

/// What is in one of two chains.
[[nodiscard]] inline EdgeChain sum(const EdgeChain& a, const EdgeChain& b) {
  EdgeChain result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// Whether an edge is in a chain.
[[nodiscard]] inline bool has(const EdgeChain& chain, std::uint32_t edge) {
  return std::binary_search(chain.begin(), chain.end(), edge);
}

/// Of numbers in any order, those that are there an odd number of times.
[[nodiscard]] inline EdgeChain sum_of(std::vector<std::uint32_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  std::size_t kept = 0;
  for (const std::uint32_t number : numbers) {
    if (kept > 0 && numbers[kept - 1] == number) {
      --kept;
    } else {
      numbers[kept++] = number;
    }
  }
  numbers.resize(kept);
  return numbers;
}

}  // namespace orthoball
