// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "orthoball/exact/filter_bounds.h"
#include "orthoball/exact/sign.h"
#include "orthoball/exact/sites.h"

namespace orthoball {

/// The corners of a simplex of dimension A, as numbers of sites.
template <int A>
using Corners = std::array<std::uint32_t, std::size_t{A + 1}>;

/// Which stage of a predicate decided.
enum class Stage {
  filter,    ///< doubles: the error bound does not reach zero
  integers,  ///< doubles that are exact because the integers at hand are small
  exact,     ///< wide integers
};

/// Stage 1 of a predicate: a determinant in doubles and how far it may be off.
struct FilteredDeterminant {
  double value;
  double bound;   ///< |value - true value| < bound
  bool is_exact;  ///< value is the determinant: all numbers were small integers
};

/// The stage that gives the sign of a determinant whose first stage gave `determinant`.
[[nodiscard]] inline Stage deciding_stage(const FilteredDeterminant& determinant) {
  if (std::abs(determinant.value) > determinant.bound) return Stage::filter;
  return determinant.is_exact ? Stage::integers : Stage::exact;
}

/// The orientation determinant of A + 1 sites on their first A axes, in doubles.
template <int A, int D>
[[nodiscard]] inline FilteredDeterminant filtered_orient(const Sites<D>& sites,
                                                         const Corners<A>& corners) {
  const Site<D>& a = sites[corners[0]];
  double value = 0.0;
  double magnitude = 1.0;
  if constexpr (A == 1) {
    value = sites[corners[1]].x[0] - a.x[0];
    magnitude = std::abs(value);
  } else if constexpr (A == 2) {
    const Site<D>& b = sites[corners[1]];
    const Site<D>& c = sites[corners[2]];
    const double bx = b.x[0] - a.x[0], by = b.x[1] - a.x[1];
    const double cx = c.x[0] - a.x[0], cy = c.x[1] - a.x[1];
    value = bx * cy - by * cx;
    magnitude = std::max(std::abs(bx), std::abs(cx)) * std::max(std::abs(by), std::abs(cy));
  } else {
    const Site<D>& b = sites[corners[1]];
    const Site<D>& c = sites[corners[2]];
    const Site<D>& d = sites[corners[3]];
    const double bx = b.x[0] - a.x[0], by = b.x[1] - a.x[1], bz = b.x[2] - a.x[2];
    const double cx = c.x[0] - a.x[0], cy = c.x[1] - a.x[1], cz = c.x[2] - a.x[2];
    const double dx = d.x[0] - a.x[0], dy = d.x[1] - a.x[1], dz = d.x[2] - a.x[2];
    value = bz * (cx * dy - cy * dx) - cz * (bx * dy - by * dx) + dz * (bx * cy - by * cx);
    magnitude = std::max(std::max(std::abs(bx), std::abs(cx)), std::abs(dx)) *
                std::max(std::max(std::abs(by), std::abs(cy)), std::abs(dy)) *
                std::max(std::max(std::abs(bz), std::abs(cz)), std::abs(dz));
  }
  return {value, kOrientBound<A> * magnitude + kUnderflow,
          sites.is_integral() && kOrientTerms<A> * magnitude <= kExactIntegers};
}

/// Stage 2: the same sign in wide integers, on any A axes. Exact on any finite numbers.
template <int A, int D>
[[nodiscard]] Sign exact_orient(const Sites<D>& sites, const Corners<A>& corners,
                                const std::array<int, std::size_t{A}>& axes);

/// Sign of det [1 p] over A + 1 sites, on their first A axes: positive for b right of a on a line,
/// for a counterclockwise triangle a, b, c, for a tetrahedron whose corner d sees a, b, c
/// counterclockwise. (1) Swapping two corners flips the sign. (2) Zero exactly if the sites are
/// affinely dependent (A == D). Exact.
template <int A, int D>
[[nodiscard]] inline Sign orient(const Sites<D>& sites, const Corners<A>& corners) {
  const FilteredDeterminant determinant = filtered_orient<A, D>(sites, corners);
  if (determinant.value > determinant.bound) return Sign::positive;
  if (determinant.value < -determinant.bound) return Sign::negative;
  if (determinant.is_exact) {
    return static_cast<Sign>((determinant.value > 0) - (determinant.value < 0));
  }
  std::array<int, std::size_t{A}> axes;
  for (int i = 0; i < A; ++i) axes[static_cast<std::size_t>(i)] = i;
  return exact_orient<A, D>(sites, corners, axes);
}

}  // namespace orthoball
