// SPDX-License-Identifier: MIT
//
// A region is a list of simplices: of a component of the complex, or of cells that are joined
// through facets and all their faces. A hole is a list of cells outside the complex, joined through
// facets outside it; what reaches the convex hull so is joined with the outside, and no hole.
#include "orthoball/queries/regions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "orthoball/measures/cell_gap.h"
#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/region_betti.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using Simplices = std::vector<SimplexId>;

// Disjoint sets that get numbers in the order in which their first elements are asked for, and
// what they are made of.
class Sets {
 public:
  explicit Sets(std::size_t size) : joined_(size), number_(size, kNone) {}

  void unite(std::uint32_t a, std::uint32_t b) { joined_.unite(a, b); }
  [[nodiscard]] bool are_one(std::uint32_t a, std::uint32_t b) {
    return joined_.find(a) == joined_.find(b);
  }
  [[nodiscard]] Simplices& of(std::uint32_t element) {
    std::uint32_t& number = number_[joined_.find(element)];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(simplices_.size());
      simplices_.emplace_back();
    }
    return simplices_[number];
  }
  [[nodiscard]] std::vector<Simplices> simplices() && { return std::move(simplices_); }

 private:
  UnionFind joined_;
  std::vector<std::uint32_t> number_;  // [smallest of a set]
  std::vector<Simplices> simplices_;   // [number]
};

// Calls `visit` with every simplex of some dimensions.
template <int D, class Visit>
void for_each(const Filtration<D>& filtration, int least, int most, const Visit& visit) {
  const std::uint32_t first = filtration.table().first(least);
  const auto end =
      static_cast<std::uint32_t>(filtration.table().first(most) + filtration.count(most));
  for (std::uint32_t simplex = first; simplex < end; ++simplex) visit(SimplexId(simplex));
}

template <int D>
std::vector<Simplices> components(const AlphaComplex<D>& complex) {
  const Filtration<D>& filtration = complex.filtration();
  Sets sets(filtration.count(0));
  for_each(filtration, 1, 1, [&](SimplexId edge) {
    if (!complex.contains(edge)) return;
    const auto ends = filtration.vertices(edge);
    sets.unite(ends[0].row(), ends[1].row());
  });
  for_each(filtration, 0, D, [&](SimplexId simplex) {
    if (!complex.contains(simplex)) return;
    sets.of(filtration.vertices(simplex)[0].row()).push_back(simplex);
  });
  return std::move(sets).simplices();
}

// With all their faces, ascending.
template <int D>
Simplices closure(const Filtration<D>& filtration, Simplices cells) {
  Simplices all;
  for (Simplices found = std::move(cells); !found.empty();) {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    all.insert(all.begin(), found.begin(), found.end());
    Simplices faces;
    for (const SimplexId simplex : found) {
      const auto facets = filtration.facets(simplex);
      faces.insert(faces.end(), facets.begin(), facets.end());
    }
    found = std::move(faces);
  }
  return all;
}

template <int D>
std::vector<Simplices> joined_by_facets(const AlphaComplex<D>& complex) {
  const Filtration<D>& filtration = complex.filtration();
  const std::uint32_t first = filtration.table().first(D);
  Sets sets(filtration.count(D));
  for_each(filtration, D - 1, D - 1, [&](SimplexId facet) {
    if (complex.role(facet) != Role::interior) return;
    const auto cells = filtration.cells_beside(facet);
    sets.unite(cells[0].row() - first, cells[1].row() - first);
  });
  for_each(filtration, D, D, [&](SimplexId cell) {
    if (complex.contains(cell)) sets.of(cell.row() - first).push_back(cell);
  });
  std::vector<Simplices> result = std::move(sets).simplices();
  for (Simplices& region : result) region = closure(filtration, std::move(region));
  return result;
}

template <int D>
std::vector<Simplices> bounded_complements(const AlphaComplex<D>& complex) {
  const Filtration<D>& filtration = complex.filtration();
  if (filtration.triangulation().affine_dimension() < D) return {};
  const std::uint32_t first = filtration.table().first(D);
  const auto outside = static_cast<std::uint32_t>(filtration.count(D));
  Sets sets(filtration.count(D) + 1);
  for_each(filtration, D - 1, D - 1, [&](SimplexId facet) {
    if (complex.contains(facet)) return;
    const auto cells = filtration.cells_beside(facet);
    sets.unite(cells[0].row() - first, cells.size() == 2 ? cells[1].row() - first : outside);
  });
  for_each(filtration, D, D, [&](SimplexId cell) {
    const std::uint32_t number = cell.row() - first;
    if (!complex.contains(cell) && !sets.are_one(number, outside)) sets.of(number).push_back(cell);
  });
  return std::move(sets).simplices();
}

template <int D>
class Measures {
 public:
  explicit Measures(const AlphaComplex<D>& complex)
      : complex_(complex),
        filtration_(complex.filtration()),
        balls_(filtration_, complex.index(), -std::numeric_limits<double>::infinity()) {}

  [[nodiscard]] Region of_region(const Simplices& simplices) const {
    Region region;
    CompensatedSum volume, area;
    for (const SimplexId simplex : simplices) {
      const int dimension = filtration_.dimension(simplex);
      if (dimension == 0) region.rows.push_back(row(simplex));
      if (dimension == D) {
        region.cells.push_back(simplex);
        volume.add(cell_gap(corners(simplex), {}).volume);
      }
      const Role role = complex_.role(simplex);
      if (dimension != D - 1 || role == Role::interior) continue;
      const double size = facet_size(corners(simplex), D);
      area.add(size);
      if (role == Role::singular) area.add(size);  // the other side
    }
    return in_input_units(std::move(region), volume, area);
  }

  [[nodiscard]] Region of_hole(Simplices cells) const {
    Region hole;
    CompensatedSum volume, area;
    std::set<SiteId> rows;
    for (const SimplexId cell : cells) {
      volume.add(cell_gap(corners(cell), {}).volume);
      for (const SimplexId facet : filtration_.facets(cell)) {
        if (complex_.contains(facet)) area.add(facet_size(corners(facet), D));
      }
      for (const VertexId vertex : filtration_.vertices(cell)) {
        if (complex_.contains(SimplexId(vertex.row()))) rows.insert(row(SimplexId(vertex.row())));
      }
    }
    hole.rows.assign(rows.begin(), rows.end());
    hole.cells = std::move(cells);
    return in_input_units(std::move(hole), volume, area);
  }

 private:
  [[nodiscard]] SiteId row(SimplexId vertex) const {
    return filtration_.triangulation().sites().row(vertex.row());
  }
  [[nodiscard]] std::array<Sphere<D>, std::size_t{D} + 1> corners(SimplexId simplex) const {
    std::array<Sphere<D>, std::size_t{D} + 1> result{};
    const auto vertices = filtration_.vertices(simplex);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      result[i] = balls_.spheres()[vertices[i].row()];
    }
    return result;
  }
  [[nodiscard]] Region in_input_units(Region region, const CompensatedSum& volume,
                                      const CompensatedSum& area) const {
    region.volume = balls_.units(D)(volume.value());
    region.area = balls_.units(D - 1)(area.value());
    std::sort(region.rows.begin(), region.rows.end());
    return region;
  }

  const AlphaComplex<D>& complex_;
  const Filtration<D>& filtration_;
  ScaledBalls<D> balls_;
};

std::vector<Region> in_order(std::vector<Region> regions) {
  std::sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) {
    return std::tuple(-a.volume, -a.area, a.rows[0]) < std::tuple(-b.volume, -b.area, b.rows[0]);
  });
  return regions;
}

}  // namespace

template <int D>
std::vector<Region> regions(const AlphaComplex<D>& complex, JoinedBy by) {
  if (by == JoinedBy::cells) return regions(regularized(complex), JoinedBy::vertices);
  const std::vector<Simplices> parts =
      by == JoinedBy::facets ? joined_by_facets(complex) : components(complex);
  const auto betti = region_betti<D>(complex.filtration(), parts);
  const Measures<D> measures(complex);
  std::vector<Region> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result.push_back(measures.of_region(parts[i]));
    result.back().betti = betti[i];
  }
  return in_order(std::move(result));
}

template <int D>
Region whole_shape(const AlphaComplex<D>& complex) {
  const Filtration<D>& filtration = complex.filtration();
  Simplices all;
  std::int64_t euler = 0;
  for_each(filtration, 0, D, [&](SimplexId simplex) {
    if (!complex.contains(simplex)) return;
    all.push_back(simplex);
    euler += filtration.dimension(simplex) % 2 == 0 ? 1 : -1;
  });
  Region result = Measures<D>(complex).of_region(all);
  const std::size_t parts = components(complex).size(), voids = bounded_complements(complex).size();
  result.betti[0] = static_cast<std::uint32_t>(parts);
  result.betti[D - 1] = static_cast<std::uint32_t>(voids);
  if constexpr (D == 3) {
    const auto even = static_cast<std::int64_t>(parts + voids);
    result.betti[1] = static_cast<std::uint32_t>(even - euler);
  }
  return result;
}

template <int D>
std::vector<Region> holes(const AlphaComplex<D>& complex) {
  const Measures<D> measures(complex);
  std::vector<Region> result;
  for (Simplices& cells : bounded_complements(complex)) {
    result.push_back(measures.of_hole(std::move(cells)));
  }
  return in_order(std::move(result));
}

template std::vector<Region> regions<2>(const AlphaComplex<2>&, JoinedBy);
template std::vector<Region> regions<3>(const AlphaComplex<3>&, JoinedBy);
template Region whole_shape<2>(const AlphaComplex<2>&);
template Region whole_shape<3>(const AlphaComplex<3>&);
template std::vector<Region> holes<2>(const AlphaComplex<2>&);
template std::vector<Region> holes<3>(const AlphaComplex<3>&);

}  // namespace orthoball
