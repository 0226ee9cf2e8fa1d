// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

#include "generators/point_families.h"

namespace orthoball::generators {

/// The arguments of one call of `points_of`, printed where a test fails.
struct Case {
  PointFamily family = PointFamily::uniform;
  int dimension = 3;
  std::size_t count = 0;
  std::uint64_t seed = 0;

  [[nodiscard]] WeightedPoints points() const { return points_of(family, dimension, count, seed); }
};
std::ostream& operator<<(std::ostream& stream, const Case& one);

/// Whether the environment asks for the long form of random tests: ORTHOBALL_LONG=1.
[[nodiscard]] bool is_long_run();

/// `seeds` cases of every family in both dimensions (ten times as many in a long run), with
/// `largest` sites at first, then any number in `smallest`..`largest`.
[[nodiscard]] std::vector<Case> cases(std::size_t seeds, std::size_t smallest, std::size_t largest);

}  // namespace orthoball::generators
