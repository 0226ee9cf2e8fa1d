// SPDX-License-Identifier: MIT
//
// The curve's index of a point is read off its coordinates one bit of each at a time. The state is
// how the small cube at hand is turned: the corner where the curve enters it and the axis along
// which it leaves. Both follow from Gray codes; tables of all states, made at compile time, give
// the digit of the index and the next state at one look-up for one level, or for several.
#include "orthoball/triangulation/insertion_order.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "orthoball/radix_sort.h"

namespace orthoball {
namespace {

// Turns the D low bits to the left by `by`.
template <unsigned D>
constexpr unsigned turned_left(unsigned bits, unsigned by) {
  by %= D;
  return ((bits << by) | (bits >> (D - by))) & ((1U << D) - 1);
}

// What one or more levels of the curve add to the index.
struct CurveStep {
  std::uint8_t digits;
  std::uint8_t next;  // state
};

// The state is entry corner * D + exit axis. Bit i of `bits` is that of coordinate i.
template <unsigned D>
constexpr CurveStep one_level(unsigned state, unsigned bits) {
  const unsigned entry = state / D, axis = state % D;
  const auto gray = [](unsigned i) { return i ^ (i >> 1U); };
  // In the frame of the cube, the curve enters at 0 and leaves along the highest axis.
  const unsigned local = turned_left<D>(bits ^ entry, D - (axis + 1) % D);
  unsigned digit = local;
  for (unsigned shift = 1; shift < D; ++shift) digit ^= local >> shift;
  const unsigned before = digit == 0 ? 0 : gray(2 * ((digit - 1) / 2));
  const unsigned entry_next = entry ^ turned_left<D>(before, axis + 1);
  const unsigned changes = digit == 0 ? 0 : digit % 2 == 0 ? digit - 1 : digit;
  unsigned ones = 0;  // trailing ones of `changes`: the axis along which the small curve runs
  while ((changes >> ones & 1U) != 0) ++ones;
  const unsigned axis_next = (axis + ones % D + 1) % D;
  return {static_cast<std::uint8_t>(digit), static_cast<std::uint8_t>(entry_next * D + axis_next)};
}

// Levels that are looked up together, as many as leave a table in the nearest cache.
template <unsigned D>
constexpr unsigned kLevelsAtOnce = D == 2 ? 4 : 2;

// [state << (D * Levels) | bits]: Levels bits of each coordinate, those of the first lowest.
template <unsigned D, unsigned Levels>
constexpr auto kCurveSteps = [] {
  std::array<CurveStep, (D << D) << (D * Levels)> steps{};
  for (unsigned at = 0; at < steps.size(); ++at) {
    unsigned state = at >> (D * Levels), digits = 0;
    for (unsigned level = Levels; level-- > 0;) {
      unsigned bits = 0;
      for (unsigned axis = 0; axis < D; ++axis)
        bits |= (at >> (Levels * axis + level) & 1U) << axis;
      const CurveStep step = one_level<D>(state, bits);
      digits = digits << D | step.digits;
      state = step.next;
    }
    steps[at] = {static_cast<std::uint8_t>(digits), static_cast<std::uint8_t>(state)};
  }
  return steps;
}();

template <int D>
std::uint64_t curve_index(const std::array<std::uint32_t, std::size_t{D}>& cube, unsigned levels) {
  std::uint64_t index = 0;
  unsigned state = 0;
  const auto look_up = [&]<unsigned Levels>(unsigned level) {
    unsigned bits = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      bits |= (cube[axis] >> level & ((1U << Levels) - 1)) << (Levels * axis);
    }
    const CurveStep step = kCurveSteps<unsigned{D}, Levels>[state << (D * Levels) | bits];
    index = index << (D * Levels) | step.digits;
    state = step.next;
  };
  constexpr unsigned kAtOnce = kLevelsAtOnce<unsigned{D}>;
  unsigned level = levels;
  for (; level % kAtOnce != 0; --level) look_up.template operator()<1>(level - 1);
  for (; level != 0; level -= kAtOnce) look_up.template operator()<kAtOnce>(level - kAtOnce);
  return index;
}

// The box of the sites, as the map from coordinates to integers below 2^levels. Halved numbers: no
// difference of finite doubles overflows.
template <int D>
class Box {
 public:
  static constexpr unsigned kLevels = D == 2 ? 31 : 21;

  explicit Box(std::span<const double> coordinates) {
    std::array<double, std::size_t{D}> high{};
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const double half = 0.5 * coordinates[i];
      double& low = low_[i % D];
      if (i < D || half < low) low = half;
      if (i < D || half > high[i % D]) high[i % D] = half;
    }
    double extent = 0.0;
    for (std::size_t axis = 0; axis < D; ++axis) extent = std::max(extent, high[axis] - low_[axis]);
    exponent_ = extent > 0.0 ? static_cast<int>(kLevels) - 1 - std::ilogb(extent) : 0;
    // One factor where it is a double, for speed.
    factor_ = std::abs(exponent_) < 1000 ? std::ldexp(1.0, exponent_) : 0.0;
  }

  [[nodiscard]] std::uint32_t integer(double coordinate, std::size_t axis) const {
    const double distance = 0.5 * coordinate - low_[axis];
    const double scaled = factor_ != 0.0 ? distance * factor_ : std::ldexp(distance, exponent_);
    return std::min(static_cast<std::uint32_t>(scaled), (std::uint32_t{1} << kLevels) - 1);
  }

 private:
  std::array<double, std::size_t{D}> low_{};
  int exponent_ = 0;
  double factor_ = 1.0;
};

// Coordinates, then weight: the order of sites in one cube of the curve; 0 for equal sites.
template <int D>
int compared(const WeightedPoints& points, std::size_t a, std::size_t b) {
  const auto order = [](double p, double q) { return (p > q) - (p < q); };
  for (std::size_t axis = 0; axis < D; ++axis) {
    const int by = order(points.coordinates()[D * a + axis], points.coordinates()[D * b + axis]);
    if (by != 0) return by;
  }
  if (points.weight_kind() == WeightKind::none) return 0;
  const int by = order(points.weights()[a], points.weights()[b]);
  if (by != 0 || points.weights_low().empty()) return by;
  return order(points.weights_low()[a], points.weights_low()[b]);
}

}  // namespace

template <int D>
CurveOrder curve_order(const WeightedPoints& points, Threads threads) {
  const Box<D> box(points.coordinates());
  RawVector<KeyedRow> keyed(points.size());
  const std::size_t parts = threads.for_work(points.size(), 1U << 14U).count();
  parallel_parts(
      threads, keyed.size(), parts, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          std::array<std::uint32_t, std::size_t{D}> cube;
          for (std::size_t axis = 0; axis < D; ++axis) {
            cube[axis] = box.integer(points.coordinates()[D * row + axis], axis);
          }
          keyed[row] = {curve_index<D>(cube, Box<D>::kLevels), static_cast<std::uint32_t>(row)};
        }
      });
  radix_sort(keyed, threads);

  CurveOrder order;
  order.rows.reserve(keyed.size());
  for (std::size_t first = 0; first < keyed.size();) {
    std::size_t last = first + 1;
    while (last < keyed.size() && keyed[last].key == keyed[first].key) ++last;
    if (last - first > 1) {
      std::sort(keyed.begin() + static_cast<std::ptrdiff_t>(first),
                keyed.begin() + static_cast<std::ptrdiff_t>(last),
                [&](const KeyedRow& a, const KeyedRow& b) {
                  const int by = compared<D>(points, a.row, b.row);
                  return by != 0 ? by < 0 : a.row < b.row;
                });
    }
    for (std::size_t i = first; i < last; ++i) {
      const bool repeats =
          i > first && compared<D>(points, order.rows.back().row(), keyed[i].row) == 0;
      if (repeats) {
        order.duplicates.push_back({SiteId(keyed[i].row), order.rows.back()});
      } else {
        order.rows.push_back(SiteId(keyed[i].row));
      }
    }
    first = last;
  }
  std::sort(order.duplicates.begin(), order.duplicates.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.row < b.row; });
  return order;
}

InsertionOrder insertion_order(std::size_t count) {
  constexpr std::size_t kShare = 8;  // one site of so many is left for an earlier round,
  constexpr std::size_t kLeft = 4;   // this one of them, not the corner of a cube of the curve
  constexpr std::size_t kSmallestRound = 64;
  // A round has the sites first, first + stride, ... without those of rounds before.
  std::size_t first = 0, stride = 1;
  for (; count / stride > kSmallestRound; stride *= kShare) first += kLeft * stride;
  InsertionOrder order;
  order.reserve(count);
  const auto add = [&](std::size_t site) { order.push_back(static_cast<std::uint32_t>(site)); };
  for (std::size_t site = first; site < count; site += stride) add(site);
  while (stride > 1) {
    stride /= kShare;
    first -= kLeft * stride;
    std::size_t in_share = 0;
    for (std::size_t site = first; site < count; site += stride) {
      if (in_share != kLeft) add(site);
      in_share = in_share + 1 == kShare ? 0 : in_share + 1;
    }
  }
  return order;
}

template CurveOrder curve_order<2>(const WeightedPoints&, Threads);
template CurveOrder curve_order<3>(const WeightedPoints&, Threads);

}  // namespace orthoball
