// SPDX-License-Identifier: MIT
#include "orthoball/queries/manifold_solid.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "orthoball/measures/cell_gap.h"
#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/manifold_repair.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Calls `visit(cell, corner)` for every facet of the solid's boundary, opposite a corner of one of
// its cells.
template <int D, class Visit>
void for_each_boundary_facet(std::span<const CellRecord<D>> cells, const std::vector<bool>& solid,
                             const Visit& visit) {
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    if (!solid[cell]) continue;
    for (std::uint32_t corner = 0; corner <= D; ++corner) {
      const std::uint32_t beyond = cells[cell].neighbours[corner];
      if (beyond == kOutside || !solid[beyond / 4]) visit(cell, corner);
    }
  }
}

// The edges in space with more than two boundary triangles.
std::uint32_t crowded_edges(std::span<const CellRecord<3>> cells, const std::vector<bool>& solid) {
  std::vector<std::uint64_t> sides;
  for_each_boundary_facet<3>(cells, solid, [&](std::uint32_t cell, std::uint32_t opposite) {
    const auto& corners = cells[cell].corners;
    for (std::uint32_t other = 0; other < 4; ++other) {
      if (other == opposite) continue;
      std::array<std::uint32_t, 2> ends{};
      std::size_t count = 0;
      for (std::uint32_t i = 0; i < 4; ++i) {
        if (i != opposite && i != other) ends[count++] = corners[i];
      }
      const auto [low, high] = std::minmax(ends[0], ends[1]);
      sides.push_back(std::uint64_t{low} << 32U | high);
    }
  });
  std::sort(sides.begin(), sides.end());
  std::uint32_t result = 0;
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end] == sides[first]) ++end;
    if (end - first > 2) ++result;
  }
  return result;
}

template <int D>
class Describing {
 public:
  Describing(const Filtration<D>& filtration, const ScaledBalls<D>& balls,
             const ManifoldRepair<D>& repair)
      : filtration_(filtration),
        cells_(filtration.triangulation().template cells<D>()),
        balls_(balls),
        repair_(repair) {}

  void measure(ManifoldSolid<D>& result) const;
  [[nodiscard]] std::vector<SolidChange<D>> changes() const;

 private:
  [[nodiscard]] SolidChange<D> change(std::span<const std::uint32_t> cells) const;

  const Filtration<D>& filtration_;
  std::span<const CellRecord<D>> cells_;
  const ScaledBalls<D>& balls_;
  const ManifoldRepair<D>& repair_;
};

template <int D>
void Describing<D>::measure(ManifoldSolid<D>& result) const {
  const std::vector<bool>& solid = repair_.solid();
  CompensatedSum volume, area;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    if (!solid[cell]) continue;
    ++result.cell_count;
    volume.add(repair_.volume(cell));
  }
  UnionFind surfaces(filtration_.count(0));
  std::vector<bool> is_on_boundary(filtration_.count(0), false);
  std::int64_t facets = 0;
  for_each_boundary_facet<D>(cells_, solid, [&](std::uint32_t cell, std::uint32_t opposite) {
    const auto& corners = cells_[cell].corners;
    std::array<Sphere<D>, std::size_t{D} + 1> placed;
    for (std::size_t i = 0; i <= D; ++i) {
      placed[i] = balls_.spheres()[corners[i]];
      if (i == opposite) continue;
      is_on_boundary[corners[i]] = true;
      surfaces.unite(corners[opposite == 0 ? 1 : 0], corners[i]);
    }
    area.add(facet_size(placed, opposite));
    ++facets;
  });
  std::int64_t vertices = 0;
  for (std::uint32_t vertex = 0; vertex < is_on_boundary.size(); ++vertex) {
    if (!is_on_boundary[vertex]) continue;
    ++vertices;
    if (surfaces.find(vertex) == vertex) ++result.surface_count;
  }
  // Every edge of a closed surface has two triangles: 3 F = 2 E.
  result.euler = D == 3 ? vertices - facets / 2 : vertices - facets;
  result.volume = balls_.units(D)(volume.value());
  result.area = balls_.units(D - 1)(area.value());
}

template <int D>
SolidChange<D> Describing<D>::change(std::span<const std::uint32_t> cells) const {
  SolidChange<D> result;
  result.is_added = repair_.solid()[cells[0]];
  CompensatedSum volume;
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t cell : cells) {
    volume.add(repair_.volume(cell));
    result.cells.emplace_back(filtration_.table().first(D) + cell);
    vertices.insert(vertices.end(), cells_[cell].corners.begin(), cells_[cell].corners.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (std::size_t axis = 0; axis < D; ++axis) {
    CompensatedSum sum;
    const auto count = static_cast<double>(vertices.size());
    for (const std::uint32_t vertex : vertices) {
      sum.add(balls_.spheres()[vertex].x[axis] / count);
    }
    result.centre[axis] = balls_.units(1)(sum.value());
  }
  for (const std::uint32_t vertex : vertices) {
    result.rows.push_back(filtration_.triangulation().sites().row(vertex));
  }
  std::sort(result.rows.begin(), result.rows.end());
  result.volume = balls_.units(D)(volume.value());
  return result;
}

template <int D>
std::vector<SolidChange<D>> Describing<D>::changes() const {
  const std::vector<std::uint32_t> changed = repair_.changed();
  const std::vector<bool>& solid = repair_.solid();
  const auto place_of = [&](std::uint32_t cell) {
    const auto found = std::lower_bound(changed.begin(), changed.end(), cell);
    return found != changed.end() && *found == cell
               ? static_cast<std::uint32_t>(found - changed.begin())
               : kNone;
  };
  UnionFind joined(changed.size());
  for (std::uint32_t place = 0; place < changed.size(); ++place) {
    for (const std::uint32_t beyond : cells_[changed[place]].neighbours) {
      const std::uint32_t other = beyond == kOutside ? kNone : place_of(beyond / 4);
      if (other != kNone && solid[changed[place]] == solid[changed[other]]) {
        joined.unite(place, other);
      }
    }
  }
  std::vector<std::vector<std::uint32_t>> patches(changed.size());
  for (std::uint32_t place = 0; place < changed.size(); ++place) {
    patches[joined.find(place)].push_back(changed[place]);
  }
  std::vector<SolidChange<D>> result;
  for (const auto& patch : patches) {
    if (!patch.empty()) result.push_back(change(patch));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.volume > b.volume; });
  return result;
}

}  // namespace

template <int D>
ManifoldSolid<D> manifold_solid(const AlphaComplex<D>& shape) {
  constexpr double kNoRadii = -std::numeric_limits<double>::infinity();
  const Filtration<D>& filtration = shape.filtration();
  const ScaledBalls<D> balls(filtration, shape.index(), kNoRadii);
  const auto cells = filtration.triangulation().template cells<D>();
  std::vector<bool> solid(cells.size());
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    solid[cell] = shape.contains(SimplexId(filtration.table().first(D) + cell));
  }
  ManifoldSolid<D> result;
  if constexpr (D == 3) result.offending_edges = crowded_edges(cells, solid);
  ManifoldRepair<D> repair(filtration, balls, std::move(solid));
  for (const std::uint32_t vertex : repair.offending()) {
    result.offending.push_back(filtration.triangulation().sites().row(vertex));
  }
  std::sort(result.offending.begin(), result.offending.end());
  repair.run();
  const Describing<D> describing(filtration, balls, repair);
  describing.measure(result);
  result.changes = describing.changes();
  CompensatedSum added, removed;
  for (const std::uint32_t cell : repair.changed()) {
    (repair.solid()[cell] ? added : removed).add(repair.volume(cell));
  }
  result.added = balls.units(D)(added.value());  // where volumes are beyond doubles: infinity
  result.removed = balls.units(D)(removed.value());
  result.contains = repair.solid();
  return result;
}

template <int D>
AlphaComplex<D> complex_of(const ManifoldSolid<D>& solid, const AlphaComplex<D>& shape) {
  const std::uint32_t first = shape.filtration().table().first(D);
  std::vector<SimplexId> cells;
  cells.reserve(solid.cell_count);
  for (std::uint32_t cell = 0; cell < solid.contains.size(); ++cell) {
    if (solid.contains[cell]) cells.emplace_back(first + cell);
  }
  return {shape.filtration(), shape.index(), cells};
}

template ManifoldSolid<2> manifold_solid(const AlphaComplex<2>&);
template ManifoldSolid<3> manifold_solid(const AlphaComplex<3>&);
template AlphaComplex<2> complex_of(const ManifoldSolid<2>&, const AlphaComplex<2>&);
template AlphaComplex<3> complex_of(const ManifoldSolid<3>&, const AlphaComplex<3>&);

}  // namespace orthoball
