// SPDX-License-Identifier: MIT
#include "cli/query_memory.h"

#include "orthoball/memory_budget.h"

namespace {

// Bytes for each simplex, in space and in the plane.
struct PerSimplex {
  std::uint64_t space, plane;
  [[nodiscard]] std::uint64_t of(int dimension, std::size_t simplices) const {
    return (dimension == 2 ? plane : space) * simplices;
  }
};
constexpr PerSimplex kCandidates{34, 52};
// Random points take 26 and 36, scans of which nearly every vertex offends 37.
constexpr PerSimplex kManifold{38, 44};
constexpr PerSimplex kLocate{24, 36};
// In space random points take 42; lattices that are shaken a little, whose cycles are long, 100.
constexpr PerSimplex kRepresentatives{100, 34};
constexpr std::uint64_t kLocated = 200;  // each point

}  // namespace

std::uint64_t candidates_memory(int dimension, std::size_t simplices) {
  return kCandidates.of(dimension, simplices);
}

std::uint64_t resamples_memory(int dimension, std::size_t sites, std::size_t simplices) {
  return orthoball::alpha_shapes_memory(dimension, sites / 5 * 4) +
         candidates_memory(dimension, simplices / 5 * 4);
}

std::uint64_t manifold_memory(int dimension, std::size_t simplices) {
  return kManifold.of(dimension, simplices);
}

std::uint64_t locate_memory(int dimension, std::size_t simplices, std::size_t points) {
  return kLocate.of(dimension, simplices) + kLocated * points;
}

std::uint64_t representatives_memory(int dimension, std::size_t simplices) {
  return kRepresentatives.of(dimension, simplices);
}
