// SPDX-License-Identifier: MIT
#include "orthoball/queries/regions.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <tuple>

#include "orthoball/measures/cell_gap.h"
#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Joins cells (JoinedBy::facets) or vertices, and gives each set that is wanted a number in the
// order of their first elements.
class Sets {
 public:
  explicit Sets(std::size_t size) : joined_(size), number_(size, kNone) {}

  void unite(std::uint32_t a, std::uint32_t b) { joined_.unite(a, b); }
  [[nodiscard]] std::uint32_t number(std::uint32_t element) {
    std::uint32_t& number = number_[joined_.find(element)];
    if (number == kNone) number = count_++;
    return number;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  UnionFind joined_;
  std::vector<std::uint32_t> number_;  // [smallest of a set]
  std::uint32_t count_ = 0;
};

template <int D>
class RegionsAt {
 public:
  RegionsAt(const Filtration<D>& filtration, std::uint32_t index, JoinedBy by)
      : filtration_(filtration),
        index_(index),
        by_(by),
        balls_(filtration, index, 0.0),
        sets_(by == JoinedBy::facets ? filtration.count(D) : filtration.count(0)) {
    if (by == JoinedBy::cells) {
      for_each(D, [&](SimplexId cell) {
        const auto vertices = filtration_.vertices(cell);
        for (const VertexId vertex : vertices) sets_.unite(vertices[0].row(), vertex.row());
      });
    } else if (by == JoinedBy::vertices) {
      for_each(1, [&](SimplexId edge) {
        const auto ends = filtration_.vertices(edge);
        sets_.unite(ends[0].row(), ends[1].row());
      });
    } else {
      for_each(D - 1, [&](SimplexId facet) {
        if (filtration_.role(facet, index_) != Role::interior) return;
        const auto cells = filtration_.cells_beside(facet);
        sets_.unite(cells[0].row() - first_cell(), cells[1].row() - first_cell());
      });
    }
  }

  [[nodiscard]] std::vector<Region> regions() {
    if (by_ == JoinedBy::vertices) {
      for_each(0, [&](SimplexId vertex) { region(sets_.number(vertex.row())).add(row(vertex)); });
    }
    for_each(D, [&](SimplexId cell) { add_cell(cell); });
    for_each(D - 1, [&](SimplexId facet) { add_facet(facet); });
    std::vector<Region> result;
    for (Summed& one : summed_) {
      std::sort(one.rows.begin(), one.rows.end());
      one.rows.erase(std::unique(one.rows.begin(), one.rows.end()), one.rows.end());
      result.push_back({balls_.units(D)(one.volume.value()), balls_.units(D - 1)(one.area.value()),
                        std::move(one.rows), std::move(one.cells)});
    }
    std::sort(result.begin(), result.end(), [](const Region& a, const Region& b) {
      return std::tuple(-a.volume, -a.area, a.rows[0]) < std::tuple(-b.volume, -b.area, b.rows[0]);
    });
    return result;
  }

 private:
  struct Summed {
    CompensatedSum volume, area;
    std::vector<SiteId> rows;
    std::vector<SimplexId> cells;

    void add(SiteId row) { rows.push_back(row); }
  };

  // Calls `visit` with every simplex of a dimension in the complex.
  template <class Visit>
  void for_each(int dimension, const Visit& visit) const {
    const std::uint32_t first = filtration_.table().first(dimension);
    const auto end = static_cast<std::uint32_t>(first + filtration_.count(dimension));
    for (std::uint32_t simplex = first; simplex < end; ++simplex) {
      if (filtration_.enters(SimplexId(simplex)) <= index_) visit(SimplexId(simplex));
    }
  }
  [[nodiscard]] std::uint32_t first_cell() const { return filtration_.table().first(D); }
  [[nodiscard]] SiteId row(SimplexId vertex) const {
    return filtration_.triangulation().sites().row(vertex.row());
  }
  [[nodiscard]] Summed& region(std::uint32_t number) {
    if (number >= summed_.size()) summed_.resize(number + std::size_t{1});
    return summed_[number];
  }
  [[nodiscard]] std::array<Sphere<D>, std::size_t{D} + 1> corners(SimplexId simplex) const {
    std::array<Sphere<D>, std::size_t{D} + 1> result{};
    const auto vertices = filtration_.vertices(simplex);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      result[i] = balls_.spheres()[vertices[i].row()];
    }
    return result;
  }

  void add_cell(SimplexId cell) {
    const auto vertices = filtration_.vertices(cell);
    const bool by_facets = by_ == JoinedBy::facets;
    Summed& it = region(sets_.number(by_facets ? cell.row() - first_cell() : vertices[0].row()));
    it.cells.push_back(cell);
    it.volume.add(cell_gap(corners(cell), {}).volume);
    if (by_ == JoinedBy::vertices) return;  // there already
    for (const VertexId vertex : vertices) it.add(row(SimplexId(vertex.row())));
  }

  void add_facet(SimplexId facet) {
    const Role role = filtration_.role(facet, index_);
    if (role == Role::interior) return;
    if (by_ != JoinedBy::vertices && role == Role::singular) return;
    const double size = facet_size(corners(facet), D);
    std::uint32_t element = filtration_.vertices(facet)[0].row();
    if (by_ == JoinedBy::facets) {
      const auto cells = filtration_.cells_beside(facet);
      const bool is_first = filtration_.enters(cells[0]) <= index_;
      element = cells[is_first ? 0 : 1].row() - first_cell();
    }
    CompensatedSum& area = region(sets_.number(element)).area;
    area.add(size);
    if (role == Role::singular) area.add(size);  // the other side
  }

  const Filtration<D>& filtration_;
  std::uint32_t index_;
  JoinedBy by_;
  ScaledBalls<D> balls_;
  Sets sets_;
  std::vector<Summed> summed_;
};

}  // namespace

template <int D>
std::vector<Region> regions(const Filtration<D>& filtration, std::uint32_t index, JoinedBy by) {
  return RegionsAt<D>(filtration, index, by).regions();
}

template std::vector<Region> regions<2>(const Filtration<2>&, std::uint32_t, JoinedBy);
template std::vector<Region> regions<3>(const Filtration<3>&, std::uint32_t, JoinedBy);

}  // namespace orthoball
