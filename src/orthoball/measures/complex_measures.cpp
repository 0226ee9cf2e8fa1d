// SPDX-License-Identifier: MIT
//
// Volume: the cells' volumes. Areas: three sums that only grow, of the facets that have entered
// (E), that have become regular (R) and that have become interior (I); then the singular facets
// have E - R, the regular ones R - I, and the two-sided area is 2 E - R - I. A facet becomes
// regular when the first of its cells enters and interior when the second does, so both sums are
// fed by the cells. Length: an edge enters with 2 pi len, a triangle with -pi perimeter, a
// tetrahedron with the sum of len x exterior angle over its edges.
//
// All this is done in the scaled units of Sites, in which nothing leaves the double range. Where
// these are so much coarser than input units, or the sites so close, that values of a double's
// range would vanish, it is done twice. Sums in input units serve as long as they have no term
// beyond 2^960; after that, the scaled ones do, for then what they lack is far below the last bit.
#include "orthoball/measures/complex_measures.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "orthoball/filtration/face_vertices.h"

namespace orthoball {
namespace {

// In scaled units: edges of at least 2^-200 have fourth powers, the smallest intermediate results,
// well inside the double range.
constexpr double kShortestEdge = 0x1p-200;
// Coordinates that are 0 or at least this differ by 0 or at least kShortestEdge: their last bits
// are 2^-52 of them.
constexpr double kSmallestCoordinate = 0x1p-140;
// One input unit is at least 2^-50 scaled units, or what vanishes there can show here.
constexpr int kLeastScaleExponent = -50;

template <int D>
bool has_edge_below(const Filtration<D>& filtration, double length) {
  const Sites<D>& sites = filtration.triangulation().sites();
  const std::uint32_t first = filtration.table().first(1);
  for (std::uint32_t edge = 0; edge < filtration.count(1); ++edge) {
    const auto ends = face_vertices<2>(filtration, SimplexId(first + edge));
    double longest = 0.0;
    for (int axis = 0; axis < D; ++axis) {
      longest = std::max(longest, std::abs(sites[ends[1]].x[axis] - sites[ends[0]].x[axis]));
    }
    if (longest < length) return true;
  }
  return false;
}

template <int D>
bool needs_input_units(const Filtration<D>& filtration) {
  const Sites<D>& sites = filtration.triangulation().sites();
  if (sites.decimals() != 0) return false;  // integers below 2^53
  if (sites.scale_exponent() < kLeastScaleExponent) return true;
  for (const Site<D>& site : sites.span()) {
    for (const double x : site.x) {
      if (x != 0.0 && std::abs(x) < kSmallestCoordinate) {
        return has_edge_below(filtration, kShortestEdge);
      }
    }
  }
  return false;
}

// The ways to measure a filtration, the preferred first.
template <int D>
std::vector<Contributions<D>> contributions_of(const Filtration<D>& filtration) {
  if (!needs_input_units(filtration)) return {Contributions<D>(filtration)};
  const int scaled = filtration.triangulation().sites().scale_exponent();
  return {Contributions<D>(filtration, 0), Contributions<D>(filtration, scaled)};
}

template <int D>
InputUnits input_units(const Filtration<D>& filtration, const Contributions<D>& contributions,
                       int power, int divisor) {
  return {power, contributions.unit_exponent(), filtration.triangulation().sites().decimals(),
          divisor};
}

// Calls `visit(contribution)` for all simplices of a dimension that `is_wanted`, ascending.
template <class Contribution, int D, class IsWanted, class Visit>
void for_each_contribution(const Filtration<D>& filtration, const Contributions<D>& contributions,
                           int dimension, const IsWanted& is_wanted, const Visit& visit) {
  constexpr std::size_t kAtOnce = 1024;
  std::vector<std::uint32_t> simplices;
  std::vector<Contribution> measured(kAtOnce);
  const auto flush = [&] {
    contributions.measure(simplices, measured);
    for (std::size_t i = 0; i < simplices.size(); ++i) visit(measured[i]);
    simplices.clear();
  };
  const std::uint32_t first = filtration.table().first(dimension);
  for (std::uint32_t i = 0; i < filtration.count(dimension); ++i) {
    if (!is_wanted(SimplexId(first + i))) continue;
    simplices.push_back(first + i);
    if (simplices.size() == kAtOnce) flush();
  }
  flush();
}

constexpr int factorial(int n) { return n <= 1 ? 1 : n * factorial(n - 1); }

}  // namespace

template <int D>
MeasureScan<D>::Sums::Sums(const Filtration<D>& filtration, Contributions<D> contributions)
    : cells(filtration, contributions, D),
      facets(filtration, contributions, D - 1),
      edges(filtration, contributions, 1),
      volume_units(input_units(filtration, contributions, D, factorial(D))),
      area_units(input_units(filtration, contributions, D - 1, factorial(D - 1))),
      length_units(input_units(filtration, contributions, 1, 1)) {}

template <int D>
MeasureScan<D>::MeasureScan(const Filtration<D>& filtration) {
  for (const Contributions<D>& contributions : contributions_of(filtration)) {
    sums_.emplace_back(filtration, contributions);
  }
}

template <int D>
void MeasureScan<D>::advance(const ByDimension<D>& entering) {
  facets_entered_ += entering[kOfFacets];
  cells_are_new_ |= entering[D] != 0;
  facets_are_new_ |= entering[kOfFacets] != 0;
  for (Sums& sums : sums_) advance(entering, sums);
}

template <int D>
void MeasureScan<D>::advance(const ByDimension<D>& entering, Sums& sums) {
  if constexpr (D == 3) {
    for (std::uint32_t i = 0; i < entering[1]; ++i) sums.edge_length.add(sums.edges.next());
  }
  for (std::uint32_t i = 0; i < entering[kOfFacets]; ++i) {
    const FacetContribution& facet = sums.facets.next();
    sums.area_entered.add(facet.area);
    if constexpr (D == 3) sums.perimeter.add(facet.perimeter);
  }
  for (std::uint32_t i = 0; i < entering[D]; ++i) {
    const CellContribution<D>& cell = sums.cells.next();
    sums.volume.add(cell.volume);
    if constexpr (D == 3) sums.cell_length.add(cell.length);
    for (const double area : cell.facets) {
      const bool is_second = std::signbit(area);
      (is_second ? sums.area_interior : sums.area_regular_ever).add(std::abs(area));
      if (&sums != sums_.data()) continue;
      ++(is_second ? facets_interior_ : facets_regular_ever_);
    }
  }
}

template <int D>
const ComplexMeasures& MeasureScan<D>::measures() {
  if (cells_are_new_) read_volume();
  if (cells_are_new_ || facets_are_new_) read_areas();
  if constexpr (D == 3) read_length();
  cells_are_new_ = facets_are_new_ = false;
  return measures_;
}

template <int D>
void MeasureScan<D>::read_volume() {
  const Sums& s = without(sums_.front().volume.large_count());
  measures_.volume = s.volume_units(s.volume.value());
}

template <int D>
void MeasureScan<D>::read_areas() {
  const Sums& front = sums_.front();
  const std::uint64_t singular_missing =
      front.area_entered.large_count() - front.area_regular_ever.large_count();
  const std::uint64_t regular_missing =
      front.area_regular_ever.large_count() - front.area_interior.large_count();
  measures_.area_singular = measures_.area_regular = measures_.area = 0.0;
  if (facets_entered_ != facets_regular_ever_) {
    const Sums& s = without(singular_missing);
    measures_.area_singular = s.area_units(s.area_entered.value() - s.area_regular_ever.value());
  }
  if (facets_regular_ever_ != facets_interior_) {
    const Sums& s = without(regular_missing);
    measures_.area_regular = s.area_units(s.area_regular_ever.value() - s.area_interior.value());
  }
  if (facets_entered_ != facets_interior_) {
    const Sums& s = without(singular_missing + regular_missing);
    const DoubleDouble entered = s.area_entered.value();
    measures_.area =
        s.area_units((entered - s.area_interior.value()) + (entered - s.area_regular_ever.value()));
  }
}

template <int D>
void MeasureScan<D>::read_length() {
  const Sums& front = sums_.front();
  const Sums& s = without(front.edge_length.large_count() + front.perimeter.large_count() +
                          front.cell_length.large_count());
  const DoubleDouble edges = s.edge_length.value();
  const DoubleDouble straight = (edges + edges) - s.perimeter.value();
  measures_.length = s.length_units(kPi * straight + s.cell_length.value());
}

template <int D>
HullMeasures hull_measures(const Filtration<D>& filtration) {
  HullMeasures hull;
  const int affine_dimension = filtration.triangulation().affine_dimension();
  if (affine_dimension < D - 1) return hull;
  const bool is_full = affine_dimension == D;
  const auto all = [](SimplexId) { return true; };
  const auto ends_outside = [&](SimplexId facet) {
    return !is_full || filtration.interior(facet) == filtration.never();
  };
  bool has_volume = false, has_area = false;
  for (const Contributions<D>& contributions : contributions_of(filtration)) {
    CompensatedSum volume, area;
    for_each_contribution<CellContribution<D>>(
        filtration, contributions, D, all,
        [&](const CellContribution<D>& cell) { volume.add(cell.volume); });
    for_each_contribution<FacetContribution>(filtration, contributions, D - 1, ends_outside,
                                             [&](const FacetContribution& facet) {
                                               area.add(facet.area);
                                               if (!is_full)
                                                 area.add(facet.area);  // the other side
                                             });
    if (!has_volume) {
      hull.volume = input_units(filtration, contributions, D, factorial(D))(volume.value());
      has_volume = volume.large_count() == 0;
    }
    if (!has_area) {
      hull.area = input_units(filtration, contributions, D - 1, factorial(D - 1))(area.value());
      has_area = area.large_count() == 0;
    }
  }
  return hull;
}

template class MeasureScan<2>;
template class MeasureScan<3>;
template HullMeasures hull_measures<2>(const Filtration<2>&);
template HullMeasures hull_measures<3>(const Filtration<3>&);

}  // namespace orthoball
