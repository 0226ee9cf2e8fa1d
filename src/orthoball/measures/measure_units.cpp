// SPDX-License-Identifier: MIT
#include "orthoball/measures/measure_units.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

template <int D>
std::vector<Contributions<D>> contributions_of(const Filtration<D>& filtration,
                                               std::span<const std::uint8_t> roles) {
  if (!needs_input_units(filtration)) return {Contributions<D>(filtration, roles)};
  const int scaled = filtration.triangulation().sites().scale_exponent();
  return {Contributions<D>(filtration, roles, 0), Contributions<D>(filtration, roles, scaled)};
}

template <int D>
InputUnits input_units(const Filtration<D>& filtration, const Contributions<D>& contributions,
                       int power, int divisor) {
  return {power, contributions.unit_exponent(), filtration.triangulation().sites().decimals(),
          divisor};
}

template std::vector<Contributions<2>> contributions_of(const Filtration<2>&,
                                                        std::span<const std::uint8_t>);
template std::vector<Contributions<3>> contributions_of(const Filtration<3>&,
                                                        std::span<const std::uint8_t>);
template InputUnits input_units(const Filtration<2>&, const Contributions<2>&, int, int);
template InputUnits input_units(const Filtration<3>&, const Contributions<3>&, int, int);

}  // namespace orthoball
