// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

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

/// The first look of power_side: decides most tests at half the cost of filtered_power_side, by the
/// same determinant with a coarser bound. No coordinate exceeds the root of the largest lift, so
/// the product of the largest of each axis is at most lift^(A/2); squares need no root.
template <int A, int D>
[[nodiscard]] inline Sign glanced_power_side(const Sites<D>&, const Corners<A>&, std::uint32_t) {
  return Sign::zero;
}

/// In space, two corners to a vector. The determinant of the rows (lift, x, y, z) is expanded by
/// the 2 x 2 minors of (lift, z) and of (x, y).
template <>
[[nodiscard]] inline Sign glanced_power_side<3, 3>(const Sites<3>& sites, const Corners<3>& corners,
                                                   std::uint32_t query) {
  using Pair = double __attribute__((vector_size(16)));
  const auto load = [](const double* from) {
    Pair pair;
    std::memcpy(&pair, from, sizeof pair);
    return pair;
  };
  const auto firsts = [](Pair a, Pair b) { return __builtin_shufflevector(a, b, 0, 2); };
  const auto seconds = [](Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 3); };
  const auto swapped = [](Pair a) { return __builtin_shufflevector(a, a, 1, 0); };

  // Rows ab and cd: each vector holds one column of two rows.
  struct Rows {
    Pair x, y, z, lift;
  };
  const double* const q = sites[query].x;
  const Pair q_xy = load(q), q_zw = load(q + 2);  // the weight follows the coordinates
  using Bits = std::int64_t __attribute__((vector_size(16)));
  const Bits magnitude_bits = {INT64_MAX, INT64_MAX};
  Pair lifts = {0.0, 0.0};  // sums of all |lift|, at least the largest
  const auto rows = [&](std::uint32_t first, std::uint32_t second) {
    const double* const p = sites[first].x;
    const double* const r = sites[second].x;
    const Pair p_xy = load(p) - q_xy, p_zw = load(p + 2) - q_zw;
    const Pair r_xy = load(r) - q_xy, r_zw = load(r + 2) - q_zw;
    Rows two{firsts(p_xy, r_xy), seconds(p_xy, r_xy), firsts(p_zw, r_zw), {}};
    const Pair weight = seconds(p_zw, r_zw);
    const Pair square = two.x * two.x + two.y * two.y + two.z * two.z;
    two.lift = square - weight;
    lifts += square + reinterpret_cast<Pair>(reinterpret_cast<Bits>(weight) & magnitude_bits);
    return two;
  };
  const Rows ab = rows(corners[0], corners[1]);
  const Rows cd = rows(corners[2], corners[3]);

  // For two columns u, v: the minors (ac, bd), (ad, bc), (ab, cd).
  struct Minors {
    Pair ac_bd, ad_bc, ab_cd;
  };
  const auto minors = [&](Pair u_ab, Pair u_cd, Pair v_ab, Pair v_cd) {
    return Minors{
        u_ab * v_cd - v_ab * u_cd, u_ab * swapped(v_cd) - v_ab * swapped(u_cd),
        firsts(u_ab, u_cd) * seconds(v_ab, v_cd) - firsts(v_ab, v_cd) * seconds(u_ab, u_cd)};
  };
  const Minors xy = minors(ab.x, cd.x, ab.y, cd.y);
  const Minors lz = minors(ab.lift, cd.lift, ab.z, cd.z);
  const Pair sum =
      lz.ab_cd * swapped(xy.ab_cd) - lz.ac_bd * swapped(xy.ac_bd) + lz.ad_bc * swapped(xy.ad_bc);
  const double value = sum[0] + sum[1];

  // The error of the weights counts as so much lift that its share of the bound is covered.
  const double lift = lifts[0] + lifts[1] + sites.weight_error() * 0x1p+52;
  const double bound =
      kPowerSideBound<3> * kPowerSideBound<3> * (lift * lift) * (lift * lift) * lift;
  if (value * value > bound + kUnderflow * kUnderflow) {
    return value > 0 ? Sign::positive : Sign::negative;
  }
  return Sign::zero;  // not known
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
  const Sign glance = glanced_power_side<A, D>(sites, corners, query);
  if (glance != Sign::zero) return glance;
  const FilteredDeterminant determinant = filtered_power_side<A, D>(sites, corners, query);
  if (determinant.value > determinant.bound) return Sign::positive;
  if (determinant.value < -determinant.bound) return Sign::negative;
  if (determinant.is_exact) {
    return static_cast<Sign>((determinant.value > 0) - (determinant.value < 0));
  }
  return exact_power_side<A, D>(sites, corners, query);
}

}  // namespace orthoball
