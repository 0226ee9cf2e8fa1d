// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "orthoball/exact/orient.h"

namespace orthoball {

/// Stage 1 of power_side: the determinant in doubles.
///
/// Lift a weighted point p to (p, |p|^2 - w). With q moved to the origin, the determinant of the
/// rows (lift, coordinates) is the height of the plane through the lifted corners above q, times
/// the simplex's volume. Coordinates are the first A of D axes, lifts use all D: so sites in a
/// plane of space are handled in a projection.
template <int A, int D>
[[nodiscard]] inline FilteredDeterminant filtered_power_side(const Sites<D>& sites,
                                                             const Corners<A>& corners,
                                                             std::uint32_t query) {
  const Site<D>& q = sites[query];
  double x[std::size_t{A + 1}][std::size_t{D}];
  double lift[std::size_t{A + 1}];
  double largest[std::size_t{A}] = {};
  double largest_lift = 0.0;
  for (int i = 0; i <= A; ++i) {
    const Site<D>& p = sites[corners[static_cast<std::size_t>(i)]];
    double square = 0.0;
    for (int axis = 0; axis < D; ++axis) {
      x[i][axis] = p.x[axis] - q.x[axis];
      square += x[i][axis] * x[i][axis];
    }
    const double weight = p.weight - q.weight;
    lift[i] = square - weight;
    for (int axis = 0; axis < A; ++axis) {
      largest[axis] = std::max(largest[axis], std::abs(x[i][axis]));
    }
    largest_lift = std::max(largest_lift, square + std::abs(weight));
  }

  double value = 0.0;
  double magnitude = 1.0;
  for (int axis = 0; axis < A; ++axis) magnitude *= largest[axis];
  if constexpr (A == 1) {
    value = lift[0] * x[1][0] - lift[1] * x[0][0];
  } else if constexpr (A == 2) {
    value = lift[0] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]) -
            lift[1] * (x[0][0] * x[2][1] - x[0][1] * x[2][0]) +
            lift[2] * (x[0][0] * x[1][1] - x[0][1] * x[1][0]);
  } else {
    const double ab = x[0][0] * x[1][1] - x[0][1] * x[1][0];
    const double ac = x[0][0] * x[2][1] - x[0][1] * x[2][0];
    const double ad = x[0][0] * x[3][1] - x[0][1] * x[3][0];
    const double bc = x[1][0] * x[2][1] - x[1][1] * x[2][0];
    const double bd = x[1][0] * x[3][1] - x[1][1] * x[3][0];
    const double cd = x[2][0] * x[3][1] - x[2][1] * x[3][0];
    const double bcd = x[1][2] * cd - x[2][2] * bd + x[3][2] * bc;
    const double acd = x[0][2] * cd - x[2][2] * ad + x[3][2] * ac;
    const double abd = x[0][2] * bd - x[1][2] * ad + x[3][2] * ab;
    const double abc = x[0][2] * bc - x[1][2] * ac + x[2][2] * ab;
    value = (lift[0] * bcd - lift[1] * acd) + (lift[2] * abd - lift[3] * abc);
  }
  const double weight_part = 2 * kPowerSideTerms<A> * magnitude * sites.weight_error();
  return {value, kPowerSideBound<A> * (magnitude * largest_lift) + weight_part + kUnderflow,
          sites.is_integral() && kPowerSideTerms<A> * (magnitude * largest_lift) <= kExactIntegers};
}

/// Stage 2: the same sign in wide integers. Exact on any finite numbers.
template <int A, int D>
[[nodiscard]] Sign exact_power_side(const Sites<D>& sites, const Corners<A>& corners,
                                    std::uint32_t query);

/// On which side of the orthosphere of a positively oriented simplex does `query` lie, unperturbed:
/// positive if its power to the orthosphere is negative, that is, if it invalidates the simplex.
/// For a negatively oriented simplex the sign is the opposite. Exact.
template <int A, int D>
[[nodiscard]] inline Sign power_side(const Sites<D>& sites, const Corners<A>& corners,
                                     std::uint32_t query) {
  const FilteredDeterminant determinant = filtered_power_side<A, D>(sites, corners, query);
  if (determinant.value > determinant.bound) return Sign::positive;
  if (determinant.value < -determinant.bound) return Sign::negative;
  if (determinant.is_exact) {
    return static_cast<Sign>((determinant.value > 0) - (determinant.value < 0));
  }
  return exact_power_side<A, D>(sites, corners, query);
}

}  // namespace orthoball
