// SPDX-License-Identifier: MIT
#include "orthoball/measures/complex_measures.h"

#include <cstddef>
#include <vector>

#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/measure_units.h"

namespace orthoball {
namespace {

// Calls `visit(terms, large)` for all simplices of a dimension that `is_wanted`, ascending.
template <class Terms, int D, class IsWanted, class Visit>
void for_each_contribution(const Contributions<D>& contributions, std::size_t count,
                           const IsWanted& is_wanted, const Visit& visit) {
  constexpr std::size_t kAtOnce = 1024;
  std::vector<std::uint32_t> simplices;
  std::vector<Terms> terms(kAtOnce);
  std::vector<LargeTerms> large(kAtOnce);
  const auto flush = [&] {
    contributions.measure(simplices, terms, large);
    for (std::size_t i = 0; i < simplices.size(); ++i) visit(terms[i], large[i]);
    simplices.clear();
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!is_wanted(i)) continue;
    simplices.push_back(i);
    if (simplices.size() == kAtOnce) flush();
  }
  flush();
}

}  // namespace

template <int D>
HullMeasures hull_measures(const Filtration<D>& filtration) {
  HullMeasures hull;
  const int affine_dimension = filtration.triangulation().affine_dimension();
  if (affine_dimension < D - 1) return hull;
  const bool is_full = affine_dimension == D;
  const std::uint32_t first_facet = filtration.table().first(D - 1);
  const auto all = [](std::uint32_t) { return true; };
  const auto ends_outside = [&](std::uint32_t facet) {
    return !is_full || filtration.interior(SimplexId(first_facet + facet)) == filtration.never();
  };
  bool has_volume = false, has_area = false;
  for (const Contributions<D>& contributions : contributions_of(filtration, {})) {
    CompensatedSum volume, area;
    bool has_large_volume = false, has_large_area = false;
    for_each_contribution<CellTerms>(contributions, filtration.count(D), all,
                                     [&](const CellTerms& cell, const LargeTerms& large) {
                                       volume.add(cell.volume);
                                       has_large_volume |= large.volume != 0;
                                     });
    for_each_contribution<FacetTerms>(contributions, filtration.count(D - 1), ends_outside,
                                      [&](const FacetTerms& facet, const LargeTerms& large) {
                                        area.add(facet.area);
                                        if (!is_full) area.add(facet.area);  // the other side
                                        has_large_area |= large.singular != 0;
                                      });
    if (!has_volume) {
      hull.volume = input_units(filtration, contributions, D, factorial(D))(volume.value());
      has_volume = !has_large_volume;
    }
    if (!has_area) {
      hull.area = input_units(filtration, contributions, D - 1, factorial(D - 1))(area.value());
      has_area = !has_large_area;
    }
  }
  return hull;
}

template HullMeasures hull_measures<2>(const Filtration<2>&);
template HullMeasures hull_measures<3>(const Filtration<3>&);

}  // namespace orthoball
