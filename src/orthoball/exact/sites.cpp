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

// Binary digits of a double, so of a number that can be an integer among them.
constexpr int kDigits = 53;

// Every length is below 2^top.
int top_of(const Extent& extent) { return std::ilogb(extent.largest) + 1; }

// About the root of a weight's size, and where its lowest bit is: the weight is a multiple of the
// square of that.
std::pair<double, int> root_of_weight(const WeightedPoints& points, std::size_t row) {
  const double number = std::abs(points.weights()[row]);
  if (number == 0.0) return {0.0, 0};
  if (points.weight_kind() == WeightKind::radius) return {number, lowest_bit(number)};
  const double rest = points.weights_low().empty() ? 0.0 : points.weights_low()[row];
  const int low = lowest_bit(rest == 0.0 ? number : rest);
  return {std::sqrt(number), (low - (low < 0 ? 1 : 0)) / 2};  // rounded down
}

// Of some rows, in their order: sites are far apart there.
Extent extent_of(const WeightedPoints& points, std::size_t begin, std::size_t end) {
  Extent extent;
  const auto axes = static_cast<std::size_t>(points.dimension());
  // Once lengths differ by more than a double has digits, the lowest bit does not matter.
  bool is_wide = false;
  const auto add = [&](double length, int low) {
    extent.largest = std::max(extent.largest, length);
    extent.lowest = std::min(extent.lowest, low);
    is_wide = top_of(extent) - extent.lowest > kDigits;
  };
  for (std::size_t row = begin; row < end; ++row) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const double x = std::abs(points.coordinates()[axes * row + axis]);
      if (is_wide) {
        extent.largest = std::max(extent.largest, x);
      } else if (x != 0.0) {
        add(x, lowest_bit(x));
      }
    }
    if (points.weight_kind() == WeightKind::none) continue;
    const auto [length, low] = root_of_weight(points, row);
    if (is_wide) {
      extent.largest = std::max(extent.largest, length);
    } else if (length != 0.0) {
      add(length, low);
    }
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
  const int top = top_of(extent);
  if (top - extent.lowest <= kDigits) return {-extent.lowest, true};
  const bool fits = extent.largest < kLargestMagnitude && extent.largest > kSmallestUnscaled;
  return {fits ? 0 : -top, false};
}

// Multiplication by a power of two, rounded once.
class Scale {
 public:
  explicit Scale(int exponent)
      : exponent_(exponent),
        factor_(std::ldexp(1.0, exponent)),
        inverse_(std::ldexp(1.0, -exponent)),
        is_plain_(std::abs(exponent) < 1000) {}

  [[nodiscard]] double operator()(double number) const {
    return is_plain_ ? number * factor_ : std::ldexp(number, exponent_);
  }
  /// Whether `scaled`, made of `number`, is exact.
  [[nodiscard]] bool is_exact(double number, double scaled) const {
    if (exponent_ == 0) return true;
    const double back = is_plain_ ? scaled * inverse_ : std::ldexp(scaled, -exponent_);
    return std::isfinite(scaled) && back == number;
  }

 private:
  int exponent_;
  double factor_, inverse_;  // doubles where is_plain_
  bool is_plain_;
};

// What a part of the sites says of all.
struct Findings {
  bool all_exact = true;
  bool is_unweighted = true;
  double weight_error = 0.0;
};

template <int D>
Findings fill(const WeightedPoints& points, std::span<const SiteId> rows, int scale_exponent,
              const Weight& first, std::span<Site<D>> sites) {
  constexpr std::size_t kAhead = 16;  // rows are far apart
  Findings findings;
  const Scale scale(scale_exponent);
  const bool has_weights = points.weight_kind() != WeightKind::none;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i + kAhead < rows.size()) {
      __builtin_prefetch(&points.coordinates()[D * std::size_t{rows[i + kAhead].row()}]);
    }
    const std::size_t row = rows[i].row();
    Site<D>& site = sites[i];
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double x = points.coordinates()[D * row + axis] + 0.0;  // -0 becomes 0
      site.x[axis] = scale(x);
      if (!scale.is_exact(x, site.x[axis])) findings.all_exact = false;
    }
    site.weight = 0.0;
    if (!has_weights) continue;
    const Weight weight = exact_weight(points, row);
    const Scale scale_of_weight(weight.exponent + 2 * scale_exponent);
    site.weight = scale_of_weight(weight.high) + 0.0;
    if (weight.low != 0.0 || !scale_of_weight.is_exact(weight.high, site.weight)) {
      findings.all_exact = false;
      const double lost = std::abs(scale_of_weight(weight.low));
      findings.weight_error =
          std::max(findings.weight_error, 2 * lost + std::numeric_limits<double>::min());
    }
    if (weight.high != first.high || weight.low != first.low || weight.exponent != first.exponent) {
      findings.is_unweighted = false;
    }
  }
  return findings;
}

}  // namespace

template <int D>
Sites<D>::Sites(const WeightedPoints& points, std::vector<SiteId> rows, Threads threads)
    : rows_(std::move(rows)) {
  const std::span<const SiteId> all = rows_;
  decimals_ = points.decimals().value_or(0);
  const std::size_t parts = threads.for_work(points.size(), 1U << 14U).count();
  std::vector<Extent> extents(parts);
  parallel_parts(threads, points.size(), parts,
                 [&](std::size_t part, std::size_t begin, std::size_t end) {
                   extents[part] = extent_of(points, begin, end);
                 });
  Extent extent;
  for (const Extent& part : extents) {
    extent.largest = std::max(extent.largest, part.largest);
    extent.lowest = std::min(extent.lowest, part.lowest);
  }
  const auto [scale, integral] = scale_for(extent);
  scale_exponent_ = scale;

  sites_.resize(rows_.size() + 1);
  end_far_away();
  const Weight first = rows_.empty() ? Weight{} : exact_weight(points, rows_[0].row());
  std::vector<Findings> findings(parts);
  parallel_parts(threads, size(), parts,
                 [&, scale = scale](std::size_t part, std::size_t begin, std::size_t end) {
                   const std::size_t count = end - begin;
                   findings[part] = fill<D>(points, all.subspan(begin, count), scale, first,
                                            std::span(sites_).subspan(begin, count));
                 });
  bool all_exact = true;
  for (const Findings& part : findings) {
    all_exact &= part.all_exact;
    is_unweighted_ &= part.is_unweighted;
    weight_error_ = std::max(weight_error_, part.weight_error);
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
