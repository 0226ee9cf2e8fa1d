// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/exact/sites.h"

namespace orthoball::tuples {

/// All rows of `points` in their order.
template <int D>
[[nodiscard]] Sites<D> sites_of(const WeightedPoints& points) {
  std::vector<SiteId> rows;
  for (std::uint32_t row = 0; row < points.size(); ++row) rows.emplace_back(row);
  return Sites<D>(points, std::move(rows));
}

/// Sites from numbers written down, without weights.
template <int D>
[[nodiscard]] Sites<D> sites_at(std::vector<double> coordinates) {
  return sites_of<D>(WeightedPoints(D, std::move(coordinates), WeightKind::none, {}));
}

/// N different numbers below `count`.
template <std::size_t N>
[[nodiscard]] std::array<std::uint32_t, N> any_rows(generators::Random& random, std::size_t count) {
  std::array<std::uint32_t, N> rows{};
  for (std::size_t i = 0; i < N; ++i) {
    do {
      rows[i] = static_cast<std::uint32_t>(random.bits() % count);
    } while (std::find(rows.begin(), rows.begin() + i, rows[i]) != rows.begin() + i);
  }
  return rows;
}

/// Doubles nearest to random points of the unit sphere (circle).
[[nodiscard]] inline WeightedPoints on_sphere(int dimension, std::size_t count,
                                              std::uint64_t seed) {
  generators::Random random(seed);
  std::vector<double> coordinates;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 3> x{random.normal(), random.normal(),
                            dimension == 3 ? random.normal() : 0.0};
    const double length = std::hypot(x[0], x[1], x[2]);
    for (int axis = 0; axis < dimension; ++axis) {
      coordinates.push_back(x[static_cast<std::size_t>(axis)] / length);
    }
  }
  return {dimension, std::move(coordinates), WeightKind::none, {}};
}

}  // namespace orthoball::tuples
