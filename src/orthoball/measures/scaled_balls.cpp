// SPDX-License-Identifier: MIT
#include "orthoball/measures/scaled_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "orthoball/error.h"

namespace orthoball {
namespace {

// The exponent of the power of two by which lengths are multiplied so that no radius is more than
// 2^300, of which volumes, their sums and products on the way do not overflow. Those of sites are
// less than that.
template <int D>
int shrinking(const Sites<D>& sites, double alpha2) {
  constexpr int kLargest = 300;
  constexpr double kBitsOfTen = 3.33;
  if (!(alpha2 > 0.0)) return 0;
  const double bits =
      std::ilogb(alpha2) / 2.0 + sites.scale_exponent() + kBitsOfTen * sites.decimals();
  return std::min(0, kLargest - static_cast<int>(bits));
}

}  // namespace

template <int D>
ScaledBalls<D>::ScaledBalls(const Filtration<D>& filtration, std::uint32_t index, double alpha2)
    : filtration_(&filtration) {
  if (index > filtration.spectrum_size()) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "index " + std::to_string(index) +
                         " is beyond the spectrum; indices are 0 to " +
                         std::to_string(filtration.spectrum_size()));
  }
  if (std::isnan(alpha2) || alpha2 == std::numeric_limits<double>::infinity()) {
    throw InputError(InputError::Reason::not_finite, InputError::kNoRow,
                     "alpha2 of a union of balls must be finite");
  }
  if (filtration.is_coarse() && std::isfinite(alpha2) &&
      (index == 0 || filtration.alpha2(index) != alpha2)) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "alpha2 of a union of balls must be that of the index, for nothing is known "
                     "between the values of a coarse filtration");
  }
  const Sites<D>& sites = filtration.triangulation().sites();
  const int exponent = shrinking(sites, alpha2);
  scale_exponent_ = sites.scale_exponent() + exponent;
  const double added = from_input(alpha2, 2);
  const double unit = std::ldexp(1.0, exponent);
  spheres_.resize(sites.size());
  for (std::size_t vertex = 0; vertex < sites.size(); ++vertex) {
    const Site<D>& site = sites[vertex];
    Sphere<D> sphere;
    for (std::size_t axis = 0; axis < D; ++axis) sphere.x[axis] = site.x[axis] * unit;
    sphere.weight = site.weight * unit * unit;
    sphere.radius = std::sqrt(std::max(0.0, sphere.weight + added));
    spheres_[vertex] = sphere;
  }
}

template <int D>
InputUnits ScaledBalls<D>::units(int power) const {
  return {power, scale_exponent_, filtration_->triangulation().sites().decimals(), 1};
}

template <int D>
double ScaledBalls<D>::from_input(double value, int power) const {
  return from_input_units(value, power, scale_exponent_,
                          filtration_->triangulation().sites().decimals());
}

template class ScaledBalls<2>;
template class ScaledBalls<3>;

}  // namespace orthoball
