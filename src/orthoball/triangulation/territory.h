// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace orthoball {

/// The vertices begin..end - 1, and those that many threads at work have in common: the one at
/// infinity. A thread changes only cells that have all their corners in its territory.
///
/// Two cells that share a facet share a finite corner in any territory that one of them lies in, so
/// no other thread owns the neighbour of a thread's cell, or the cell behind it: a thread may read
/// the neighbours of its cells and write where they point to itself, without locks.
struct Territory {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t infinity;

  [[nodiscard]] bool has(std::uint32_t vertex) const {
    return vertex - begin < end - begin || vertex == infinity;
  }
};

}  // namespace orthoball
