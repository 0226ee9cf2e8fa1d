// SPDX-License-Identifier: MIT
#include "orthoball/points/weighted_points.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "orthoball/error.h"

namespace orthoball {
namespace {

constexpr double kLargestInteger = 9007199254740992.0;  // 2^53
constexpr int kMostDecimals = 400;                      // beyond the last digit of any double

void check_sizes(int dimension, std::size_t coordinates, WeightKind kind, std::size_t weights) {
  const auto fail = [](const std::string& message) {
    throw InputError(InputError::Reason::wrong_size, InputError::kNoRow, message);
  };
  if (dimension != 2 && dimension != 3) {
    fail("dimension is " + std::to_string(dimension) + "; it must be 2 or 3");
  }
  const auto axes = static_cast<std::size_t>(dimension);
  if (coordinates % axes != 0) {
    fail(std::to_string(coordinates) + " coordinates do not make rows of " +
         std::to_string(dimension));
  }
  const std::size_t rows = coordinates / axes;
  const std::size_t expected = kind == WeightKind::none ? 0 : rows;
  if (weights != expected) {
    fail(std::to_string(weights) + " weights for " + std::to_string(rows) +
         " points; there must be " + std::to_string(expected));
  }
  if (rows >= std::numeric_limits<std::uint32_t>::max() - 1) {
    throw LimitError(std::to_string(rows) + " sites; at most 2^32 - 3 can be numbered");
  }
}

// Without a way out of its loop, so that it becomes vector code; the row at fault is looked for
// afterwards.
bool are_finite(std::span<const double> numbers) {
  constexpr std::uint64_t kExponent = 0x7FF0000000000000U;  // all ones: not finite
  bool are_finite = true;
  for (const double number : numbers) {
    are_finite &= (std::bit_cast<std::uint64_t>(number) & kExponent) != kExponent;
  }
  return are_finite;
}

bool is_integer(double number) {
  return std::abs(number) >= kLargestInteger ||
         number == static_cast<double>(static_cast<std::int64_t>(number));
}

void check_finite(std::span<const double> numbers, std::size_t per_row, const char* what) {
  if (are_finite(numbers)) return;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i])) continue;
    const std::size_t row = i / per_row;
    throw InputError(InputError::Reason::not_finite, row,
                     "row " + std::to_string(row) + ": " + what + " is " +
                         (std::isnan(numbers[i]) ? "NaN" : "infinite") + "; it must be finite");
  }
}

void check_integers(std::span<const double> numbers, std::size_t per_row, double largest) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::abs(numbers[i]) <= largest && is_integer(numbers[i])) continue;
    const std::size_t row = i / per_row;
    throw InputError(InputError::Reason::wrong_argument, row,
                     "row " + std::to_string(row) +
                         ": a fixed-point number must be an integer within its range");
  }
}

// Two doubles stand for a number in one way only: the first is the nearest double to it.
void check_low_parts(std::span<const double> weights, std::span<const double> low) {
  for (std::size_t row = 0; row < low.size(); ++row) {
    if (weights[row] + low[row] == weights[row]) continue;
    throw InputError(InputError::Reason::wrong_argument, row,
                     "row " + std::to_string(row) +
                         ": the low part of a weight must be at most half an ulp of the high one");
  }
}

}  // namespace

WeightedPoints::WeightedPoints(int dimension, std::vector<double> coordinates, WeightKind kind,
                               std::vector<double> weights)
    : dimension_(dimension), kind_(kind) {
  check_sizes(dimension, coordinates.size(), kind, weights.size());
  check_finite(coordinates, static_cast<std::size_t>(dimension), "a coordinate");
  check_finite(weights, 1, kind == WeightKind::radius ? "radius" : "weight");
  coordinates_ = std::move(coordinates);
  weights_ = std::move(weights);
}

WeightedPoints WeightedPoints::fixed_point(int dimension, int decimals,
                                           std::vector<double> coordinates, WeightKind kind,
                                           std::vector<double> weights,
                                           std::vector<double> weights_low) {
  if (decimals < 0 || decimals > kMostDecimals) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     std::to_string(decimals) + " decimals; there must be 0 to 400");
  }
  if (!weights_low.empty() &&
      (kind != WeightKind::weight || weights_low.size() != weights.size())) {
    throw InputError(InputError::Reason::wrong_size, InputError::kNoRow,
                     "low parts of weights must be as many as the weights, or none");
  }
  WeightedPoints points(dimension, std::move(coordinates), kind, std::move(weights));
  const auto axes = static_cast<std::size_t>(dimension);
  check_integers(points.coordinates_, axes, kLargestInteger);
  check_integers(points.weights_, 1,
                 kind == WeightKind::radius ? kLargestInteger : kLargestInteger * kLargestInteger);
  check_integers(weights_low, 1, kLargestInteger);
  check_low_parts(points.weights_, weights_low);
  points.decimals_ = decimals;
  points.weights_low_ = std::move(weights_low);
  return points;
}

double WeightedPoints::in_input_units(double number) const {
  if (!decimals_ || *decimals_ == 0) return number;
  // An integer below 2^53 over a power of ten up to 10^22: both exact, so one rounding.
  if (*decimals_ <= 22) return number / std::pow(10.0, *decimals_);
  const std::string text = std::to_string(static_cast<long long>(number));
  return std::strtod((text + "e-" + std::to_string(*decimals_)).c_str(), nullptr);
}

double WeightedPoints::coordinate(std::size_t row, int axis) const {
  return in_input_units(
      coordinates_[static_cast<std::size_t>(dimension_) * row + static_cast<std::size_t>(axis)]);
}

double WeightedPoints::weight(std::size_t row) const {
  if (kind_ == WeightKind::none) return 0.0;
  const double number = weights_[row];
  const int decimals = decimals_.value_or(0);
  const double value = kind_ == WeightKind::radius ? number * std::abs(number) : number;
  return decimals == 0 ? value : value / std::pow(10.0, decimals) / std::pow(10.0, decimals);
}

double WeightedPoints::radius(std::size_t row) const {
  if (kind_ == WeightKind::radius) return in_input_units(weights_[row]);
  const double squared = weight(row);
  return std::copysign(std::sqrt(std::abs(squared)), squared);
}

std::optional<double> ball_radius(const WeightedPoints& points, std::size_t row, double alpha2) {
  const double radius = alpha2 == 0.0 ? points.radius(row) : std::sqrt(points.weight(row) + alpha2);
  if (!(radius >= 0.0)) return std::nullopt;
  return radius + 0.0;
}

}  // namespace orthoball
