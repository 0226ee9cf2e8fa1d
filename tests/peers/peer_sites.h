// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball::peers {

/// The rows of a simplex, ascending: what a simplex is called on both sides.
using Rows = std::vector<std::uint32_t>;

/// What every peer can take: the same numbers as doubles in no unit, radii as weights (rounded
/// once, here, for both sides), and no row equal to another.
inline WeightedPoints for_peers(const WeightedPoints& points) {
  const auto dimension = static_cast<std::size_t>(points.dimension());
  std::vector<double> coordinates, weights;
  std::set<std::array<double, 4>> known;
  for (std::size_t row = 0; row < points.size(); ++row) {
    std::array<double, 4> site{};
    const double* x = points.coordinates().data() + dimension * row;
    std::copy_n(x, dimension, site.begin());
    if (points.weight_kind() != WeightKind::none) site[3] = points.weights()[row];
    if (points.weight_kind() == WeightKind::radius) site[3] *= std::abs(site[3]);
    if (!known.insert(site).second) continue;
    coordinates.insert(coordinates.end(), x, x + dimension);
    if (points.weight_kind() != WeightKind::none) weights.push_back(site[3]);
  }
  const WeightKind kind = weights.empty() ? WeightKind::none : WeightKind::weight;
  return {points.dimension(), std::move(coordinates), kind, std::move(weights)};
}

inline bool has_weights(const WeightedPoints& points) {
  return points.weight_kind() != WeightKind::none;
}

/// Families whose sites are in general position, but for chances that no seed here has.
inline constexpr std::array kGenericFamilies{
    generators::PointFamily::uniform, generators::PointFamily::uniform_balls,
    generators::PointFamily::gaussian, generators::PointFamily::scan_like};

/// Calls `check` with the sites of `seeds` cases of every family whose numbers peers can take.
template <class Check>
void for_each_family(int dimension, std::size_t count, std::uint64_t seeds, const Check& check) {
  for (const generators::PointFamily family : generators::point_families()) {
    if (is_extreme(family)) continue;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << dimension << "D, seed " << seed);
      check(for_peers(generators::points_of(family, dimension, count, seed)));
    }
  }
}

/// The same with the families in general position only.
template <class Check>
void for_each_generic_family(int dimension, std::size_t count, std::uint64_t seeds,
                             const Check& check) {
  for (const generators::PointFamily family : kGenericFamilies) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << dimension << "D, seed " << seed);
      check(for_peers(generators::points_of(family, dimension, count, seed)));
    }
  }
}

template <int D>
std::set<Rows> cells_by_rows(const RegularTriangulation<D>& triangulation) {
  std::set<Rows> cells;
  for (const CellRecord<D>& cell : triangulation.template cells<D>()) {
    Rows rows;
    for (const std::uint32_t vertex : cell.corners) {
      rows.push_back(triangulation.sites().row(vertex).row());
    }
    std::sort(rows.begin(), rows.end());
    cells.insert(std::move(rows));
  }
  return cells;
}

template <int D>
std::map<Rows, SimplexId> simplices_by_rows(const Filtration<D>& filtration) {
  std::map<Rows, SimplexId> simplices;
  for (std::uint32_t number = 0; number < filtration.size(); ++number) {
    Rows rows;
    for (const SiteId row : filtration.rows(SimplexId(number))) rows.push_back(row.row());
    simplices.emplace(std::move(rows), SimplexId(number));
  }
  return simplices;
}

}  // namespace orthoball::peers
