// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "orthoball/points/weighted_points.h"
#include "orthoball/triangulation/regular_triangulation.h"

namespace orthoball {

/// Everything in which `triangulation` is not the regular triangulation of `points`, in words;
/// empty if it is. For tests and fuzzing.
///
/// Checked exactly: every row is a vertex, hidden or a duplicate, and once; duplicates equal their
/// representatives; corners, neighbours and cells are in the order that CellRecord and
/// RegularTriangulation say; cells are connected and positively oriented; no vertex across a facet
/// is in conflict with the cell behind it, the hull included (local regularity, which implies the
/// global one); no hidden site is in conflict with the cell that contains it. At most 20 faults.
/// O(n) exact tests, and a walk for each hidden site.
template <int D>
[[nodiscard]] std::vector<std::string> verify(const RegularTriangulation<D>& triangulation,
                                              const WeightedPoints& points);

extern template std::vector<std::string> verify<2>(const RegularTriangulation<2>&,
                                                   const WeightedPoints&);
extern template std::vector<std::string> verify<3>(const RegularTriangulation<3>&,
                                                   const WeightedPoints&);

}  // namespace orthoball
