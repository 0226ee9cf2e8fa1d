// SPDX-License-Identifier: MIT
#include "orthoball/input/crystal_cell.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace orthoball {
namespace {

double cosine(double degrees) {
  if (degrees == 90.0) return 0.0;  // the multiples of 30 and 60 that crystals have, exactly
  if (degrees == 60.0) return 0.5;
  if (degrees == 120.0) return -0.5;
  return std::cos(degrees * (std::numbers::pi / 180.0));
}

}  // namespace

std::optional<CrystalCell> CrystalCell::of(const std::array<double, 3>& lengths,
                                           const std::array<double, 3>& angles) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(lengths[i] > 0.0) || !std::isfinite(lengths[i])) return std::nullopt;
    if (!(angles[i] > 0.0 && angles[i] < 180.0)) return std::nullopt;
  }
  const double cos_alpha = cosine(angles[0]);
  const double cos_beta = cosine(angles[1]);
  const double cos_gamma = cosine(angles[2]);
  const double sin_gamma = std::sqrt((1.0 - cos_gamma) * (1.0 + cos_gamma));
  const double third_y = (cos_alpha - cos_beta * cos_gamma) / sin_gamma;
  const double third_z2 = 1.0 - cos_beta * cos_beta - third_y * third_y;
  if (!(third_z2 > 0.0)) return std::nullopt;

  CrystalCell cell;
  cell.axes_[0] = {lengths[0], 0.0, 0.0};
  cell.axes_[1] = {lengths[1] * cos_gamma, lengths[1] * sin_gamma, 0.0};
  cell.axes_[2] = {lengths[2] * cos_beta, lengths[2] * third_y, lengths[2] * std::sqrt(third_z2)};
  return cell;
}

std::array<double, 3> CrystalCell::cartesian(const std::array<double, 3>& fractional) const {
  std::array<double, 3> position{};
  for (std::size_t i = 0; i < 3; ++i) {
    position[i] =
        fractional[0] * axes_[0][i] + fractional[1] * axes_[1][i] + fractional[2] * axes_[2][i];
  }
  return position;
}

}  // namespace orthoball
