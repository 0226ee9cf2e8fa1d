// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "orthoball/filtration/filtration.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball::matchers {

/// 64 bits that stand for a long list of numbers, bit by bit.
class Digest {
 public:
  void add(std::uint64_t number);
  void add(double number);
  /// Numbers whose order does not matter.
  void add_to_set(const Digest& of_one) { set_ += of_one.value(); }
  [[nodiscard]] std::uint64_t value() const;
  /// 16 hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t state_ = 0x243F6A8885A308D3ULL;
  std::uint64_t set_ = 0;
};

/// Of vertices by their coordinates and weights, of cells, hidden sites and duplicates. Rows do not
/// count, so that a shuffled input has the digest of the original.
/// @param points  what the triangulation was made of.
template <int D>
[[nodiscard]] Digest digest(const RegularTriangulation<D>& triangulation,
                            const WeightedPoints& points);
/// Of the spectrum, the filter, and what every simplex is and when.
template <int D>
[[nodiscard]] Digest digest(const Filtration<D>& filtration, Threads threads = {});
/// Of all signatures at all indices.
template <int D>
[[nodiscard]] Digest signatures_digest(const Filtration<D>& filtration, Threads threads = {});

/// Of the union of balls at the middle of the spectrum, with every ball's part, its voids and
/// pockets.
template <int D>
[[nodiscard]] Digest balls_digest(const Filtration<D>& filtration, Threads threads = {});

}  // namespace orthoball::matchers
