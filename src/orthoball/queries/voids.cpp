// SPDX-License-Identifier: MIT
//
// Voids are components of the cells outside the complex, joined through facets outside it; the
// outside is one more node. When they are born is found by going back: facets are taken away, the
// last to enter first, and of two components that one joins, the one that is filled first ends,
// which is to say begins there. Measures are sums over the cells of a void
// (free_space.h).
//
// Delfinado, Edelsbrunner. An incremental algorithm for Betti numbers of simplicial complexes.
// Computer Aided Geometric Design 12 (1995). Liang, Edelsbrunner, Fu, Sudhakar, Subramaniam.
// Analytical shape computation of macromolecules II. Proteins 33 (1998).
#include "orthoball/queries/voids.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "orthoball/measures/cell_gap.h"
#include "orthoball/measures/compensated_sum.h"
#include "orthoball/queries/largest_ball.h"
#include "orthoball/radix_sort.h"
#include "orthoball/raw_vector.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

// A void while it is found.
struct Component {
  std::vector<std::uint32_t> cells;  // by number within their dimension, ascending
  std::uint32_t last = 0;            // the cell that fills it
  std::uint32_t born = 0;
};

template <int D>
class Complement {
 public:
  Complement(const Filtration<D>& filtration, std::uint32_t index)
      : filtration_(filtration),
        enters_of_cell_(filtration.enters().subspan(filtration.table().first(D))),
        enters_of_facet_(
            filtration.enters().subspan(filtration.table().first(D - 1), filtration.count(D - 1))),
        joined_(enters_of_cell_.size() + 1),
        last_(enters_of_cell_.size() + 1),
        index_(index) {
    for (std::uint32_t cell = 0; cell < last_.size(); ++cell) last_[cell] = cell;
  }

  // The bounded components, by their first cells.
  std::vector<Component> voids() {
    for (std::uint32_t facet = 0; facet < enters_of_facet_.size(); ++facet) {
      if (enters_of_facet_[facet] > index_) join(facet);
    }
    const std::uint32_t outside_root = joined_.find(outside());
    std::map<std::uint32_t, std::size_t> number_of_root;
    std::vector<Component> voids;
    for (std::uint32_t cell = 0; cell < outside(); ++cell) {
      const std::uint32_t root = joined_.find(cell);
      if (enters_of_cell_[cell] <= index_ || root == outside_root) continue;
      const auto [place, is_new] = number_of_root.try_emplace(root, voids.size());
      if (is_new) voids.push_back({{}, last_[root], 0});
      voids[place->second].cells.push_back(cell);
    }
    find_births(voids);
    return voids;
  }

 private:
  [[nodiscard]] std::uint32_t outside() const {
    return static_cast<std::uint32_t>(enters_of_cell_.size());
  }
  // Whether a cell is filled after another; the outside never is.
  [[nodiscard]] bool is_later(std::uint32_t a, std::uint32_t b) const {
    if (a == outside() || b == outside()) return a == outside() && b != outside();
    return std::pair(enters_of_cell_[a], a) > std::pair(enters_of_cell_[b], b);
  }

  // Takes a facet away. The last cell of the component that ends, or the outside if none does.
  std::uint32_t join(std::uint32_t facet) {
    const auto cells =
        filtration_.cells_beside(SimplexId(filtration_.table().first(D - 1) + facet));
    const std::uint32_t first = filtration_.table().first(D);
    const std::uint32_t a = joined_.find(cells[0].row() - first);
    const std::uint32_t b = joined_.find(cells.size() == 2 ? cells[1].row() - first : outside());
    if (a == b) return outside();
    const std::uint32_t earlier = is_later(last_[a], last_[b]) ? last_[b] : last_[a];
    const std::uint32_t later = earlier == last_[a] ? last_[b] : last_[a];
    joined_.unite(a, b);
    last_[joined_.find(a)] = later;
    return earlier;
  }

  void find_births(std::vector<Component>& voids) {
    if (voids.empty()) return;
    std::map<std::uint32_t, std::size_t> unborn;  // by the last cell
    for (std::size_t i = 0; i < voids.size(); ++i) unborn[voids[i].last] = i;
    RawVector<KeyedRow> facets;  // the last to enter first
    for (std::uint32_t facet = 0; facet < enters_of_facet_.size(); ++facet) {
      const std::uint32_t enters = enters_of_facet_[facet];
      if (enters <= index_) facets.push_back({std::uint64_t{~enters} << 32U | ~facet, facet});
    }
    radix_sort(facets);
    for (const KeyedRow& facet : facets) {
      if (unborn.empty()) break;
      const auto born = unborn.find(join(facet.row));
      if (born == unborn.end()) continue;
      voids[born->second].born = enters_of_facet_[facet.row];
      unborn.erase(born);
    }
  }

  const Filtration<D>& filtration_;
  std::span<const std::uint32_t> enters_of_cell_, enters_of_facet_;
  UnionFind joined_;                 // cells outside the complex and the outside
  std::vector<std::uint32_t> last_;  // [smallest of a set]: its cell that is filled last
  std::uint32_t index_;
};

template <int D>
class VoidMeasures {
 public:
  VoidMeasures(const Filtration<D>& filtration, std::uint32_t index, double alpha2, VoidsOf of)
      : filtration_(filtration), free_(filtration, index, alpha2), of_(of) {}

  [[nodiscard]] Void<D> measured(const Component& component) const {
    Void<D> result;
    const std::uint32_t first = filtration_.table().first(D);
    result.born = component.born;
    result.dies = filtration_.enters(SimplexId(first + component.last));
    result.born_alpha2 = filtration_.alpha2(result.born);
    result.dies_alpha2 = filtration_.alpha2(result.dies);
    for (const std::uint32_t cell : component.cells) result.cells.emplace_back(first + cell);
    FreePart part = of_ == VoidsOf::balls ? free_.part(result.cells) : polyhedron(result.cells);
    result.volume = std::max(0.0, part.volume);
    result.area = part.area;
    result.lining = std::move(part.lining);
    if (of_ == VoidsOf::balls) find_largest_ball(result);
    return result;
  }

 private:
  [[nodiscard]] FreePart polyhedron(std::span<const SimplexId> cells) const;
  void find_largest_ball(Void<D>& result) const;

  const Filtration<D>& filtration_;
  FreeSpace<D> free_;
  VoidsOf of_;
};

// The cells themselves, and their facets in the complex.
template <int D>
FreePart VoidMeasures<D>::polyhedron(std::span<const SimplexId> cells) const {
  std::set<SiteId> rows;
  CompensatedSum volume, area;
  for (const SimplexId cell : cells) {
    const auto corners = free_.corners(cell);
    volume.add(cell_gap(corners, {}).volume);
    const auto facets = filtration_.facets(cell);
    const auto vertices = filtration_.vertices(cell);
    for (std::size_t i = 0; i <= D; ++i) {
      if (free_.is_in(facets[i])) area.add(facet_size(corners, i));
      if (free_.is_in(SimplexId(vertices[i].row()))) {
        rows.insert(filtration_.triangulation().sites().row(vertices[i].row()));
      }
    }
  }
  FreePart part{free_.units(D)(volume.value()), free_.units(D - 1)(area.value()), {}};
  for (const SiteId row : rows) part.lining.push_back({row, 0.0});
  return part;
}

template <int D>
void VoidMeasures<D>::find_largest_ball(Void<D>& result) const {
  std::vector<VoidCell<D>> cells;
  cells.reserve(result.cells.size());
  for (const SimplexId cell : result.cells) {
    cells.push_back({free_.corners(cell), free_.orthocentre(cell)});
    const auto vertices = filtration_.vertices(cell);
    for (std::size_t i = 0; i <= D; ++i) {
      if (!free_.is_in(SimplexId(vertices[i].row()))) cells.back().corners[i].radius = 0.0;
    }
  }
  const InscribedBall<D> largest = largest_ball<D>(cells, free_.lining(result.cells));
  if (largest.radius < 0.0) return;
  const InputUnits lengths = free_.units(1);
  result.largest_ball_radius = lengths({largest.radius, 0.0});
  for (std::size_t axis = 0; axis < D; ++axis) {
    result.largest_ball_centre[axis] = lengths({largest.centre[axis], 0.0});
  }
}

}  // namespace

template <int D>
std::vector<Void<D>> voids(const Filtration<D>& filtration, std::uint32_t index, double alpha2,
                           VoidsOf of, Threads threads) {
  const VoidMeasures<D> measures(filtration, index, alpha2, of);
  if (filtration.triangulation().affine_dimension() < D) return {};
  const std::vector<Component> components = Complement<D>(filtration, index).voids();
  std::vector<Void<D>> result(components.size());
  parallel_for(threads, components.size(),
               [&](std::size_t i) { result[i] = measures.measured(components[i]); });
  std::stable_sort(result.begin(), result.end(), is_listed_before<Void<D>>);
  return result;
}

template std::vector<Void<2>> voids<2>(const Filtration<2>&, std::uint32_t, double, VoidsOf,
                                       Threads);
template std::vector<Void<3>> voids<3>(const Filtration<3>&, std::uint32_t, double, VoidsOf,
                                       Threads);

}  // namespace orthoball
