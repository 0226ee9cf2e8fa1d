// SPDX-License-Identifier: MIT
#include "orthoball/weights/reweighted_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "orthoball/error.h"

namespace orthoball {
namespace {

__extension__ using Int128 = __int128;

constexpr double kLargestInteger = 9007199254740992.0;  // 2^53
constexpr double kLargestWeight = kLargestInteger * kLargestInteger;
constexpr int kMostDecimals = 400;

[[noreturn]] void refuse(std::size_t row) {
  throw LimitError("row " + std::to_string(row) +
                   ": the weight it would need is beyond the numbers that are held exactly");
}

// The weight of a row in the unit of the arrays squared.
Int128 exact_weight(const WeightedPoints& points, std::size_t row) {
  if (points.weight_kind() == WeightKind::none) return 0;
  const auto number = static_cast<Int128>(points.weights()[row]);
  if (points.weight_kind() == WeightKind::radius)
    return number < 0 ? -number * number : number * number;
  return number +
         (points.weights_low().empty() ? 0 : static_cast<Int128>(points.weights_low()[row]));
}

// The most decimals more, up to `more`, with which everything is still held exactly.
int fitting(const WeightedPoints& points, int more) {
  double largest = 1.0, largest_weight = 1.0;
  for (const double x : points.coordinates()) largest = std::max(largest, std::abs(x));
  for (std::size_t row = 0; row < points.weights().size(); ++row) {
    const double number = std::abs(points.weights()[row]);
    if (points.weight_kind() == WeightKind::radius) {
      largest = std::max(largest, number);
    } else {
      largest_weight = std::max(largest_weight, number);
    }
  }
  const auto fits = [&](int decimals) {
    const double factor = std::pow(10.0, decimals);
    return largest * factor <= kLargestInteger && largest_weight * factor * factor < kLargestWeight;
  };
  more = std::min(more, kMostDecimals - *points.decimals());
  while (more > 0 && !fits(more)) --more;
  return more;
}

Int128 power_of_ten(int exponent) {
  Int128 power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

WeightedPoints reweighted_decimals(const WeightedPoints& points, int more,
                                   std::span<const NewWeight> weights) {
  more = fitting(points, more);
  const double factor = std::pow(10.0, more);
  std::vector<double> coordinates(points.coordinates().begin(), points.coordinates().end());
  for (double& x : coordinates) x *= factor;
  std::vector<double> high(points.size()), low(points.size());
  const auto set = [&](std::size_t row, Int128 weight) {
    high[row] = static_cast<double>(weight);
    low[row] = static_cast<double>(weight - static_cast<Int128>(high[row]));
  };
  const Int128 square = power_of_ten(2 * more);
  for (std::size_t row = 0; row < points.size(); ++row)
    set(row, exact_weight(points, row) * square);
  for (const NewWeight& one : weights) {
    const double weight = std::nearbyint(one.weight * factor * factor);
    if (!(std::abs(weight) <= kLargestWeight)) refuse(one.row.row());
    set(one.row.row(), static_cast<Int128>(weight));
  }
  return WeightedPoints::fixed_point(points.dimension(), *points.decimals() + more,
                                     std::move(coordinates), WeightKind::weight, std::move(high),
                                     std::move(low));
}

std::vector<double> weights_of(const WeightedPoints& points) {
  if (points.weight_kind() == WeightKind::none) return std::vector<double>(points.size());
  return {points.weights().begin(), points.weights().end()};
}

}  // namespace

WeightedPoints reweighted(const WeightedPoints& points, int more,
                          std::span<const NewWeight> weights) {
  if (points.decimals()) return reweighted_decimals(points, more, weights);
  std::vector<double> numbers = weights_of(points);
  const bool are_radii = points.weight_kind() == WeightKind::radius;
  for (const NewWeight& one : weights) {
    if (!std::isfinite(one.weight)) refuse(one.row.row());
    numbers[one.row.row()] =
        are_radii ? std::copysign(std::sqrt(std::abs(one.weight)), one.weight) : one.weight;
  }
  return {points.dimension(),
          {points.coordinates().begin(), points.coordinates().end()},
          are_radii ? WeightKind::radius : WeightKind::weight,
          std::move(numbers)};
}

int decimals_for(const WeightedPoints& points, double step) {
  if (!points.decimals()) return 0;
  int more = 0;
  for (double unit = 1.0; unit > step && more < 15; unit /= 100.0) ++more;
  return fitting(points, more);
}

WeightedPoints with_more_rows(const WeightedPoints& points, int more,
                              std::span<const std::array<double, 3>> positions) {
  const auto axes = static_cast<std::size_t>(points.dimension());
  const WeightedPoints finer = points.decimals() ? reweighted_decimals(points, more, {}) : points;
  const double factor =
      points.decimals() ? std::pow(10.0, *finer.decimals() - *points.decimals()) : 1.0;
  std::vector<double> coordinates(finer.coordinates().begin(), finer.coordinates().end());
  for (const std::array<double, 3>& x : positions) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      coordinates.push_back(points.decimals() ? std::nearbyint(x[axis] * factor) : x[axis]);
    }
  }
  std::vector<double> weights = weights_of(finer);
  weights.resize(finer.size() + positions.size(), 0.0);
  if (!finer.decimals()) {
    const bool are_radii = finer.weight_kind() == WeightKind::radius;
    return {finer.dimension(), std::move(coordinates),
            are_radii ? WeightKind::radius : WeightKind::weight, std::move(weights)};
  }
  std::vector<double> low(finer.weights_low().begin(), finer.weights_low().end());
  low.resize(weights.size(), 0.0);
  return WeightedPoints::fixed_point(finer.dimension(), *finer.decimals(), std::move(coordinates),
                                     WeightKind::weight, std::move(weights), std::move(low));
}

}  // namespace orthoball
