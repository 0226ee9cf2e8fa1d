// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "orthoball/exact/four_lanes.h"
#include "orthoball/exact/orient.h"

namespace orthoball {

/// On which sides of its facets a point lies, as far as a glance tells: a bit for each facet.
struct GlancedOrients {
  std::uint32_t negative = 0;  ///< strictly beyond the facet
  std::uint32_t open = 0;      ///< not known
};

/// The orientations of a triangle with the query in the place of one corner after the other. What
/// is told is exact; little is left open on sites in general position. Costs little more than one
/// call of orient.
///
/// The query is the origin, and one bound holds for the three.
[[nodiscard, gnu::always_inline]] inline GlancedOrients glanced_orients_around(
    const Sites<2>& sites, const Corners<2>& corners, std::uint32_t query) {
  const Site<2>& a = sites[corners[0]];
  const Site<2>& b = sites[corners[1]];
  const Site<2>& c = sites[corners[2]];
  const Site<2>& q = sites[query];
  const double ax = a.x[0] - q.x[0], ay = a.x[1] - q.x[1];
  const double bx = b.x[0] - q.x[0], by = b.x[1] - q.x[1];
  const double cx = c.x[0] - q.x[0], cy = c.x[1] - q.x[1];
  const double bc = bx * cy - by * cx, ca = cx * ay - cy * ax, ab = ax * by - ay * bx;
  const double magnitude = std::max(std::max(std::abs(ax), std::abs(bx)), std::abs(cx)) *
                           std::max(std::max(std::abs(ay), std::abs(by)), std::abs(cy));
  const double bound = kOrientBound<2> * magnitude + kUnderflow;
  const auto mask = [](bool of_a, bool of_b, bool of_c) {
    return std::uint32_t{of_a} | std::uint32_t{of_b} << 1U | std::uint32_t{of_c} << 2U;
  };
  const std::uint32_t negative = mask(bc < -bound, ca < -bound, ab < -bound);
  const std::uint32_t positive = mask(bc > bound, ca > bound, ab > bound);
  const std::uint32_t open = 0b111U & ~(negative | positive);
  if (open == 0) [[likely]] {
    return {negative, 0};
  }
  const bool is_exact = sites.is_integral() && kOrientTerms<2> * magnitude <= kExactIntegers;
  if (!is_exact) return {negative, open};
  return {mask(bc < 0.0, ca < 0.0, ab < 0.0), 0};
}

#ifdef ORTHOBALL_WIDE_CODE

/// The orientations of a simplex with the query in the place of one corner after the other. What is
/// told is exact; little is left open on sites in general position. Costs as much as two calls of
/// orient. Only for processors with vectors of four doubles.
///
/// A vector lane for each facet, the query at the origin; docs/derivations/filters.md derives the
/// bound.
[[nodiscard]] ORTHOBALL_AVX2 inline GlancedOrients glanced_orients_around(const Sites<3>& sites,
                                                                          const Corners<3>& corners,
                                                                          std::uint32_t query) {
  using namespace four_lanes;
  const Columns cell = columns(sites, corners, loaded(sites[query]));
  // The facet of lane i has the corners i ^ 1, i ^ 2 and i ^ 3: an even permutation for every i.
  const Four x1 = turned1(cell.x), x2 = turned2(cell.x), x3 = turned1(x2);
  const Four y1 = turned1(cell.y), y2 = turned2(cell.y), y3 = turned1(y2);
  const Four z2 = turned2(cell.z);
  const Four value = turned1(cell.z) * (x2 * y3 - y2 * x3) - z2 * (x1 * y3 - y1 * x3) +
                     turned1(z2) * (x1 * y2 - y1 * x2);
  const Four squares = cell.x * cell.x + cell.y * cell.y + cell.z * cell.z;
  const Four pairs = squares + turned1(squares);
  const Four size = pairs + turned2(pairs);
  const Four magnitude = size * size * size;  // squared
  const Four bound = all(kOrientBound<3> * kOrientBound<3>) * magnitude;
  const std::uint32_t negative = signs(value < all(0.0));
  const std::uint32_t known = signs(value * value > bound + all(kUnderflow * kUnderflow));
  GlancedOrients result{negative & known, ~known & 0b1111U};
  if (result.open == 0 || !sites.is_integral()) return result;
  const double most = kExactIntegers / (2 * kOrientTerms<3>);
  const std::uint32_t exact = signs(magnitude <= all(most * most)) & result.open;
  result.negative |= exact & negative;
  result.open &= ~exact;
  return result;
}

#endif

}  // namespace orthoball
