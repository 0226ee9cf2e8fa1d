// SPDX-License-Identifier: MIT
//
// A walk from cell to cell: across any facet that has the point strictly beyond it. In a regular
// triangulation it cannot return to a cell, so it ends in one that contains the point, or outside.
// Facets that have the point in their plane tell on which face of the cell it lies.
//
// Sides are signs of determinants: in doubles, with a bound on their error, else in wide integers.
// Sites and points may have units of their own, 10^-k and 10^-j; integers are made in the finer
// one. Sites that span less than space are seen along axes on which their cells keep their
// dimension, and a point must be in their span besides.
//
// Devillers, Pion, Teillaud. Walking in a triangulation. International Journal of Foundations of
// Computer Science 13 (2002).
#include "orthoball/queries/containment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "orthoball/exact/filter_bounds.h"
#include "orthoball/exact/local_frame.h"
#include "orthoball/exact/sign.h"
#include "orthoball/exact/wide_integer.h"
#include "orthoball/queries/query_points.h"

namespace orthoball {
namespace {

constexpr std::size_t kLeastPart = 1024;  // points for a thread of its own
constexpr double kEpsilon = 0x1p-53;

// Up to three of the axes.
struct Axes {
  std::array<std::size_t, 3> axis{};
  std::size_t count = 0;

  [[nodiscard]] Axes with(std::size_t more) const {
    Axes result = *this;
    result.axis[result.count++] = more;
    return result;
  }
  [[nodiscard]] bool has(std::size_t one) const {
    return std::find(axis.begin(), axis.begin() + count, one) != axis.begin() + count;
  }
};

// det of the rows 1..count, each a point less point 0, on the axes.
template <class Number>
Number determinant(const std::array<std::array<Number, 3>, 4>& p, const Axes& axes) {
  const auto at = [&](std::size_t row, std::size_t column) {
    return p[row][axes.axis[column]] - p[0][axes.axis[column]];
  };
  const auto minor = [&](std::size_t row, std::size_t other) {
    return at(row, 0) * at(other, 1) - at(row, 1) * at(other, 0);
  };
  if (axes.count == 1) return at(1, 0);
  if (axes.count == 2) return minor(1, 2);
  return at(1, 2) * minor(2, 3) - at(2, 2) * minor(1, 3) + at(3, 2) * minor(1, 2);
}

// Sides of cells on which the points lie, exactly.
template <int D>
class Sides {
 public:
  // A point in place of a site.
  static constexpr std::uint32_t kPoint = std::numeric_limits<std::uint32_t>::max();
  // Sites by number, and kPoint.
  using Corners = std::array<std::uint32_t, 4>;

  Sides(const Sites<D>& sites, const WeightedPoints& points)
      : sites_(sites),
        points_(points.coordinates()),
        finer_(std::max(sites.decimals(), points.decimals().value_or(0))),
        site_power_(finer_ - sites.decimals()),
        point_power_(finer_ - points.decimals().value_or(0)) {
    const double power = std::pow(10.0, std::abs(site_power_ - point_power_));
    factor_ = point_power_ > site_power_ ? power : 1.0 / power;
  }

  // The orientation of axes.count + 1 of the corners, one of which may be `point`.
  [[nodiscard]] Sign side(const Corners& corners, std::size_t point, const Axes& axes) const {
    const Sign sign = filtered(corners, point, axes);
    return sign != Sign::zero ? sign : exact(corners, point, axes);
  }

 private:
  [[nodiscard]] Sign filtered(const Corners& corners, std::size_t point, const Axes& axes) const {
    if (!sites_.is_exact()) return Sign::zero;
    std::array<std::array<double, 3>, 4> p{};
    double largest_error = 0.0;
    for (std::size_t i = 0; i <= axes.count; ++i) {
      for (std::size_t column = 0; column < axes.count; ++column) {
        const std::size_t axis = axes.axis[column];
        if (corners[i] != kPoint) {
          p[i][axis] = sites_[corners[i]].x[axis];
          continue;
        }
        p[i][axis] = std::ldexp(points_[D * point + axis], sites_.scale_exponent()) * factor_;
        if (!(std::abs(p[i][axis]) < kLargestMagnitude)) return Sign::zero;
        // The power of ten, its inverse and the product are rounded; so may a tiny number be.
        largest_error = std::max(largest_error, 8 * kEpsilon * std::abs(p[i][axis]));
      }
    }
    double largest = 0.0;  // of the differences
    for (std::size_t i = 1; i <= axes.count; ++i) {
      for (std::size_t column = 0; column < axes.count; ++column) {
        const std::size_t axis = axes.axis[column];
        largest = std::max(largest, std::abs(p[i][axis] - p[0][axis]));
      }
    }
    // At most six products of three entries, each off by its own rounding and the point's, and a
    // few roundings more; twice what that makes.
    const double entry_error = 8 * kEpsilon * largest + 2 * largest_error;
    double bound = 36 * entry_error;
    for (std::size_t i = 1; i < axes.count; ++i) bound *= largest + entry_error;
    bound += kUnderflow;
    const double value = determinant(p, axes);
    if (value > bound) return Sign::positive;
    return value < -bound ? Sign::negative : Sign::zero;
  }

  [[nodiscard]] Sign exact(const Corners& corners, std::size_t point, const Axes& axes) const {
    std::array<std::array<double, 3>, 4> p{};
    constexpr int kNothing = 1 << 20;
    const int shift = sites_.exact_scale_exponent();
    int lowest = kNothing, highest = -kNothing;
    for (std::size_t i = 0; i <= axes.count; ++i) {
      const bool is_point = corners[i] == kPoint;
      const ExactSite<D> site = is_point ? ExactSite<D>{} : sites_.exact(corners[i]);
      for (std::size_t column = 0; column < axes.count; ++column) {
        const std::size_t axis = axes.axis[column];
        const double x = is_point ? points_[D * point + axis] : site.x[axis];
        p[i][axis] = x;
        if (x == 0.0) continue;
        lowest = std::min(lowest, lowest_bit(x) + (is_point ? shift : 0));
        highest = std::max(highest, std::ilogb(x) + 1 + (is_point ? shift : 0));
      }
    }
    if (lowest == kNothing) return Sign::zero;
    // A power of ten takes less than 4 bits.
    const int bits = highest - lowest + 4 * std::max(site_power_, point_power_) + 2;
    return with_width(static_cast<int>(axes.count) * (bits + 1) + 4, [&]<class Int>() {
      std::array<std::array<Int, 3>, 4> integers{};
      for (std::size_t i = 0; i <= axes.count; ++i) {
        const bool is_point = corners[i] == kPoint;
        for (std::size_t column = 0; column < axes.count; ++column) {
          const std::size_t axis = axes.axis[column];
          Int& integer = integers[i][axis];
          integer = local_frame_detail::integer<Int>(p[i][axis], lowest - (is_point ? shift : 0));
          const int power = is_point ? point_power_ : site_power_;
          for (int k = 0; k < power; ++k) integer *= Int(10);
        }
      }
      return determinant(integers, axes).sign();
    });
  }

  const Sites<D>& sites_;
  std::span<const double> points_;  // [D * row + axis]
  int finer_;                       // integers are in units of 10^-finer_
  int site_power_, point_power_;    // 10^these times coordinates are
  double factor_;                   // from the units of points to those of sites, rounded
};

// The walk in cells of affine dimension A.
template <int A, int D>
class Walk {
 public:
  Walk(const Filtration<D>& filtration, const WeightedPoints& points)
      : filtration_(filtration),
        cells_(filtration.triangulation().template cells<A>()),
        sides_(filtration.triangulation().sites(), points) {
    // The first axes on which the first cell keeps its dimension.
    for (std::size_t axis = 0; axis < D && axes_.count < A; ++axis) {
      if (A == D || grows(axes_.with(axis))) axes_ = axes_.with(axis);
    }
  }

  // @param cell  where the walk begins; then where it ended.
  [[nodiscard]] SimplexId simplex_at(std::size_t point, std::uint32_t& cell) const {
    std::uint32_t on_facets = 0;  // a bit for each facet in whose plane the point is
    for (;;) {
      const std::uint32_t beyond = neighbour_towards(point, cell, on_facets);
      if (beyond == kHere) break;
      if (beyond == kOutside) return {};
      cell = beyond / 4;
    }
    if (!is_in_span(point, cell)) return {};
    SimplexId simplex(filtration_.table().first(A) + cell);
    for (std::size_t i = 0; i <= A; ++i) {
      if ((on_facets >> i & 1U) == 0) continue;
      const VertexId left_out(cells_[cell].corners[i]);
      const auto vertices = filtration_.vertices(simplex);
      const auto at = std::find(vertices.begin(), vertices.end(), left_out) - vertices.begin();
      simplex = filtration_.facets(simplex)[static_cast<std::size_t>(at)];
    }
    return simplex;
  }

 private:
  using Corners = typename Sides<D>::Corners;
  static constexpr std::uint32_t kHere = kOutside - 1;

  [[nodiscard]] Corners corners(std::uint32_t cell) const {
    Corners result{};
    for (std::size_t i = 0; i <= A; ++i) result[i] = cells_[cell].corners[i];
    return result;
  }
  // Whether some axes.count + 1 corners of the first cell span that dimension on them.
  [[nodiscard]] bool grows(const Axes& axes) const {
    const Corners all = corners(0);
    if (axes.count == A) return sides_.side(all, 0, axes) != Sign::zero;
    for (std::size_t i = 1; i <= A; ++i) {  // axes.count is 1, A is 2
      if (sides_.side({all[0], all[i], 0, 0}, 0, axes) != Sign::zero) return true;
    }
    return false;
  }

  // Across a facet that has the point strictly beyond it; kHere if the cell contains it.
  [[nodiscard]] std::uint32_t neighbour_towards(std::size_t point, std::uint32_t cell,
                                                std::uint32_t& on_facets) const {
    const Corners all = corners(cell);
    const Sign orientation = A == D ? Sign::positive : sides_.side(all, point, axes_);
    on_facets = 0;
    for (std::size_t i = 0; i <= A; ++i) {
      Corners facet_and_point = all;
      facet_and_point[i] = Sides<D>::kPoint;
      const Sign sign = sides_.side(facet_and_point, point, axes_);
      if (sign == Sign::zero) {
        on_facets |= 1U << i;
      } else if (sign != orientation) {
        return cells_[cell].neighbours[i];
      }
    }
    return kHere;
  }

  [[nodiscard]] bool is_in_span(std::size_t point, std::uint32_t cell) const {
    Corners all = corners(cell);
    if constexpr (A < D) all[A + 1] = Sides<D>::kPoint;
    for (std::size_t axis = 0; A < D && axis < D; ++axis) {
      if (axes_.has(axis)) continue;
      if (sides_.side(all, point, axes_.with(axis)) != Sign::zero) return false;
    }
    return true;
  }

  const Filtration<D>& filtration_;
  std::span<const CellRecord<A>> cells_;
  Sides<D> sides_;
  Axes axes_;
};

template <int A, int D>
void locate(const Filtration<D>& filtration, const WeightedPoints& points, Threads threads,
            std::vector<SimplexId>& simplices) {
  if (filtration.triangulation().affine_dimension() != A) return;
  if constexpr (A == 0) {
    const Sides<D> sides(filtration.triangulation().sites(), points);
    for (std::size_t point = 0; point < simplices.size(); ++point) {
      bool is_there = true;
      for (std::size_t axis = 0; axis < D; ++axis) {
        is_there &= sides.side({0, Sides<D>::kPoint, 0, 0}, point, Axes().with(axis)) == Sign::zero;
      }
      if (is_there) simplices[point] = SimplexId(0);
    }
  } else {
    const Walk<A, D> walk(filtration, points);
    const Threads used = threads.for_work(simplices.size(), kLeastPart);
    parallel_parts(used, simplices.size(), used.count(),
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     std::uint32_t cell = 0;
                     for (std::size_t point = begin; point < end; ++point) {
                       simplices[point] = walk.simplex_at(point, cell);
                     }
                   });
  }
}

}  // namespace

template <int D>
std::vector<SimplexId> simplices_at(const Filtration<D>& filtration, const WeightedPoints& points,
                                    Threads threads) {
  require_dimension(points, D);
  std::vector<SimplexId> simplices(points.size());
  locate<0>(filtration, points, threads, simplices);
  locate<1>(filtration, points, threads, simplices);
  locate<2>(filtration, points, threads, simplices);
  if constexpr (D == 3) locate<3>(filtration, points, threads, simplices);
  return simplices;
}

template std::vector<SimplexId> simplices_at<2>(const Filtration<2>&, const WeightedPoints&,
                                                Threads);
template std::vector<SimplexId> simplices_at<3>(const Filtration<3>&, const WeightedPoints&,
                                                Threads);

}  // namespace orthoball
