// SPDX-License-Identifier: MIT
#pragma once

#include "orthoball/exact/floating_point.h"

namespace orthoball {

// Forward error bounds of the double stages. Each is the bound on |computed - true| divided by the
// product of the largest magnitudes at hand; docs/derivations/filters.md derives them and
// filter_bounds_test checks them against exact values. They are rounded up generously: what a
// looser constant sends to the exact stage is one test in millions.

/// orient<A>: times the product of the largest coordinate difference on each axis.
template <int A>
inline constexpr double kOrientBound = A == 1   ? 2 * kRounding
                                       : A == 2 ? 16 * kRounding
                                                : 64 * kRounding;

/// power_side<A>: times the same product and the largest lift.
template <int A>
inline constexpr double kPowerSideBound = A == 1   ? 32 * kRounding
                                          : A == 2 ? 128 * kRounding
                                                   : 512 * kRounding;

/// Number of products of one entry per column in the expansion of each determinant: a determinant
/// of integers whose bound times this is at most 2^53 is exact in doubles, zero included.
template <int A>
inline constexpr double kOrientTerms = A == 1   ? 1
                                       : A == 2 ? 2
                                                : 6;
template <int A>
inline constexpr double kPowerSideTerms = A == 1   ? 2
                                          : A == 2 ? 6
                                                   : 24;

/// Added to every bound: more than underflow can lose in any of the determinants, as long as no
/// length exceeds 2^151 (kLargestMagnitude).
inline constexpr double kUnderflow = 0x1p-400;

/// Integers up to here are exact in doubles.
inline constexpr double kExactIntegers = 0x1p+53;

}  // namespace orthoball
