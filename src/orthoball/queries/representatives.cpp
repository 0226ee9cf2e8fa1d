// SPDX-License-Identifier: MIT
#include "orthoball/queries/representatives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/measures/compensated_sum.h"
#include "orthoball/queries/edge_rings.h"
#include "orthoball/topology/keyed_simplices.h"
#include "orthoball/vectors.h"

namespace orthoball {
namespace {

using Place = std::array<double, 3>;

// Length, area or volume of a simplex.
double size_of(const std::vector<Place>& corners) {
  const auto along = [&](std::size_t corner) { return difference(corners[corner], corners[0]); };
  if (corners.size() == 2) return std::sqrt(inner(along(1), along(1)));
  const Place normal = cross_product(along(1), along(2));
  if (corners.size() == 3) return std::sqrt(inner(normal, normal)) / 2;
  return std::abs(inner(normal, along(3))) / 6;
}

}  // namespace

template <int D>
Representatives<D>::Representatives(const Filtration<D>& filtration, const PersistencePairs<D>& all)
    : filtration_(filtration),
      all_(all),
      balls_(filtration, 0, -std::numeric_limits<double>::infinity()),
      ways_(filtration) {}

template <int D>
std::uint32_t Representatives<D>::usual_index(int dimension, const PersistencePair& pair) const {
  const std::uint32_t birth = filtration_.enters(pair.birth);
  if (dimension > 0 && dimension == filtration_.triangulation().affine_dimension() - 1) {
    return birth;
  }
  const std::uint32_t end =
      pair.death.exists() ? filtration_.enters(pair.death) : filtration_.never();
  const std::uint32_t last = std::max(birth, end - 1);
  if (dimension == 0 || !pair.death.exists()) return last;
  const double middle = filtration_.alpha2(birth) / 2 + filtration_.alpha2(end) / 2;
  return std::clamp(filtration_.index(middle), birth, last);
}

template <int D>
std::vector<Place> Representatives<D>::places(SimplexId simplex) const {
  std::vector<Place> result;
  for (const VertexId vertex : filtration_.vertices(simplex)) {
    Place& place = result.emplace_back(Place{});
    const auto& x = balls_.spheres()[vertex.row()].x;
    std::copy(x.begin(), x.end(), place.begin());
  }
  return result;
}

template <int D>
void Representatives<D>::add_component(Representative& result) const {
  const KeyedSimplices edges(filtration_, 1);
  std::vector<std::uint32_t> front{result.pair.birth.row()};
  std::set<std::uint32_t> seen(front.begin(), front.end());
  while (!front.empty()) {
    const std::uint32_t vertex = front.back();
    front.pop_back();
    for (const auto& [edge, to] : ways_.of(vertex)) {
      if (edges.enters(edge) > result.index) break;
      if (seen.insert(to).second) front.push_back(to);
    }
  }
  for (const std::uint32_t vertex : seen) {
    result.rows.push_back(filtration_.triangulation().sites().row(vertex));
  }
  result.cycle.push_back(result.pair.birth);
}

template <int D>
template <int A>
void Representatives<D>::add_void(Representative& result) const {
  const auto records = filtration_.triangulation().template cells<A>();
  const auto& table = filtration_.table();
  const KeyedSimplices cells(filtration_, A), facets(filtration_, A - 1);
  std::vector<std::uint32_t> front{cells.number(result.pair.death)};
  std::set<std::uint32_t> seen(front.begin(), front.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> walls;  // a facet, and the cell beyond
  while (!front.empty()) {
    const std::uint32_t cell = front.back();
    front.pop_back();
    for (unsigned corner = 0; corner <= A; ++corner) {
      const std::uint32_t facet = table.template facet_of_cell<A>(records, cell, corner);
      const std::uint32_t beyond = records[cell].neighbours[corner];
      if (facets.enters(facet) <= result.index) {
        walls.emplace_back(facet, beyond == kOutside ? kOutside : beyond / 4);
      } else if (seen.insert(beyond / 4).second) {
        front.push_back(beyond / 4);
      }
    }
  }
  for (const std::uint32_t cell : seen) result.cells.push_back(cells.id(cell));
  // A facet with the void on both sides is no part of what encloses it.
  for (const auto& [facet, beyond] : walls) {
    if (seen.count(beyond) == 0) result.cycle.push_back(facets.id(facet));
  }
  std::sort(result.cycle.begin(), result.cycle.end());
}

template <int D>
void Representatives<D>::add_tunnel(Representative& result) {
  if constexpr (D == 3) {
    const KeyedSimplices edges(filtration_, 1);
    if (!tunnels_) {
      std::vector<double> lengths(edges.count());
      for (std::uint32_t edge = 0; edge < lengths.size(); ++edge) {
        lengths[edge] = size_of(places(edges.id(edge)));
      }
      tunnels_.emplace(filtration_, all_, ways_, std::move(lengths));
    }
    for (const std::uint32_t edge :
         tunnels_->cycle(edges.number(result.pair.birth), result.index)) {
      result.cycle.push_back(edges.id(edge));
    }
  }
}

template <int D>
void Representatives<D>::measure(Representative& result) const {
  const auto& sites = filtration_.triangulation().sites();
  std::set<SiteId> rows;
  std::vector<std::array<std::uint32_t, 2>> edges;
  CompensatedSum size, volume;
  for (const SimplexId simplex : result.cycle) {
    size.add(size_of(places(simplex)));
    const auto vertices = filtration_.vertices(simplex);
    for (const VertexId vertex : vertices) rows.insert(sites.row(vertex.row()));
    if (result.dimension == 1) edges.push_back({vertices[0].row(), vertices[1].row()});
  }
  for (const SimplexId cell : result.cells) volume.add(size_of(places(cell)));
  result.rows.assign(rows.begin(), rows.end());
  for (const auto& ring : edge_rings(edges)) {
    auto& of_rows = result.rings.emplace_back();
    for (const std::uint32_t vertex : ring) of_rows.push_back(sites.row(vertex));
  }
  result.size = balls_.units(result.dimension)(size.value());
  result.volume = balls_.units(result.dimension + 1)(volume.value());
}

template <int D>
Representative Representatives<D>::at(int dimension, const PersistencePair& pair,
                                      std::uint32_t index) {
  const std::uint32_t birth = filtration_.enters(pair.birth);
  const std::uint32_t death =
      pair.death.exists() ? filtration_.enters(pair.death) : filtration_.never();
  if (index < birth || index >= death) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "the class does not live at index " + std::to_string(index) +
                         "; it is born at " + std::to_string(birth) + " and dies at " +
                         std::to_string(death));
  }
  Representative result;
  result.dimension = dimension;
  result.pair = pair;
  result.index = index;
  const int affine = filtration_.triangulation().affine_dimension();
  if (dimension == 0) {
    add_component(result);
    std::sort(result.rows.begin(), result.rows.end());
    return result;
  }
  if (dimension == affine - 1 && affine == 2) {
    add_void<2>(result);
  } else if (dimension == affine - 1) {
    if constexpr (D == 3) add_void<3>(result);
  } else {
    add_tunnel(result);
  }
  measure(result);
  return result;
}

template class Representatives<2>;
template class Representatives<3>;

}  // namespace orthoball
