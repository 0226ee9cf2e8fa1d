// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>
#include <limits>

// Every filter bound and every error-free transformation here is proved for IEEE 754 doubles with
// each operation rounded to nearest on its own. Refuse to compile where that does not hold.
#if defined(__FAST_MATH__)
#error "orthoball must not be compiled with -ffast-math or its parts"
#endif
static_assert(std::numeric_limits<double>::is_iec559, "doubles must be IEEE 754");
static_assert(FLT_EVAL_METHOD == 0, "doubles must be evaluated as doubles: no x87 arithmetic");
// Fused multiply-adds change roundings: the build gives -ffp-contract=off, and error_free_test
// fails where a compiler fuses all the same.

namespace orthoball {

/// Half an ulp of 1: the largest relative error of one rounding.
inline constexpr double kRounding = 0x1p-53;

}  // namespace orthoball
