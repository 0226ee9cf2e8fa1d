// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "orthoball/exact/orthoradius.h"
#include "orthoball/exact/sites.h"
#include "orthoball/filtration/bit_run.h"
#include "orthoball/filtration/simplex_reader.h"

namespace orthoball {

/// Calls `visit(simplex, label)` for the simplices of dimension K that are not attached, with the
/// correctly rounded squared orthoradius of each, in order.
///
/// @param is_attached  a bit for every simplex, 64 to a word.
/// @param begin, end   numbers among the simplices of dimension K.
template <int K, int D, int A, class Visit>
void for_each_label(const Sites<D>& sites, const SimplexReader<D, A>& reader,
                    std::span<const std::uint64_t> is_attached, std::uint32_t begin,
                    std::uint32_t end, const Visit& visit) {
  constexpr std::size_t kBlock = 256;
  const std::uint32_t first = reader.table.first(K);
  std::array<CornerSites<std::size_t{K} + 1>, kBlock> corners;
  std::array<std::uint32_t, kBlock> simplices;
  std::array<double, kBlock> labels;
  std::size_t size = 0;
  const auto flush = [&] {
    squared_orthoradii<D, std::size_t{K} + 1>(sites, std::span(corners).first(size), labels);
    for (std::size_t i = 0; i < size; ++i) visit(simplices[i], labels[i]);
    size = 0;
  };
  for (std::uint32_t number = begin; number < end; ++number) {
    // What is attached is written over by the next: whether it is is hard to foretell.
    simplices[size] = first + number;
    corners[size] = reader.template corners<K>(number);
    size += bit_at(is_attached.data(), first + number) ? 0U : 1U;
    if (size == kBlock) flush();
  }
  flush();
}

}  // namespace orthoball
