// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace orthoball::generators {

/// A small random number generator whose numbers are the same everywhere and always, unlike those
/// of the distributions in <random>.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15U + 0x632BE59BD9B4E019U) {
    bits();
  }

  /// 64 random bits: a counter of odd stride, its bits mixed.
  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
    return mixed ^ (mixed >> 31U);
  }
  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [low, high], both included.
  int integer(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(bits() % count);
  }
  /// Mean 0, variance 1, within [-6, 6]: a sum of twelve uniform numbers, without any libm.
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }
  bool coin() { return (bits() & 1U) != 0; }

 private:
  std::uint64_t state_;
};

}  // namespace orthoball::generators
