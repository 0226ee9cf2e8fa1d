// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orthoball/filtration/filter_steps.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/contribution_stream.h"
#include "orthoball/measures/contributions.h"
#include "orthoball/measures/input_units.h"

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

/// The measures of the alpha complexes of a filtration, one after the other.
///
/// Every sum runs over the simplices by (index, dimension, number) and keeps the errors of its
/// additions, so that intermediate values do not drift and the last agree with those of the convex
/// hull to 1e-12 relative. A facet's area enters and leaves as the same double: the areas are 0
/// exactly where no facet has the role.
///
/// Amortised constant time a simplex; at most 120 MB, whatever the size of the filtration.
template <int D>
class MeasureScan {
 public:
  /// Begins with the empty complex. Keeps a reference to the filtration.
  explicit MeasureScan(const Filtration<D>& filtration);

  /// Adds the next simplices of filtration.filter(): `entering[k]` of dimension k. Together they
  /// must be all simplices of one or more indices.
  void advance(const ByDimension<D>& entering);

  /// Of all simplices added. Rounds anew what has changed since it was last asked.
  [[nodiscard]] const ComplexMeasures& measures();

 private:
  // The sums in one unit of length.
  struct Sums {
    Sums(const Filtration<D>& filtration, Contributions<D> contributions);

    ContributionStream<D, CellContribution<D>> cells;
    ContributionStream<D, FacetContribution> facets;
    ContributionStream<D, EdgeContribution> edges;
    CompensatedSum volume;
    CompensatedSum area_entered, area_regular_ever, area_interior;  // of facets that became so
    CompensatedSum edge_length, perimeter, cell_length;
    InputUnits volume_units, area_units, length_units;
  };

  static constexpr std::size_t kOfFacets = kCorners<D> - 2;

  void advance(const ByDimension<D>& entering, Sums& sums);
  void read_volume();
  void read_areas();
  void read_length();
  // The sums to read: the preferred ones, unless terms that are part of the result are missing.
  [[nodiscard]] const Sums& without(std::uint64_t missing) const {
    return missing == 0 ? sums_.front() : sums_.back();
  }

  std::vector<Sums> sums_;  // the preferred unit first
  std::uint32_t facets_entered_ = 0, facets_regular_ever_ = 0, facets_interior_ = 0;
  bool cells_are_new_ = false, facets_are_new_ = false;
  ComplexMeasures measures_;
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

extern template class MeasureScan<2>;  // defined in complex_measures.cpp
extern template class MeasureScan<3>;

}  // namespace orthoball
