// SPDX-License-Identifier: MIT
//
// One pass over the indices, with the Betti numbers and the numbers of simplices by role, keeps for
// each notable alpha the first index that has its property, or the first since the property last
// failed. What needs cells alone is found without order where it can be: the index at which the
// last vertex comes into a cell is a maximum of minima, and which cells are there by then does not
// depend on the order in which they came.
#include "orthoball/signatures/notable_alphas.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "orthoball/filtration/alpha.h"
#include "orthoball/filtration/index_counts.h"
#include "orthoball/signatures/role_counts.h"
#include "orthoball/topology/betti.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

using MaybeIndex = std::optional<std::uint32_t>;

// The run of constant betti k that is longest in alpha so far. A run ends when another begins.
class LongestRun {
 public:
  // `betti` is 0 where the index does not count.
  void visit(std::uint32_t index, double alpha, std::uint32_t betti) {
    if (betti == betti_) return;
    if (betti_ > 0 && alpha - first_alpha_ > extent_) {
      extent_ = alpha - first_alpha_;
      longest_ = first_;
    }
    betti_ = betti;
    first_ = index;
    first_alpha_ = alpha;
  }
  [[nodiscard]] MaybeIndex longest() const { return longest_; }

 private:
  std::uint32_t betti_ = 0, first_ = 0;
  double first_alpha_ = 0.0, extent_ = -1.0;
  MaybeIndex longest_;
};

// The first index since a property last failed, if it holds at the last visited.
class Since {
 public:
  void visit(std::uint32_t index, bool holds) {
    if (!holds) first_.reset();
    if (holds && !first_) first_ = index;
  }
  [[nodiscard]] MaybeIndex first() const { return first_; }

 private:
  MaybeIndex first_;
};

// Every vertex of a cell, by number.
template <int D>
const std::array<std::uint32_t, static_cast<std::size_t>(D) + 1>& corners_of(
    const Filtration<D>& filtration, std::uint32_t cell) {
  return filtration.triangulation().template cells<D>()[cell].corners;
}

template <int D>
MaybeIndex all_vertices_in_cells(const Filtration<D>& filtration) {
  if (filtration.count(D) == 0) return {};
  std::vector<std::uint32_t> first_cell(filtration.count(0), filtration.never());
  for (std::uint32_t cell = 0; cell < filtration.count(D); ++cell) {
    const std::uint32_t enters = filtration.enters(SimplexId(filtration.table().first(D) + cell));
    for (const std::uint32_t vertex : corners_of(filtration, cell)) {
      first_cell[vertex] = std::min(first_cell[vertex], enters);
    }
  }
  return *std::max_element(first_cell.begin(), first_cell.end());
}

// `covered` is the index at which all vertices are in cells. From there on cells only join
// components.
template <int D>
MaybeIndex one_region(const Filtration<D>& filtration, MaybeIndex covered) {
  if (!covered) return {};
  const std::uint32_t first = filtration.table().first(D);
  UnionFind regions(filtration.count(0));
  const auto join = [&](std::uint32_t cell) {
    const auto& corners = corners_of(filtration, cell);
    for (std::size_t i = 1; i < corners.size(); ++i) regions.unite(corners[0], corners[i]);
  };
  const std::span<const std::uint32_t> enters = filtration.enters().subspan(first);
  for (std::uint32_t cell = 0; cell < enters.size(); ++cell) {
    if (enters[cell] <= *covered) join(cell);
  }
  if (regions.set_count() == 1) return covered;
  std::vector<std::uint32_t> joints;  // cells with corners in several regions: few
  for (std::uint32_t cell = 0; cell < enters.size(); ++cell) {
    const auto& corners = corners_of(filtration, cell);
    const std::uint32_t region = regions.find(corners[0]);
    const bool is_joint =
        std::any_of(corners.begin() + 1, corners.end(),
                    [&](std::uint32_t corner) { return regions.find(corner) != region; });
    if (is_joint) joints.push_back(cell);
  }
  std::sort(joints.begin(), joints.end(),
            [&](std::uint32_t a, std::uint32_t b) { return enters[a] < enters[b]; });
  for (const std::uint32_t cell : joints) {
    join(cell);
    if (regions.set_count() == 1) return enters[cell];
  }
  return {};  // not reached: all cells together are the convex hull
}

// At which indices the facets become interior.
template <int D>
IndexCounts interior_facets(const Filtration<D>& filtration) {
  const std::uint32_t first = filtration.table().first(D - 1), end = filtration.table().first(D);
  return {filtration.never(), [&](const auto& visit) {
            for (std::uint32_t facet = first; facet < end; ++facet) {
              visit(filtration.interior(SimplexId(facet)));
            }
          }};
}

template <int D>
NotableAlpha notable(const Filtration<D>& filtration, std::string name, std::string reason,
                     MaybeIndex index) {
  const double alpha2 = index ? filtration.alpha2(*index) : 0.0;
  return {std::move(name), std::move(reason), index, alpha2, alpha_from_alpha2(alpha2)};
}

// [k]
constexpr std::array<const char*, 3> kGapReasons{
    "longest stretch of alpha with one number of components, all vertices in",
    "longest stretch of alpha with one number of tunnels, at least one",
    "longest stretch of alpha with one number of voids, at least one"};

}  // namespace

template <int D>
std::vector<NotableAlpha> notable_alphas(const Filtration<D>& filtration) {
  MaybeIndex all_vertices, solid;
  Since connected, solid_from;
  std::array<LongestRun, static_cast<std::size_t>(D)> gaps;
  {
    BettiScan<D> betti_scan(filtration);
    RoleCounts<D> roles(filtration);
    std::array<RoleChangeCounts<D>, std::size_t{D} - 1> lower;  // below the facets
    for (std::size_t k = 0; k < lower.size(); ++k) {
      lower[k] = {filtration, static_cast<int>(k), Threads(1)};
    }
    IndexCounts facets = interior_facets(filtration);
    while (betti_scan.next()) {
      const std::uint32_t index = betti_scan.index();
      RoleChanges<D> changes;
      changes.entering = betti_scan.entering();
      for (std::size_t k = 0; k < lower.size(); ++k) {
        changes.regular[k] = lower[k].regular.count(index);
        changes.interior[k] = lower[k].interior.count(index);
      }
      changes.interior[D - 1] = facets.count(index);
      roles.advance(changes);
      const BettiNumbers<D> betti = betti_scan.betti();
      const bool has_all = roles.has_all_vertices();
      if (has_all && !all_vertices) all_vertices = index;
      connected.visit(index, has_all && betti[0] == 1);
      const bool is_solid = has_all && betti[0] == 1 && roles.has_no_singular();
      if (is_solid && !solid) solid = index;
      solid_from.visit(index, is_solid);
      const double alpha = alpha_from_alpha2(filtration.alpha2(index));
      gaps[0].visit(index, alpha, has_all ? betti[0] : 0);
      for (std::size_t k = 1; k < gaps.size(); ++k) gaps[k].visit(index, alpha, betti[k]);
    }
  }
  const MaybeIndex covered = all_vertices_in_cells(filtration);
  const std::string cells = D == 3 ? "tetrahedra" : "triangles";
  std::vector<NotableAlpha> result{
      notable(filtration, "all_vertices", "every vertex is in the complex", all_vertices),
      notable(filtration, "all_vertices_in_cells",
              "every vertex is a corner of one of its " + cells, covered),
      notable(filtration, "connected", "one component with every vertex from here on",
              connected.first()),
      notable(filtration, "one_region", "its " + cells + " form one region with every vertex",
              one_region(filtration, covered)),
      notable(filtration, "solid", "one component with every vertex, nothing of it singular",
              solid),
      notable(filtration, "solid_from", "solid from here on", solid_from.first())};
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    result.push_back(
        notable(filtration, "gap_" + std::to_string(k), kGapReasons[k], gaps[k].longest()));
  }
  return result;
}

template <int D>
NotableAlpha automatic_alpha(const Filtration<D>& filtration, std::span<const NotableAlpha> notable,
                             WeightMeaning weights) {
  if (weights == WeightMeaning::molecule_radii) {
    return {"dual_complex", "the molecule itself: weights are the radii of its atoms",
            filtration.index(0.0), 0.0, 0.0};
  }
  const auto named = [&](const std::string& name) {
    return std::find_if(notable.begin(), notable.end(), [&](const NotableAlpha& alpha) {
      return alpha.name == name && alpha.index;
    });
  };
  if (weights == WeightMeaning::none) {
    if (const auto solid = named("solid"); solid != notable.end()) return *solid;
  }
  if (const auto connected = named("connected"); connected != notable.end()) return *connected;
  return {"empty", "there are no sites", 0, 0.0, 0.0};
}

template std::vector<NotableAlpha> notable_alphas<2>(const Filtration<2>&);
template std::vector<NotableAlpha> notable_alphas<3>(const Filtration<3>&);
template NotableAlpha automatic_alpha<2>(const Filtration<2>&, std::span<const NotableAlpha>,
                                         WeightMeaning);
template NotableAlpha automatic_alpha<3>(const Filtration<3>&, std::span<const NotableAlpha>,
                                         WeightMeaning);

}  // namespace orthoball
