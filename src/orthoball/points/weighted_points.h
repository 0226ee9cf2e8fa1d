// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace orthoball {

/// What the third array of a WeightedPoints holds.
enum class WeightKind {
  none,    ///< nothing: every weight is 0
  weight,  ///< weights: signed squared lengths
  radius,  ///< signed radii r, standing for the weight sign(r) r^2
};

/// Weighted points in the plane or in space, checked and exact: what every computation starts from.
///
/// Site i is row i of the caller's arrays, always. All numbers are finite. Either they are the
/// doubles the caller gave (`decimals()` is empty), or they are decimal fixed-point numbers:
/// integers of at most 2^53 in units of 10^-decimals (coordinates, radii), and integers of at most
/// 106 bits in units of 10^-2*decimals (weights), so that "0.1" means one tenth.
///
/// Costs what its arrays cost: D doubles a site, one more for a radius or weight.
class WeightedPoints {
 public:
  /// No sites.
  /// @throws InputError unless `dimension` is 2 or 3.
  explicit WeightedPoints(int dimension) : WeightedPoints(dimension, {}, WeightKind::none, {}) {}

  /// Numbers taken as the doubles they are.
  /// @param coordinates  [dimension * row + axis], lengths.
  /// @param weights      [row], empty for WeightKind::none; meaning and unit as `kind` says.
  /// @throws InputError that names the row for NaN or infinity; for lengths that do not match.
  /// @throws LimitError for 2^32 - 2 sites or more.
  WeightedPoints(int dimension, std::vector<double> coordinates, WeightKind kind,
                 std::vector<double> weights);

  /// Decimal numbers, exact: `coordinates` and radii are integers in units of 10^-decimals, weights
  /// the integers `weights[row] + weights_low[row]` in units of 10^-(2 decimals).
  /// @param weights_low  [row] or empty (all 0); only with WeightKind::weight, and at most half an
  ///                     ulp of `weights[row]`.
  /// @throws InputError, LimitError as above; InputError for a number that is not such an integer
  ///         or `decimals` outside [0, 400].
  static WeightedPoints fixed_point(int dimension, int decimals, std::vector<double> coordinates,
                                    WeightKind kind, std::vector<double> weights,
                                    std::vector<double> weights_low = {});

  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] std::size_t size() const {
    return coordinates_.size() / static_cast<std::size_t>(dimension_);
  }
  /// k if all numbers are integers in units of 10^-k, empty if they are doubles.
  [[nodiscard]] std::optional<int> decimals() const { return decimals_; }
  [[nodiscard]] WeightKind weight_kind() const { return kind_; }

  /// [dimension * row + axis]; in units of 10^-decimals where decimals() says so.
  [[nodiscard]] std::span<const double> coordinates() const { return coordinates_; }
  /// [row]; empty for WeightKind::none.
  [[nodiscard]] std::span<const double> weights() const { return weights_; }
  /// [row]: what to add to weights()[row]; empty where that is 0 for all.
  [[nodiscard]] std::span<const double> weights_low() const { return weights_low_; }

  /// Coordinate of one site in input units. Correctly rounded.
  [[nodiscard]] double coordinate(std::size_t row, int axis) const;
  /// Weight of one site in input units squared. Off by a few ulps, for display; the exact number is
  /// in the arrays. Infinite where a radius squared is beyond the double range.
  [[nodiscard]] double weight(std::size_t row) const;
  /// Signed root of the weight, in input units: a radius as it was given, correctly rounded. Off by
  /// a few ulps, for display, with WeightKind::weight.
  [[nodiscard]] double radius(std::size_t row) const;

 private:
  [[nodiscard]] double in_input_units(double number) const;

  int dimension_;
  std::optional<int> decimals_;
  WeightKind kind_;
  std::vector<double> coordinates_;
  std::vector<double> weights_;
  std::vector<double> weights_low_;
};

/// Radius of the ball of one site at alpha2, sqrt(weight + alpha2), in input units; empty where
/// that is imaginary. Off by a few ulps, for display; the radius itself at alpha2 = 0.
[[nodiscard]] std::optional<double> ball_radius(const WeightedPoints& points, std::size_t row,
                                                double alpha2);

}  // namespace orthoball
