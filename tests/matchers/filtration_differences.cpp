// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

#include "matchers/agrees_with_brute_force.h"
#include "matchers/describe.h"
#include "orthoball/filtration/filter.h"

namespace orthoball::matchers {

namespace {

using Rows = std::vector<std::uint32_t>;

template <int D>
Rows rows_of(const Filtration<D>& filtration, SimplexId simplex) {
  Rows rows;
  for (const SiteId row : filtration.rows(simplex)) rows.push_back(row.row());
  return rows;
}

std::vector<Rows> facets_of(const Rows& rows) {
  std::vector<Rows> facets;
  for (std::size_t i = 0; rows.size() > 1 && i < rows.size(); ++i) {
    Rows facet = rows;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
    facets.push_back(facet);
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

// Faces as the filtration gives them, in the order of the vertex that each leaves out.
template <int D>
void compare_faces(const Filtration<D>& filtration, SimplexId simplex, Comparison& compare) {
  const Rows rows = rows_of(filtration, simplex);
  const std::string what = described(rows) + " ";
  std::vector<Rows> facets;
  std::size_t left_out = 0;
  for (const SimplexId facet : filtration.facets(simplex)) {
    facets.push_back(rows_of(filtration, facet));
    const auto vertices = filtration.vertices(facet);
    const VertexId vertex = filtration.vertices(simplex)[left_out++];
    compare(what + "facet contains the vertex it leaves out",
            std::find(vertices.begin(), vertices.end(), vertex) != vertices.end(), false);
  }
  std::sort(facets.begin(), facets.end());
  compare(what + "facets", facets, facets_of(rows));
}

template <int D>
void compare_cells_beside(const Filtration<D>& filtration, const oracles::BruteForce& expected,
                          Comparison& compare) {
  const int top = expected.affine_dimension;
  if (top < 1) return;
  std::map<Rows, std::vector<Rows>> cells;
  for (const oracles::BruteSimplex& simplex : expected.simplices) {
    if (simplex.dimension() != top) continue;
    for (const Rows& facet : facets_of(simplex.rows)) cells[facet].push_back(simplex.rows);
  }
  for (std::size_t i = 0; i < filtration.count(top - 1); ++i) {
    const SimplexId facet(filtration.table().first(top - 1) + static_cast<std::uint32_t>(i));
    std::vector<Rows> beside;
    for (const SimplexId cell : filtration.cells_beside(facet)) {
      beside.push_back(rows_of(filtration, cell));
    }
    std::sort(beside.begin(), beside.end());
    std::vector<Rows> expected_beside = cells[rows_of(filtration, facet)];
    std::sort(expected_beside.begin(), expected_beside.end());
    compare("cells beside " + described(rows_of(filtration, facet)), beside, expected_beside);
  }
}

template <int D>
void compare_spectrum(const Filtration<D>& filtration, const oracles::BruteForce& expected,
                      Comparison& compare) {
  std::vector<double> labels;
  for (const oracles::Rational& value : expected.spectrum) {
    labels.push_back(oracles::nearest_double(value));
  }
  const std::vector<double> spectrum(filtration.spectrum().begin(), filtration.spectrum().end());
  compare("spectrum", spectrum, labels);
  if (spectrum != labels) return;

  constexpr double infinity = std::numeric_limits<double>::infinity();
  compare("index below all", filtration.index(-infinity),
          static_cast<std::uint32_t>(std::count(labels.begin(), labels.end(), -infinity)));
  for (const double label : labels) {
    for (const double alpha2 :
         {label, std::nextafter(label, infinity), std::nextafter(label, -infinity)}) {
      const auto index = static_cast<std::uint32_t>(
          std::count_if(labels.begin(), labels.end(), [&](double x) { return x <= alpha2; }));
      compare("index of " + described(alpha2), filtration.index(alpha2), index);
    }
  }
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    if (expected.spectrum[i] == 0) compare("negative zero", std::signbit(spectrum[i]), false);
  }
}

}  // namespace

template <int D>
std::vector<std::string> differences(const Filtration<D>& filtration,
                                     const oracles::BruteForce& expected) {
  std::vector<std::string> found = differences(filtration.triangulation(), expected);
  if (!found.empty()) return found;
  Comparison compare(found);
  compare_spectrum(filtration, expected, compare);
  compare("size", filtration.size(), expected.simplices.size());

  const Filter<D> filter_by_number(filtration);
  const std::vector<SimplexId> filter = filter_by_number.by_rows();
  compare("length of the filter by rows", filter.size(), expected.simplices.size());
  compare("length of the filter", filter_by_number.simplices().size(), expected.simplices.size());
  if (!found.empty()) return found;
  for (std::size_t position = 0; position < filter.size(); ++position) {
    const SimplexId simplex = filter[position];
    const oracles::BruteSimplex& entry = expected.simplices[position];
    const std::string where = " at position " + std::to_string(position);
    compare("rows" + where, rows_of(filtration, simplex), entry.rows);
    const std::string what = " of " + described(entry.rows);
    compare("dimension" + what, filtration.dimension(simplex), entry.dimension());
    compare("attached" + what, filtration.is_attached(simplex), entry.is_attached);
    compare("enters" + what, filtration.enters(simplex), entry.enters);
    compare("regular" + what, filtration.regular(simplex), entry.regular);
    compare("interior" + what, filtration.interior(simplex), entry.interior);
    compare_faces(filtration, simplex, compare);
    // The other filter differs in the order of ties only, which it breaks by number.
    const SimplexId other = filter_by_number.simplices()[position];
    compare("index in the filter" + where, filtration.enters(other), entry.enters);
    compare("dimension in the filter" + where, filtration.dimension(other), entry.dimension());
    if (position > 0) {
      const SimplexId before = filter_by_number.simplices()[position - 1];
      const bool is_tie = filtration.enters(before) == entry.enters &&
                          filtration.dimension(before) == entry.dimension();
      compare("order of numbers" + where, is_tie && other <= before, false);
    }
  }
  for (int dimension = 0; dimension <= D; ++dimension) {
    const auto count = static_cast<std::size_t>(
        std::count_if(expected.simplices.begin(), expected.simplices.end(),
                      [&](const auto& simplex) { return simplex.dimension() == dimension; }));
    compare("count of dimension " + std::to_string(dimension), filtration.count(dimension), count);
  }
  for (std::uint32_t index = 0; index <= filtration.spectrum_size(); ++index) {
    const auto size = static_cast<std::size_t>(
        std::count_if(expected.simplices.begin(), expected.simplices.end(),
                      [&](const auto& simplex) { return simplex.enters <= index; }));
    compare("complex at " + std::to_string(index), filter_by_number.complex_size(index), size);
  }
  compare_cells_beside(filtration, expected, compare);
  return found;
}

template std::vector<std::string> differences(const Filtration<2>&, const oracles::BruteForce&);
template std::vector<std::string> differences(const Filtration<3>&, const oracles::BruteForce&);

}  // namespace orthoball::matchers
