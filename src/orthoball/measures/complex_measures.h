// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// The measures of one alpha complex, in input units: rounded once from compensated sums, infinite
/// beyond the double range.
///
/// In space `volume` is that of the tetrahedra and the areas are those of triangles; in the plane
/// they are the area of the triangles and the lengths of edges. Intrinsic volumes in space: volume,
/// area / 2, length / (2 pi); mean width = length / (4 pi).  @cite schneider_weil_2008
struct ComplexMeasures {
  double volume = 0.0;         ///< of the cells; length^D
  double area_singular = 0.0;  ///< of singular facets, one side each; length^(D-1)
  double area_regular = 0.0;   ///< of regular facets, one side each; length^(D-1)
  double area = 0.0;           ///< two-sided: area_regular + 2 area_singular; length^(D-1)
  double length = 0.0;         ///< in space: sum of edge length x complementary angle; length
};

/// Volume of the convex hull and its two-sided area: the measures of the last complex. Coplanar
/// sites in space have volume 0 and twice the area of their polygon.
struct HullMeasures {
  double volume = 0.0;  ///< length^D
  double area = 0.0;    ///< length^(D-1)
};

/// The same sums as those of MeasureScan, without the order: agrees with it but for a last bit.
template <int D>
[[nodiscard]] HullMeasures hull_measures(const Filtration<D>& filtration);

}  // namespace orthoball
