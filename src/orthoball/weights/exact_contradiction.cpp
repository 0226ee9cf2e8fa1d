// SPDX-License-Identifier: MIT
//
// With the height h_u = |u|^2 - w_u of a site and an affine function l for each simplex, the
// simplices are held by some weights if and only if
//
//     h_v - l(v) = 0 for the corners of each,   h_u - l(u) > 0 for the others
//
// have a solution. They have none if and only if factors of these conditions, none negative for the
// others and not all of these 0, make the sum of the left sides 0 for all h and l (Motzkin's
// transposition theorem): for each site the factors of its conditions sum up to 0, and for each
// simplex those of its conditions do, alone and times the coordinates of their sites.
//
// The solver tells such factors in doubles. Here the equations are solved in rational numbers: of
// the factors that can be chosen, the smallest of others, each is taken as it was told, the rest
// follow. Signs are then seen exactly.
#include "orthoball/weights/exact_contradiction.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <map>
#include <utility>

namespace orthoball {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Equation = std::map<std::size_t, Rational>;  // column: its coefficient, not 0

constexpr std::size_t kMostConditions = 2000;

bool is_corner(const SiteTuple& simplex, std::uint32_t site) {
  return std::find(simplex.begin(), simplex.end(), site) != simplex.end();
}

// One condition is one column.
template <int D>
std::vector<Equation> equations(const DistinctSites<D>& sites, std::span<const SiteTuple> simplices,
                                const std::vector<WitnessCondition>& conditions) {
  std::map<std::pair<std::size_t, std::size_t>, Equation> of_simplex;  // and axis; D: alone
  std::map<std::uint32_t, Equation> of_site;
  for (std::size_t column = 0; column < conditions.size(); ++column) {
    const auto& [simplex, site, factor] = conditions[column];
    const std::uint32_t origin = simplices[simplex][0];
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Rational x = Rational(sites.x[site][axis]) - Rational(sites.x[origin][axis]);
      if (x != 0) of_simplex[{simplex, axis}][column] = x;
    }
    of_simplex[{simplex, D}][column] = 1;
    of_site[site][column] = 1;
  }
  std::vector<Equation> all;
  for (auto& [where, equation] : of_simplex) all.push_back(std::move(equation));
  for (auto& [where, equation] : of_site) all.push_back(std::move(equation));
  return all;
}

// to += factor * what
void add_multiple(Equation& to, const Rational& factor, const Equation& what) {
  for (const auto& [column, coefficient] : what) {
    Rational& sum = to[column];
    sum += factor * coefficient;
    if (sum == 0) to.erase(column);
  }
}

// Values that solve the equations: those given where a column is free, columns in front being
// solved for first.
std::vector<Rational> solution(std::vector<Equation> equations, std::vector<Rational> values) {
  std::vector<std::pair<std::size_t, Equation>> solved;  // for a column, whose coefficient is 1
  for (std::size_t column = 0; column < values.size(); ++column) {
    // The shortest, so that few become longer.
    auto pivot = equations.end();
    for (auto at = equations.begin(); at != equations.end(); ++at) {
      const bool is_shorter = pivot == equations.end() || at->size() < pivot->size();
      if (at->contains(column) && is_shorter) pivot = at;
    }
    if (pivot == equations.end()) continue;
    Equation chosen = std::move(*pivot);
    equations.erase(pivot);
    const Rational first = chosen.at(column);
    for (auto& [other, coefficient] : chosen) coefficient /= first;
    for (Equation& equation : equations) {
      const auto at = equation.find(column);
      if (at != equation.end()) add_multiple(equation, Rational(-at->second), chosen);
    }
    solved.emplace_back(column, std::move(chosen));
  }
  for (auto at = solved.rbegin(); at != solved.rend(); ++at) {
    const auto& [column, equation] = *at;
    Rational sum = 0;
    for (const auto& [other, coefficient] : equation) {
      if (other != column) sum -= coefficient * values[other];
    }
    values[column] = sum;
  }
  return values;
}

}  // namespace

template <int D>
std::vector<std::size_t> exact_contradiction(const DistinctSites<D>& sites,
                                             std::span<const SiteTuple> simplices,
                                             std::span<const WitnessCondition> conditions) {
  if (conditions.size() > kMostConditions) return {};
  const auto is_of_corner = [&](const WitnessCondition& one) {
    return is_corner(simplices[one.simplex], one.site);
  };
  std::vector<WitnessCondition> columns;
  for (const WitnessCondition& one : conditions) {
    if (is_of_corner(one) || one.factor > 0.0) columns.push_back(one);  // else of rounding
  }
  std::stable_sort(columns.begin(), columns.end(), [&](const auto& a, const auto& b) {
    const bool a_first = is_of_corner(a), b_first = is_of_corner(b);
    return a_first != b_first ? a_first : !a_first && a.factor > b.factor;
  });
  std::vector<Rational> told;
  for (const WitnessCondition& one : columns) told.emplace_back(one.factor);
  const auto factors = solution(equations(sites, simplices, columns), std::move(told));

  std::vector<std::size_t> named;
  bool is_positive = false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (factors[i] == 0) continue;
    named.push_back(columns[i].simplex);
    if (is_of_corner(columns[i])) continue;
    if (factors[i] < 0) return {};
    is_positive = true;
  }
  if (!is_positive) return {};
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
  return named;
}

template std::vector<std::size_t> exact_contradiction<2>(const DistinctSites<2>&,
                                                         std::span<const SiteTuple>,
                                                         std::span<const WitnessCondition>);
template std::vector<std::size_t> exact_contradiction<3>(const DistinctSites<3>&,
                                                         std::span<const SiteTuple>,
                                                         std::span<const WitnessCondition>);

}  // namespace orthoball
