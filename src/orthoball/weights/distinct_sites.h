// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/points/weighted_points.h"

namespace orthoball {

/// The distinct sites of points as doubles, in lexicographic order of position and then weight: so
/// what is made of them does not depend on the order of rows. In the unit of the points' arrays.
template <int D>
struct DistinctSites {
  explicit DistinctSites(const WeightedPoints& points);

  /// The largest squared distance between some of the sites.
  [[nodiscard]] double square_diameter(std::span<const std::uint32_t> some) const;

  std::vector<std::array<double, std::size_t{D}>> x;  ///< [site]
  std::vector<double> weight;                         ///< [site], correctly rounded
  std::vector<std::uint32_t> site_of_row;             ///< [row]
};

extern template struct DistinctSites<2>;  // defined in distinct_sites.cpp
extern template struct DistinctSites<3>;

}  // namespace orthoball
