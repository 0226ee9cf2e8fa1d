// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace orthoball {

/// Writes to `selected`, after making room, the numbers i in begin..end - 1, ascending, for which
/// first <= enters[i] < first + length and bit i of `wanted` is set; all are wanted if it is empty.
/// Without branches: which these are is hard to foretell.
/// @return how many.
std::size_t select_in_window(std::span<const std::uint32_t> enters, std::uint32_t begin,
                             std::uint32_t end, std::uint32_t first, std::uint32_t length,
                             std::span<const std::uint64_t> wanted,
                             std::vector<std::uint32_t>& selected);

}  // namespace orthoball
