// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/index_counts.h"
#include "orthoball/measures/complex_measures.h"
#include "orthoball/measures/contributions.h"
#include "orthoball/measures/input_units.h"
#include "orthoball/measures/sum_rows.h"
#include "orthoball/measures/term_bins.h"
#include "orthoball/parallel.h"
#include "orthoball/raw_vector.h"
#include "orthoball/topology/facet_roles.h"

namespace orthoball {

/// The measures of the alpha complexes of a filtration, one run of indices after the other.
///
/// Every simplex is measured once, along space; what it adds is dealt out to stretches of indices
/// and summed there. Within an index the order is that of dimension and number, but that a facet
/// which is never singular adds to the length with its first cell. Sums keep the errors of their
/// additions, so that intermediate values do not drift and the last agree with those of the convex
/// hull to 1e-12 relative. A facet's area enters and leaves as the same double: the areas are 0
/// exactly where no facet has the role.
///
/// Linear time. Terms wait in windows of indices, a sixth of all at a time: 90 bytes a site in
/// space.
template <int D>
class MeasureScan {
 public:
  /// Begins before index 0. Keeps references to the filtration and its roles.
  MeasureScan(const Filtration<D>& filtration, const FacetRoles<D>& roles,
              Threads threads = Threads(1));

  /// Goes on to the next run of indices; false behind the last.
  bool next();

  /// The run: one or more whole stretches, the last of which ends with the spectrum. The first
  /// begins with index 0.
  [[nodiscard]] std::uint32_t first_index() const { return first_stretch_ * kIndexStretch; }
  [[nodiscard]] std::uint32_t end_index() const;

  // What changes at the indices of the run, [index - first_index()].

  /// Edges in space, facets or cells that enter.
  [[nodiscard]] std::span<const std::uint32_t> entering(int dimension) const {
    return column(dimension == D ? kCells : dimension == D - 1 ? kFacets : kEdges);
  }
  /// Facets that become interior.
  [[nodiscard]] std::span<const std::uint32_t> becoming_interior() const {
    return column(kInteriorFacets);
  }

  /// How many facets have these roles at an index.
  struct FacetCounts {
    std::uint32_t singular, regular;
  };
  /// The measures at out.size() indices of the run from `index` on, all in one stretch.
  /// @param facets  theirs.
  void measures(std::uint32_t index, std::span<const FacetCounts> facets,
                std::span<ComplexMeasures> out) const;

 private:
  using SumRow = sum_rows_detail::SumRow;
  using Column = std::size_t;
  static constexpr Column kEdges = 0, kFacets = 1, kCells = 2, kInteriorFacets = 3, kColumns = 4;
  using LargeRow = std::array<std::int32_t, 4>;  // as in Four

  // The sums in one unit of length.
  struct Sums {
    Sums(const Contributions<D>& of, const sum_rows_detail::SumUnits& in)
        : contributions(of), units(in) {}

    Contributions<D> contributions;
    sum_rows_detail::SumUnits units;
    TermBins<1> edges;
    TermBins<2> facets;
    TermBins<6> cells;
    std::vector<SumRow> rows;     // [index - first_index()]: from the stretch's beginning on
    std::vector<SumRow> before;   // [stretch - first_stretch_]: up to its beginning
    std::vector<LargeRow> large;  // [index - first of the window]: up to it; may be empty
    LargeRow large_before{};      // up to the window's end
    SumRow total{};               // up to the run's end
  };
  struct Window {
    std::uint32_t begin, end;  // stretches
    std::size_t rounds;        // more than one where a single stretch has too many terms
  };

  // Where a piece of the simplices begins.
  struct Bound {
    std::uint32_t edge = 0, facet = 0, cell = 0;
  };
  template <class Bins, class Terms>
  class Filler;

  [[nodiscard]] std::uint32_t stretch_count() const;
  [[nodiscard]] std::span<const std::uint32_t> column(Column which) const {
    return columns_[which];
  }
  [[nodiscard]] std::vector<Bound> bounds(std::size_t pieces) const;
  [[nodiscard]] Bound bound_at(std::uint32_t cell) const;
  void count_terms();
  void plan_windows();
  void begin_window(const Window& window);
  void fill(Sums& sums, std::size_t round);
  void fill_part(Sums& sums, std::size_t part, Bound begin, const Bound& end);
  void sum_stretch(Sums& sums, std::uint32_t stretch);

  const Filtration<D>* filtration_;
  Threads threads_;
  const FacetRoles<D>& roles_;
  std::vector<Sums> sums_;  // the preferred unit first
  // [edges, facets, cells][part][stretch]: terms
  std::array<std::vector<std::vector<std::uint32_t>>, 3> term_counts_;
  std::vector<Window> windows_;
  std::size_t next_window_ = 0;
  Window window_{0, 0, 1};
  std::uint32_t first_stretch_ = 0, end_stretch_ = 0;  // the run
  std::array<BlockVector<std::uint32_t>, kColumns> columns_;
};

extern template class MeasureScan<2>;  // defined in measure_scan.cpp
extern template class MeasureScan<3>;

}  // namespace orthoball
