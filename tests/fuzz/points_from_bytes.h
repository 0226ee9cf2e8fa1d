// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/points/weighted_points.h"

namespace orthoball::fuzz {

/// Sites with small integer coordinates and weights: degenerate on purpose. The first byte says how
/// small they are and what the weights mean; then D + 1 bytes a site, at most 200 sites.
template <int D>
[[nodiscard]] WeightedPoints lattice_points_from_bytes(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return WeightedPoints(D);
  constexpr int kSides[] = {2, 3, 5, 16, 256};
  const int side = kSides[bytes[0] % 5];
  const auto kind = static_cast<WeightKind>(bytes[0] / 5 % 3);
  std::vector<double> coordinates, weights;
  constexpr std::size_t kSite = std::size_t{D} + 1;
  for (std::size_t at = 1; at + D < bytes.size() && at < 200 * kSite; at += kSite) {
    for (std::size_t axis = 0; axis < D; ++axis) coordinates.push_back(bytes[at + axis] % side);
    if (kind != WeightKind::none) {
      weights.push_back(static_cast<std::int8_t>(bytes[at + D]) % side);
    }
  }
  return {D, coordinates, kind, weights};
}

/// Sites whose numbers are the bytes as doubles, less those that are not finite: 8 (D + 1) bytes a
/// site after the first, which says what the weights mean; at most 24 sites.
template <int D>
[[nodiscard]] WeightedPoints double_points_from_bytes(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return WeightedPoints(D);
  const auto kind = static_cast<WeightKind>(bytes[0] % 3);
  std::vector<double> coordinates, weights;
  constexpr std::size_t kNumbers = std::size_t{D} + 1;
  constexpr std::size_t kSite = sizeof(double) * kNumbers;
  for (std::size_t at = 1; at + kSite <= bytes.size() && at < 24 * kSite; at += kSite) {
    double numbers[kNumbers];
    std::memcpy(numbers, bytes.data() + at, kSite);
    if (!std::all_of(numbers, numbers + kNumbers, [](double x) { return std::isfinite(x); }))
      continue;
    coordinates.insert(coordinates.end(), numbers, numbers + D);
    if (kind != WeightKind::none) weights.push_back(numbers[D]);
  }
  return {D, coordinates, kind, weights};
}

/// Prints the faults, if there are any, and stops the program.
inline void require_none(const std::vector<std::string>& faults) {
  if (faults.empty()) return;
  for (const std::string& fault : faults) std::cerr << fault << '\n';
  __builtin_trap();
}
inline void require(bool holds, const char* what) {
  if (!holds) require_none({what});
}

}  // namespace orthoball::fuzz
