// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "orthoball/exact/orient.h"
#include "orthoball/exact/power_side.h"

namespace orthoball {

/// Whether site a comes before site b in the order of positions: lexicographic by coordinates. The
/// order is total on sites of different centres, the only ones a tie can be about. Exact.
template <int D>
[[nodiscard]] bool precedes(const Sites<D>& sites, std::uint32_t a, std::uint32_t b);

/// Stage 3 of `in_conflict`: decides a tie of the power test by symbolic perturbation.
///
/// The weight of the site of rank i in the order of positions is lowered by eps_i, where
/// 0 < eps_1 << eps_2 << ...: the largest position dominates. Write query = sum lambda_i p_i with
/// sum lambda_i = 1 over the corners p_i. Among the query and the corners with lambda_i != 0 take
/// the one of highest rank: if it is the query, there is no conflict; otherwise there is one
/// exactly if its lambda_i > 0. Never ties.
/// @param corners  of a positively oriented simplex.
/// @cite edelsbrunner_mucke_1990
template <int A, int D>
[[nodiscard]] bool perturbed_conflict(const Sites<D>& sites, const Corners<A>& corners,
                                      std::uint32_t query);

/// Whether `query` invalidates a positively oriented simplex of the regular triangulation. Exact,
/// ties decided by perturbation.
template <int A, int D>
[[nodiscard]] inline bool in_conflict(const Sites<D>& sites, const Corners<A>& corners,
                                      std::uint32_t query) {
  const Sign side = power_side<A, D>(sites, corners, query);
  return side == Sign::zero ? perturbed_conflict<A, D>(sites, corners, query)
                            : side == Sign::positive;
}

}  // namespace orthoball
