// SPDX-License-Identifier: MIT
#include "orthoball/exact/sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "orthoball/exact/error_free.h"
#include "orthoball/exact/local_frame.h"

namespace orthoball {
namespace {

// Squares of radii within are error-free products in doubles.
constexpr double kSmallestPlainRadius = 0x1p-400;
constexpr double kLargestPlainRadius = 0x1p+400;

struct Weight {
  double high, low;
  int exponent;
};

// The weight of a row exactly, whatever its size.
Weight exact_weight(const WeightedPoints& points, std::size_t row) {
  if (points.weight_kind() == WeightKind::none) return {0.0, 0.0, 0};
  const double number = points.weights()[row];
  if (points.weight_kind() == WeightKind::weight) {
    return {number, points.weights_low().empty() ? 0.0 : points.weights_low()[row], 0};
  }
  const double size = std::abs(number);
  if (size == 0.0) return {0.0, 0.0, 0};
  int exponent = 0;
  double radius = number;
  if (size < kSmallestPlainRadius || size > kLargestPlainRadius) {
    radius = std::frexp(number, &exponent);
  }
  const Exactly square = two_product(radius, std::abs(radius));
  return {square.high, square.low, 2 * exponent};
}

// What the sites' numbers have in common.
struct Extent {
  double largest = 0.0;                          // of |coordinate| and sqrt |weight|, about
  int lowest = std::numeric_limits<int>::max();  // every length is a multiple of 2^lowest
};

Extent extent_of(const WeightedPoints& points, std::span<const SiteId> rows) {
  Extent extent;
  const auto axes = static_cast<std::size_t>(points.dimension());
  for (const SiteId row : rows) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const double x = points.coordinates()[axes * row.row() + axis];
      if (x == 0.0) continue;
      extent.largest = std::max(extent.largest, std::abs(x));
      extent.lowest = std::min(extent.lowest, lowest_bit(x));
    }
    if (points.weight_kind() == WeightKind::none) continue;
    const Weight weight = exact_weight(points, row.row());
    if (weight.high == 0.0) continue;
    extent.largest =
        std::max(extent.largest, std::ldexp(std::sqrt(std::abs(weight.high)), weight.exponent / 2));
    const int low = lowest_bit(weight.low == 0.0 ? weight.high : weight.low) + weight.exponent;
    extent.lowest = std::min(extent.lowest, (low - (low < 0 ? 1 : 0)) / 2);  // rounded down
  }
  return extent;
}

// Below this, determinants of the differences at hand might fall below what underflow can lose
// (kUnderflow), and all would go to the exact stages.
constexpr double kSmallestUnscaled = 0x1p-20;

// The power of two that makes all lengths integers of at most 2^53 if one does; otherwise none if
// the fast stages can take the lengths as they are, or what brings the largest to about 1.
std::pair<int, bool> scale_for(const Extent& extent) {
  if (extent.largest == 0.0) return {0, true};
  const int top = std::ilogb(extent.largest) + 1;  // every length is below 2^top
  if (top - extent.lowest <= 53) return {-extent.lowest, true};
  const bool fits = extent.largest < kLargestMagnitude && extent.largest > kSmallestUnscaled;
  return {fits ? 0 : -top, false};
}

bool scales_exactly(double number, double scaled, int exponent) {
  return std::isfinite(scaled) && std::ldexp(scaled, -exponent) == number;
}

double scaled_by(double number, int exponent) {
  return exponent == 0 ? number : std::ldexp(number, exponent);
}

}  // namespace

template <int D>
Sites<D>::Sites(const WeightedPoints& points, std::vector<SiteId> rows) : rows_(std::move(rows)) {
  decimals_ = points.decimals().value_or(0);
  const auto [scale, integral] = scale_for(extent_of(points, rows_));
  scale_exponent_ = scale;
  const bool has_weights = points.weight_kind() != WeightKind::none;

  bool all_exact = true;
  Weight first{};
  sites_.resize(rows_.size() + 1);
  end_far_away();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t row = rows_[i].row();
    Site<D>& site = sites_[i];
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double x = points.coordinates()[D * row + axis] + 0.0;  // -0 becomes 0
      site.x[axis] = scaled_by(x, scale);
      if (scale != 0 && !scales_exactly(x, site.x[axis], scale)) all_exact = false;
    }
    site.weight = 0.0;
    if (!has_weights) continue;
    const Weight weight = exact_weight(points, row);
    const int shift = weight.exponent + 2 * scale;
    site.weight = scaled_by(weight.high, shift) + 0.0;
    if (weight.low != 0.0 || !scales_exactly(weight.high, site.weight, shift)) {
      all_exact = false;
      const double lost = std::abs(scaled_by(weight.low, shift));
      weight_error_ = std::max(weight_error_, 2 * lost + std::numeric_limits<double>::min());
    }
    if (i == 0) first = weight;
    if (weight.high != first.high || weight.low != first.low || weight.exponent != first.exponent) {
      is_unweighted_ = false;
    }
  }
  is_integral_ = integral && all_exact;
  if (all_exact) return;

  exact_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t row = rows_[i].row();
    const Weight weight = exact_weight(points, row);
    ExactSite<D>& site = exact_[i];
    for (std::size_t axis = 0; axis < D; ++axis) {
      site.x[axis] = points.coordinates()[D * row + axis] + 0.0;
    }
    site.weight_high = weight.high;
    site.weight_low = weight.low;
    site.weight_exponent = weight.exponent;
  }
}

// So large that the bounds of all glances at power sides are infinite, so small that no determinant
// is: five lengths of at most 2^151 or four with this.
template <int D>
constexpr double kFarWeight = D == 3 ? -0x1p+320 : -0x1p+600;

template <int D>
void Sites<D>::end_far_away() {
  sites_.back() = {};
  sites_.back().weight = kFarWeight<D>;
}

template <int D>
ExactSite<D> Sites<D>::exact(std::size_t site) const {
  if (!exact_.empty()) return exact_[site];
  ExactSite<D> result;
  for (std::size_t axis = 0; axis < D; ++axis) result.x[axis] = sites_[site].x[axis];
  result.weight_high = sites_[site].weight;
  result.weight_low = 0.0;
  result.weight_exponent = 0;
  return result;
}

template <int D>
void Sites<D>::drop(const std::vector<bool>& is_dropped) {
  const auto drop_from = [&](auto& numbers) {
    std::size_t kept = 0;
    for (std::size_t site = 0; site < numbers.size(); ++site) {
      if (!is_dropped[site]) numbers[kept++] = numbers[site];
    }
    numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(kept), numbers.end());
  };
  if (!sites_.empty()) sites_.resize(size());
  drop_from(sites_);
  drop_from(exact_);
  drop_from(rows_);
  sites_.resize(size() + 1);
  end_far_away();
}

template <int D>
Sites<D> Sites<D>::with_axes(const std::array<int, std::size_t{D}>& axes) const {
  Sites result = *this;
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (std::size_t i = 0; i < size(); ++i) result.sites_[i].x[axis] = sites_[i].x[axes[axis]];
    for (std::size_t i = 0; i < exact_.size(); ++i)
      result.exact_[i].x[axis] = exact_[i].x[axes[axis]];
  }
  return result;
}

template class Sites<2>;
template class Sites<3>;

}  // namespace orthoball
