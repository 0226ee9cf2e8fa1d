// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "orthoball/points/weighted_points.h"
#include "python/arrays.h"

/// The coordinates of all sites in input units, (n, D); a view where they are doubles.
[[nodiscard]] inline Array<double> coordinate_array(const orthoball::WeightedPoints& points,
                                                    nb::handle owner) {
  const auto dimension = static_cast<std::size_t>(points.dimension());
  if (!points.decimals()) {
    return view<double>(points.coordinates(), owner, {points.size(), dimension});
  }
  std::vector<double> numbers;
  numbers.reserve(points.size() * dimension);
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (int axis = 0; axis < points.dimension(); ++axis) {
      numbers.push_back(points.coordinate(row, axis));
    }
  }
  return owned<double>(std::move(numbers), {points.size(), dimension});
}

/// What `of_row` gives for every site, (n,); None without weights.
template <class OfRow>
[[nodiscard]] nb::object weight_array(const orthoball::WeightedPoints& points,
                                      const OfRow& of_row) {
  if (points.weight_kind() == orthoball::WeightKind::none) return nb::none();
  std::vector<double> numbers(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) numbers[row] = of_row(row);
  return nb::cast(owned<double>(std::move(numbers)));
}

/// The weights of all sites in input units squared, or None.
[[nodiscard]] inline nb::object weights_of(const orthoball::WeightedPoints& points) {
  return weight_array(points, [&](std::size_t row) { return points.weight(row); });
}

/// Their signed roots, or None.
[[nodiscard]] inline nb::object radii_of(const orthoball::WeightedPoints& points) {
  return weight_array(points, [&](std::size_t row) { return points.radius(row); });
}
