// SPDX-License-Identifier: MIT
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "orthoball/points/weighted_points.h"

namespace orthoball::peers {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The points of CGAL's type `Point`, weighted or not, each with its row.
template <class Point>
std::vector<std::pair<Point, std::uint32_t>> cgal_sites(const WeightedPoints& points) {
  std::vector<std::pair<Point, std::uint32_t>> sites;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double* x = points.coordinates().data();
    const double weight = points.weights().empty() ? 0.0 : points.weights()[row];
    const auto number = static_cast<std::uint32_t>(row);
    if constexpr (std::is_same_v<Point, Kernel::Point_2>) {
      sites.emplace_back(Point(x[2 * row], x[2 * row + 1]), number);
    } else if constexpr (std::is_same_v<Point, Kernel::Point_3>) {
      sites.emplace_back(Point(x[3 * row], x[3 * row + 1], x[3 * row + 2]), number);
    } else if constexpr (std::is_same_v<Point, Kernel::Weighted_point_2>) {
      sites.emplace_back(Point(Kernel::Point_2(x[2 * row], x[2 * row + 1]), weight), number);
    } else {
      const Kernel::Point_3 centre(x[3 * row], x[3 * row + 1], x[3 * row + 2]);
      sites.emplace_back(Point(centre, weight), number);
    }
  }
  return sites;
}

}  // namespace orthoball::peers
