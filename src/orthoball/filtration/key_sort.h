// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace orthoball {

/// Sorts many lists of 64-bit keys with what belongs to each, one after the other.
///
/// Linear where keys are spread as numbers of one measurement are, and never worse than a few
/// passes. Keeps as much memory as the longest list so far.
class KeySorter {
 public:
  /// `rows[i]` stays beside its key; rows with equal keys keep their order.
  void sort(std::span<std::uint64_t> keys, std::span<std::uint32_t> rows);

 private:
  void distribute(std::span<std::uint64_t> keys, std::span<std::uint32_t> rows);

  std::vector<std::uint64_t> spare_keys_;
  std::vector<std::uint32_t> spare_rows_;
};

/// Sorts keys that are nearly in order already, and rows with them, stably: insertion.
void insert_in_order(std::span<std::uint64_t> keys, std::span<std::uint32_t> rows);

}  // namespace orthoball
