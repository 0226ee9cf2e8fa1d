// SPDX-License-Identifier: MIT
#include "orthoball/points/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/error.h"

namespace orthoball {
namespace {

constexpr double kLargestInteger = 9007199254740992.0;  // 2^53
constexpr int kMostDigits = 15;                         // 10^16 is beyond it

void check_probe(double radius) {
  if (radius >= 0.0 && std::isfinite(radius)) return;
  throw InputError(
      InputError::Reason::wrong_argument, InputError::kNoRow,
      fmt::format("the radius of the probe is {}; it must be 0 or more, and finite", radius));
}

void check_balls(const WeightedPoints& points) {
  const auto weights = points.weights();
  const auto at = std::find_if(weights.begin(), weights.end(), [](double w) { return w < 0.0; });
  if (at == weights.end()) return;
  const auto row = static_cast<std::size_t>(at - weights.begin());
  const bool is_radius = points.weight_kind() == WeightKind::radius;
  const char* const what = is_radius ? "radius" : "weight";
  throw InputError(
      InputError::Reason::imaginary_ball, row,
      fmt::format("row {}: {} is {}, an imaginary ball; with a probe every {} must be "
                  "0 or more",
                  row, what, is_radius ? points.radius(row) : points.weight(row), what));
}

// Multiplies all by 10^power; false where one is then beyond 2^53. Products beyond are even: none
// is rounded down to 2^53.
bool scale(std::vector<double>& integers, int power) {
  if (power == 0) return true;
  const double factor = std::pow(10.0, std::min(power, kMostDigits + 1));
  for (double& integer : integers) {
    integer *= factor;
    if (std::abs(integer) > kLargestInteger) return false;
  }
  return true;
}

// Whether all are multiples of ten; then they become a tenth.
bool shorten(std::vector<double>& coordinates, std::vector<double>& radii) {
  for (const auto* const integers : {&coordinates, &radii}) {
    for (const double integer : *integers) {
      if (static_cast<std::int64_t>(integer) % 10 != 0) return false;
    }
  }
  for (auto* const integers : {&coordinates, &radii}) {
    for (double& integer : *integers) integer /= 10.0;
  }
  return true;
}

// Empty where the result is not decimal fixed point.
std::optional<WeightedPoints> as_decimals(const WeightedPoints& points, const ProbeRadius& probe) {
  if (!points.decimals() || !probe.digits || points.weight_kind() == WeightKind::weight) {
    return std::nullopt;
  }
  int decimals = std::max(*points.decimals(), probe.decimals);
  const auto copy = [](std::span<const double> numbers) {
    return std::vector<double>(numbers.begin(), numbers.end());
  };
  std::vector<double> coordinates = copy(points.coordinates()), radii = copy(points.weights());
  std::vector<double> grown_by{static_cast<double>(*probe.digits)};
  if (!scale(coordinates, decimals - *points.decimals()) ||
      !scale(radii, decimals - *points.decimals()) || !scale(grown_by, decimals - probe.decimals)) {
    return std::nullopt;
  }
  radii.resize(points.size(), 0.0);  // where there were none
  for (double& radius : radii) {
    if (radius > kLargestInteger - grown_by[0]) return std::nullopt;
    radius += grown_by[0];
  }
  // As a reader of the sums would have it: no more decimals than they need.
  while (decimals > 0 && shorten(coordinates, radii)) --decimals;
  return WeightedPoints::fixed_point(points.dimension(), decimals, std::move(coordinates),
                                     WeightKind::radius, std::move(radii));
}

WeightedPoints as_doubles(const WeightedPoints& points, double probe) {
  std::vector<double> coordinates, radii;
  coordinates.reserve(points.coordinates().size());
  radii.reserve(points.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (int axis = 0; axis < points.dimension(); ++axis) {
      coordinates.push_back(points.coordinate(row, axis));
    }
    radii.push_back(points.radius(row) + probe);
  }
  return {points.dimension(), std::move(coordinates), WeightKind::radius, std::move(radii)};
}

}  // namespace

WeightedPoints with_probe(const WeightedPoints& points, const ProbeRadius& probe) {
  check_probe(probe.nearest);
  if (probe.nearest == 0.0) return points;
  check_balls(points);
  if (auto exact = as_decimals(points, probe)) return *std::move(exact);
  return as_doubles(points, probe.nearest);
}

}  // namespace orthoball
