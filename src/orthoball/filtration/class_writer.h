// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "orthoball/filtration/bit_run.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// Writes classes of simplices of equal value, ascending, to a stretch of the order of all.
class ClassWriter {
 public:
  /// @param order     where the simplices go.
  /// @param spectrum  where the value of each class goes.
  /// @param starts    bits of all simplices in the order, set for the first of each class.
  /// @param begin     where the stretch begins among these.
  ClassWriter(std::span<SimplexId> order, std::span<double> spectrum,
              std::span<std::uint64_t> starts, std::size_t begin)
      : order_(order.data()), spectrum_(spectrum.data()), starts_(starts.data(), begin) {}

  /// Simplices of one value.
  void add(std::span<const std::uint32_t> simplices, double label) {
    spectrum_[classes_++] = label + 0.0;  // a negative value that rounds to -0 reads 0
    bool is_first = true;
    for (const std::uint32_t simplex : simplices) {
      *order_++ = SimplexId(simplex);
      starts_.push(std::exchange(is_first, false));
    }
  }
  /// The same by several threads, as the last class.
  void add_last(std::span<const std::uint32_t> simplices, double label, Threads threads) {
    constexpr std::size_t kPart = std::size_t{1} << 16U;
    add(simplices.first(1), label);
    const auto others = simplices.subspan(1);
    parallel_parts(threads, others.size(), others.size() / kPart + 1,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) order_[i] = SimplexId(others[i]);
                   });
  }
  /// How many have been added.
  [[nodiscard]] std::size_t classes() const { return classes_; }

 private:
  SimplexId* order_;
  double* spectrum_;
  BitRun starts_;
  std::size_t classes_ = 0;
};

}  // namespace orthoball
