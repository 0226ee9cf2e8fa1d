// SPDX-License-Identifier: MIT
//
// A region R is connected: beta 0 is 1. In the plane Euler's number gives the rest. In space beta 2
// is one less than the number of components of the complement, the outside counted, and then
// Euler's number gives beta 1. The complement need not be gone through: where N is the union of the
// open cells around R, everything there with a vertex in R, the sequence of Mayer and Vietoris for
// the 3-sphere says that N without R has as many components. They are found among the cells with a
// vertex in R, joined through their facets that have one, too, and are not of R.
#include "orthoball/queries/region_betti.h"

#include <cstddef>
#include <numeric>
#include <optional>

#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

// The cells with a given vertex.
template <int D>
class CellsAround {
 public:
  explicit CellsAround(const Filtration<D>& filtration) : begin_(filtration.count(0) + 1, 0) {
    const std::uint32_t first = filtration.table().first(D);
    const auto end = static_cast<std::uint32_t>(filtration.size());
    for (std::uint32_t cell = first; cell < end; ++cell) {
      for (const VertexId v : filtration.vertices(SimplexId(cell))) ++begin_[v.row()];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    cells_.resize(begin_.back());
    for (std::uint32_t cell = end; cell-- > first;) {
      for (const VertexId v : filtration.vertices(SimplexId(cell))) {
        cells_[--begin_[v.row()]] = SimplexId(cell);
      }
    }
  }

  [[nodiscard]] std::span<const SimplexId> operator()(std::uint32_t vertex) const {
    return std::span(cells_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

 private:
  std::vector<std::uint32_t> begin_;  // [vertex], of cells_
  std::vector<SimplexId> cells_;
};

// Regions one after the other.
class ComplementsInSpace {
 public:
  explicit ComplementsInSpace(const Filtration<3>& filtration)
      : filtration_(filtration),
        cells_around_(filtration),
        region_of_(filtration.size(), 0),
        number_(filtration.count(3), 0) {}

  // How many components the complement of a region has.
  [[nodiscard]] std::size_t count(std::span<const SimplexId> simplices) {
    ++region_;
    for (const SimplexId simplex : simplices) region_of_[simplex.row()] = region_;
    const std::vector<SimplexId> cells = cells_around(simplices);
    UnionFind joined(cells.size() + 1);
    const auto outside = static_cast<std::uint32_t>(cells.size());
    bool reaches_outside = false;
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
      for (const SimplexId facet : filtration_.facets(cells[cell])) {
        if (is_in(facet) || !has_vertex_in(facet)) continue;
        const auto beside = filtration_.cells_beside(facet);
        reaches_outside = reaches_outside || beside.size() == 1;
        joined.unite(
            cell, beside.size() == 1 ? outside : number(beside[beside[0] == cells[cell] ? 1 : 0]));
      }
    }
    // A facet of the region on the hull has the outside beyond it.
    for (const SimplexId simplex : simplices) {
      if (reaches_outside) break;
      reaches_outside =
          filtration_.dimension(simplex) == 2 && filtration_.cells_beside(simplex).size() == 1;
    }
    return joined.set_count() - (reaches_outside ? 0 : 1);
  }

 private:
  [[nodiscard]] std::vector<SimplexId> cells_around(std::span<const SimplexId> simplices) {
    std::vector<SimplexId> cells;
    for (const SimplexId simplex : simplices) {
      if (simplex.row() >= filtration_.count(0)) break;
      for (const SimplexId cell : cells_around_(simplex.row())) {
        if (is_in(cell)) continue;
        const std::uint32_t known = number(cell);
        if (known < cells.size() && cells[known] == cell) continue;
        number_[cell.row() - filtration_.table().first(3)] =
            static_cast<std::uint32_t>(cells.size());
        cells.push_back(cell);
      }
    }
    return cells;
  }
  [[nodiscard]] bool is_in(SimplexId simplex) const { return region_of_[simplex.row()] == region_; }
  [[nodiscard]] bool has_vertex_in(SimplexId facet) const {
    for (const VertexId v : filtration_.vertices(facet)) {
      if (is_in(SimplexId(v.row()))) return true;
    }
    return false;
  }
  [[nodiscard]] std::uint32_t number(SimplexId cell) const {
    return number_[cell.row() - filtration_.table().first(3)];
  }

  const Filtration<3>& filtration_;
  CellsAround<3> cells_around_;
  std::uint32_t region_ = 0;
  std::vector<std::uint32_t> region_of_;  // [simplex]: the last region that it was in, from 1
  std::vector<std::uint32_t> number_;     // [cell]: its place among those around the last region
};

}  // namespace

template <int D>
std::vector<std::array<std::uint32_t, 3>> region_betti(
    const Filtration<D>& filtration, std::span<const std::vector<SimplexId>> regions) {
  std::vector<std::array<std::uint32_t, 3>> result;
  [[maybe_unused]] std::optional<ComplementsInSpace> complements;
  for (const std::vector<SimplexId>& region : regions) {
    std::int64_t euler = 0;
    int dimension = 0;
    for (const SimplexId simplex : region) {
      dimension = filtration.dimension(simplex);
      euler += dimension % 2 == 0 ? 1 : -1;
    }
    std::int64_t enclosed = 0;
    if constexpr (D == 3) {
      if (dimension >= 2 && filtration.triangulation().affine_dimension() == 3) {
        if (!complements) complements.emplace(filtration);
        enclosed = static_cast<std::int64_t>(complements->count(region)) - 1;
      }
    }
    result.push_back({1, static_cast<std::uint32_t>(1 + enclosed - euler),
                      static_cast<std::uint32_t>(enclosed)});
  }
  return result;
}

template std::vector<std::array<std::uint32_t, 3>> region_betti<2>(
    const Filtration<2>&, std::span<const std::vector<SimplexId>>);
template std::vector<std::array<std::uint32_t, 3>> region_betti<3>(
    const Filtration<3>&, std::span<const std::vector<SimplexId>>);

}  // namespace orthoball
