// SPDX-License-Identifier: MIT
//
// Each new k-simplex either closes a k-cycle or fills a (k-1)-cycle. Components alone tell which:
// an edge that joins two components of the complex fills (it ends a 0-cycle), any other closes a
// loop. A triangle in space closes a 2-cycle if and only if it cuts a component of the complement
// in two. Seen backwards, taking simplices away, it joins two: the complement is kept as the cells
// that are missing and one node for the outside, and a triangle joins the nodes on its two sides,
// a side without a cell being the outside. Where sites span less than R^D there are no cells, and
// a triangle only joins the outside to itself.
//
// Delfinado, Edelsbrunner. An incremental algorithm for Betti numbers of simplicial complexes on
// the 3-sphere. Computer Aided Geometric Design 12 (1995).
//
// So the edges that join are a minimum spanning forest of the vertices, weighted by their place in
// the filter, and the triangles that cut are a maximum one of the cells and the outside. Both are
// found along space instead of along the filter, in which neighbours are far apart in memory.
#include "orthoball/topology/betti.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/filtration/face_vertices.h"
#include "orthoball/topology/spanning_forest.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

// Vertices and edges; the first edge of the filter is the least.
template <int D>
struct Components {
  const Filtration<D>& filtration;

  [[nodiscard]] std::uint32_t node_count() const {
    return static_cast<std::uint32_t>(filtration.count(0));
  }
  [[nodiscard]] std::uint32_t edge_count() const {
    return static_cast<std::uint32_t>(filtration.count(1));
  }
  [[nodiscard]] Ends ends(std::uint32_t edge) const {
    const auto vertices = face_vertices<2>(filtration, simplex(edge));
    return {vertices[0], vertices[1]};
  }
  [[nodiscard]] std::uint32_t weight(std::uint32_t edge) const {
    return filtration.enters(simplex(edge));
  }
  // By then nearly all vertices of evenly spread sites are connected.
  [[nodiscard]] std::uint32_t light_weight() const {
    return filtration.spectrum_size() / (D == 3 ? 6 : 3);
  }

 private:
  [[nodiscard]] SimplexId simplex(std::uint32_t edge) const {
    return SimplexId(filtration.table().first(1) + edge);
  }
};

// The cells, the outside as the last node, and the triangles between them; the last triangle of the
// filter is the least.
//
// A cell that enters with one of its triangles takes the last of these first: none of its triangles
// enters later, so that one is its least edge. Most cells have one, and follow it to the cell
// beyond, which enters later. What is left are the trees that end at cells without, or outside.
class Voids {
 public:
  Voids(const Filtration<3>& filtration, const FacetRoles<3>& roles)
      : enters_(filtration.enters()),
        cells_(filtration.triangulation().cells<3>()),
        owners_(filtration.table().facet_owners()),
        first_triangle_(filtration.table().first(2)),
        roles_(roles.of_cells()) {}

  // Calls end(part, cell) for the cells at which trees end, and mark(part, triangle) for the
  // triangles that join trees, by number within their dimension. Every other cell is joined by its
  // own triangle, which enters at the same index, and mark_own(cell, corner) is called. All that
  // from several threads at once, with as many parts as there are threads.
  template <class Mark, class MarkOwn, class End>
  void build(Threads threads, const Mark& mark, const MarkOwn& mark_own, const End& end) const {
    RawVector<std::uint32_t> tree(cells_.size() + 1);
    parallel_parts(threads, cells_.size(), threads.count(),
                   [&](std::size_t part, std::size_t first, std::size_t behind) {
                     for (auto cell = static_cast<std::uint32_t>(first); cell < behind; ++cell) {
                       const std::uint32_t corner = own_triangle(cell);
                       tree[cell] = is_end(cell, corner) ? cell : beyond(cell, corner);
                       tree[cell] == cell ? end(part, cell) : mark_own(cell, corner);
                     }
                   });
    tree[outside()] = outside();
    std::uint32_t tree_count = number_roots(tree, threads);
    const auto triangle_count = static_cast<std::uint32_t>(owners_.size());
    const auto joint = [&tree, voids = *this, triangle_count](std::uint32_t i) -> Joint {
      const std::uint32_t triangle = triangle_count - 1 - i;
      const std::uint32_t owner = voids.owners_[triangle];
      return {tree[owner / 4], tree[voids.beyond(owner / 4, owner % 4)],
              ~voids.enters_[voids.first_triangle_ + triangle], triangle};
    };
    join(joints_of(triangle_count, threads, joint), tree_count, threads, mark);
  }

 private:
  static constexpr std::uint32_t kNone = 4;

  [[nodiscard]] std::uint32_t outside() const { return static_cast<std::uint32_t>(cells_.size()); }
  [[nodiscard]] std::uint32_t beyond(std::uint32_t cell, std::uint32_t corner) const {
    const std::uint32_t neighbour = cells_[cell].neighbours[corner];
    return neighbour == kOutside ? outside() : neighbour / 4;
  }
  // The corner opposite the last of the triangles that enter with a cell, or kNone.
  [[nodiscard]] std::uint32_t own_triangle(std::uint32_t cell) const {
    const unsigned entering = unsigned{roles_[cell]} / FacetRoles<3>::kEntersWith;
    std::uint32_t last = 0, result = kNone;
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      // Triangles are in the order of their places in their owners, the smaller of two cells;
      // kOutside is larger than any.
      const std::uint32_t neighbour = cells_[cell].neighbours[corner];
      const std::uint32_t place = neighbour / 4 < cell ? neighbour : 4 * cell + corner;
      const bool is_later = ((entering >> corner & 1U) != 0) & (place >= last);
      last = is_later ? place : last;
      result = is_later ? corner : result;
    }
    return result;
  }
  // Whether a cell has no triangle of its own, or is the smaller of two that have the same.
  [[nodiscard]] bool is_end(std::uint32_t cell, std::uint32_t corner) const {
    if (corner == kNone) return true;
    const std::uint32_t neighbour = cells_[cell].neighbours[corner];
    if (neighbour == kOutside || neighbour / 4 < cell) return false;
    const unsigned roles_beyond = unsigned{roles_[neighbour / 4]} >> neighbour % 4;
    if ((roles_beyond & FacetRoles<3>::kEntersWith) == 0) return false;
    return own_triangle(neighbour / 4) == neighbour % 4;
  }

  std::span<const std::uint32_t> enters_;
  std::span<const CellRecord<3>> cells_;
  std::span<const std::uint32_t> owners_;
  std::uint32_t first_triangle_;
  std::span<const std::uint8_t> roles_;
};

}  // namespace

template <int D>
CycleMarks<D>::CycleMarks(const Filtration<D>& filtration)
    : first_edge_(filtration.table().first(1)),
      first_triangle_(filtration.table().first(2)),
      forests_(filtration.size() / 64 + 1, 0) {
  const auto mark = [&](std::uint32_t row) { forests_[row / 64] |= std::uint64_t{1} << row % 64; };
  if (filtration.count(1) > 0) {
    mark_spanning_forest(Components<D>{filtration}, Threads(1),
                         [&](std::size_t, std::uint32_t edge) { mark(first_edge_ + edge); });
  }
  if constexpr (D == 3) {
    if (filtration.count(3) == 0) return;
    const auto cells = filtration.triangulation().template cells<3>();
    Voids(filtration, FacetRoles<3>(filtration))
        .build(
            Threads(1),
            [&](std::size_t, std::uint32_t triangle) { mark(first_triangle_ + triangle); },
            [&](std::uint32_t cell, unsigned corner) {
              mark(first_triangle_ +
                   filtration.table().template facet_of_cell<3>(cells, cell, corner));
            },
            [](std::size_t, std::uint32_t) {});
  }
}

namespace {

// Indices that several threads have found, each in a part of its own, on lines of the cache of its
// own.
class IndexParts {
 public:
  explicit IndexParts(Threads threads) : parts_(threads.count()) {}

  void add(std::size_t part, std::uint32_t index) { parts_[part].indices.push_back(index); }
  [[nodiscard]] IndexCounts counts(std::uint32_t largest, Threads threads) const {
    return {largest, parts_.size(), threads, [&](std::size_t part, const auto& visit) {
              for (const std::uint32_t index : parts_[part].indices) visit(index);
            }};
  }

 private:
  struct alignas(128) Part {
    BlockVector<std::uint32_t> indices;
  };
  std::vector<Part> parts_;
};

}  // namespace

// When edges join components.
template <int D>
IndexCounts joining_counts(const Filtration<D>& filtration, Threads threads) {
  IndexParts joining(threads);
  if (filtration.count(1) > 0) {
    const auto enters = filtration.enters().subspan(filtration.table().first(1));
    mark_spanning_forest(
        Components<D>{filtration}, threads,
        [&](std::size_t part, std::uint32_t edge) { joining.add(part, enters[edge]); });
  }
  return joining.counts(filtration.spectrum_size(), threads);
}

template <int D>
VoidCounts void_counts(const Filtration<D>& filtration, const FacetRoles<D>& roles,
                       Threads threads) {
  VoidCounts counts;
  if constexpr (D == 3) {
    IndexParts opening(threads), closing(threads);
    if (filtration.count(3) > 0) {
      const auto add = [&](int dimension, IndexParts& to) {
        const auto enters = filtration.enters().subspan(filtration.table().first(dimension));
        return
            [&to, enters](std::size_t part, std::uint32_t number) { to.add(part, enters[number]); };
      };
      Voids(filtration, roles)
          .build(
              threads, add(2, opening), [](std::uint32_t, std::uint32_t) {}, add(3, closing));
    }
    counts.opening = opening.counts(filtration.spectrum_size(), threads);
    counts.closing = closing.counts(filtration.spectrum_size(), threads);
  }
  return counts;
}

template <int D>
BettiScan<D>::BettiScan(const Filtration<D>& filtration, Threads threads)
    : last_(filtration.spectrum_size()) {
  threads = threads.for_work(filtration.size(), kLeastSimplices);
  const FacetRoles<D> roles(filtration, threads);
  void_counts_ = void_counts(filtration, roles, threads);
  joining_ = joining_counts(filtration, threads);
  for (std::size_t k = 0; k < enter_.size(); ++k) {
    const int dimension = static_cast<int>(k);
    const auto enters = filtration.enters().subspan(filtration.table().first(dimension));
    enter_[k] = index_counts(last_, filtration.count(dimension), threads,
                             [&](std::size_t i) { return enters[i]; });
  }
}

template <int D>
bool BettiScan<D>::next() {
  if (index_ == last_) return false;
  ++index_;
  for (std::size_t k = 0; k < enter_.size(); ++k) {
    entering_[k] = enter_[k].count(index_);
    entered_[k] += entering_[k];
  }
  joined_ += joining_.count(index_);
  voids_ += void_counts_.opening.count(index_);
  voids_ -= void_counts_.closing.count(index_);
  return true;
}

namespace {

// How many edges of one complex join components.
template <int D>
std::uint32_t joined_at(const Filtration<D>& filtration, std::uint32_t index) {
  const std::uint32_t first = filtration.table().first(1);
  const auto enters = filtration.enters().subspan(first, filtration.count(1));
  UnionFind components(filtration.count(0));
  std::uint32_t joined = 0;
  for (std::uint32_t edge = 0; edge < enters.size() && components.set_count() > 1; ++edge) {
    if (enters[edge] > index) continue;
    const auto ends = face_vertices<2>(filtration, SimplexId(first + edge));
    joined += components.unite(ends[0], ends[1]) ? 1U : 0U;
  }
  return joined;
}

// The components of the cells outside one complex, joined through facets outside it, that are not
// joined to the outside of the hull.
template <int D>
std::uint32_t voids_at(const Filtration<D>& filtration, std::uint32_t index) {
  if (filtration.triangulation().affine_dimension() < D) return 0;
  const auto cells = filtration.triangulation().template cells<D>();
  const auto owners = filtration.table().facet_owners();
  const auto enters_of_cell = filtration.enters().subspan(filtration.table().first(D));
  const auto enters = filtration.enters().subspan(filtration.table().first(D - 1), owners.size());
  const auto outside = static_cast<std::uint32_t>(cells.size());
  UnionFind components(cells.size() + 1);
  for (std::uint32_t facet = 0; facet < owners.size(); ++facet) {
    if (enters[facet] <= index) continue;
    const std::uint32_t beyond = cells[owners[facet] / 4].neighbours[owners[facet] % 4];
    (void)components.unite(owners[facet] / 4, beyond == kOutside ? outside : beyond / 4);
  }
  const auto inside = std::count_if(enters_of_cell.begin(), enters_of_cell.end(),
                                    [&](std::uint32_t of) { return of <= index; });
  return static_cast<std::uint32_t>(components.set_count()) - static_cast<std::uint32_t>(inside) -
         1U;
}

}  // namespace

template <int D>
BettiNumbers<D> betti_numbers(const Filtration<D>& filtration, std::uint32_t index,
                              Threads threads) {
  if (index > filtration.spectrum_size()) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "index " + std::to_string(index) +
                         " is beyond the spectrum; indices are 0 to " +
                         std::to_string(filtration.spectrum_size()));
  }
  threads = threads.for_work(filtration.size(), kLeastSimplices);
  std::uint32_t joined = 0, voids = 0;
  parallel_for(threads, D == 3 ? 2 : 1, [&](std::size_t task) {
    if (D == 3 && task == 0) {
      voids = voids_at(filtration, index);
    } else {
      joined = joined_at(filtration, index);
    }
  });
  const auto up_to_index = [&](std::span<const std::uint32_t> indices) {
    return static_cast<std::uint32_t>(std::count_if(indices.begin(), indices.end(),
                                                    [&](std::uint32_t of) { return of <= index; }));
  };
  ByDimension<D> entered{};
  for (int k = 0; k <= D; ++k) {
    entered[static_cast<std::size_t>(k)] =
        up_to_index(filtration.enters().subspan(filtration.table().first(k), filtration.count(k)));
  }
  return betti_numbers<D>(entered, joined, voids);
}

template class CycleMarks<2>;
template class CycleMarks<3>;
template IndexCounts joining_counts<2>(const Filtration<2>&, Threads);
template IndexCounts joining_counts<3>(const Filtration<3>&, Threads);
template VoidCounts void_counts<2>(const Filtration<2>&, const FacetRoles<2>&, Threads);
template VoidCounts void_counts<3>(const Filtration<3>&, const FacetRoles<3>&, Threads);
template class BettiScan<2>;
template class BettiScan<3>;
template BettiNumbers<2> betti_numbers<2>(const Filtration<2>&, std::uint32_t, Threads);
template BettiNumbers<3> betti_numbers<3>(const Filtration<3>&, std::uint32_t, Threads);

}  // namespace orthoball
