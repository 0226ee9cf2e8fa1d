// SPDX-License-Identifier: MIT
//
// Simplices of one dimension come in the order of their keys, (enters, number). A simplex and its
// last facet are a pair if it is the facet's first coface; no column is needed to see that. In
// alpha complexes these apparent pairs are most, because attached simplices enter with a coface.
//
// In the highest dimension they make trees of cells, each pointing to the cell beyond its last
// facet, which comes later; a facet between two trees comes before all that lead from its ends to
// the roots, so trees can be joined as if they were single cells. In dimension 1 their boundaries
// are columns that need not be stored.
//
// Edelsbrunner, Letscher, Zomorodian. Topological persistence and simplification. Discrete &
// Computational Geometry 28 (2002).
// Bauer. Ripser: efficient computation of Vietoris-Rips persistence barcodes. Journal of Applied
// and Computational Topology 5 (2021), for apparent pairs.
#include "orthoball/topology/persistence.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "orthoball/filtration/face_vertices.h"
#include "orthoball/radix_sort.h"
#include "orthoball/raw_vector.h"
#include "orthoball/topology/facet_roles.h"
#include "orthoball/topology/keyed_simplices.h"
#include "orthoball/topology/spanning_forest.h"
#include "orthoball/topology/tunnel_reduction.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

template <int D>
class Pairing {
 public:
  Pairing(const Filtration<D>& filtration, WantedPairs wanted)
      : filtration_(filtration), wanted_(wanted) {}

  PersistencePairs<D> found(Threads threads) {
    threads = threads.for_work(filtration_.size(), kLeastSimplices);
    const int affine = filtration_.triangulation().affine_dimension();
    parallel_for(threads, 2, [&](std::size_t task) {
      if (task == 1) return pair_components();
      if (affine == 2) return pair_cells<2>();
      if constexpr (D == 3) {
        if (affine == 3) pair_cells<3>();
      }
    });
    if constexpr (D == 3) {
      if (affine == 3) pair_tunnels();
    }
    PersistencePairs<D> result;
    parallel_for(threads, std::size_t{D}, [&](std::size_t k) {
      radix_sort(pairs_[k]);
      result[k].reserve(pairs_[k].size());
      for (const KeyedRow& pair : pairs_[k]) {
        result[k].push_back({SimplexId(static_cast<std::uint32_t>(pair.key)), SimplexId(pair.row)});
      }
    });
    return result;
  }

 private:
  void add(int dimension, SimplexId birth, SimplexId death) {
    const std::uint32_t born = filtration_.enters(birth);
    if (wanted_ == WantedPairs::all || !death.exists() || born < filtration_.enters(death)) {
      pairs_[static_cast<std::size_t>(dimension)].push_back(
          {std::uint64_t{born} << 32U | birth.row(), death.row()});
    }
  }
  void pair_components();
  template <int A>
  void pair_cells();
  void pair_tunnels();

  const Filtration<D>& filtration_;
  WantedPairs wanted_;
  std::vector<bool> joins_;  // [edge]: two components
  std::vector<bool> cuts_;   // [facet]: the outside of the complex in two
  // [k]: (enters, number) of the birth, and the death.
  std::array<RawVector<KeyedRow>, std::size_t{D}> pairs_;
};

// Of two components that an edge joins, the one whose first vertex comes later ends.
template <int D>
void Pairing<D>::pair_components() {
  const KeyedSimplices vertices(filtration_, 0), edges(filtration_, 1);
  if (vertices.count() == 0) return;
  joins_.assign(edges.count(), false);
  const auto ends = [&](std::uint32_t edge) {
    return face_vertices<2>(filtration_, edges.id(edge));
  };
  struct Graph {
    const Filtration<D>& filtration;
    const KeyedSimplices& edges;
    [[nodiscard]] std::uint32_t node_count() const {
      return static_cast<std::uint32_t>(filtration.count(0));
    }
    [[nodiscard]] std::uint32_t edge_count() const { return edges.count(); }
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t edge) const {
      const auto vertices = face_vertices<2>(filtration, edges.id(edge));
      return {vertices[0], vertices[1]};
    }
    [[nodiscard]] std::uint32_t weight(std::uint32_t edge) const { return edges.enters(edge); }
    [[nodiscard]] std::uint32_t light_weight() const { return filtration.spectrum_size() / D; }
  };
  std::vector<std::uint64_t> joining;
  if (edges.count() > 0) {
    mark_spanning_forest(Graph{filtration_, edges}, Threads(1),
                         [&](std::size_t, std::uint32_t edge) {
                           joins_[edge] = true;
                           joining.push_back(edges.key(edge));
                         });
  }
  std::sort(joining.begin(), joining.end());
  // [vertex]: numbered by their keys, so that the smallest of a set is its first.
  std::vector<std::uint64_t> keys(vertices.count());
  for (std::uint32_t v = 0; v < keys.size(); ++v) keys[v] = vertices.key(v);
  std::sort(keys.begin(), keys.end());
  RawVector<std::uint32_t> rank(keys.size());
  const auto vertex_at = [&](std::uint32_t of) { return static_cast<std::uint32_t>(keys[of]); };
  for (std::uint32_t i = 0; i < keys.size(); ++i) rank[vertex_at(i)] = i;
  UnionFind components(keys.size());
  for (const std::uint64_t key : joining) {
    const auto edge = static_cast<std::uint32_t>(key);
    const auto [v, w] = ends(edge);
    const std::uint32_t a = components.find(rank[v]), b = components.find(rank[w]);
    add(0, vertices.id(vertex_at(std::max(a, b))), edges.id(edge));
    (void)components.unite(a, b);
  }
  add(0, vertices.id(vertex_at(0)), SimplexId());
}

// Seen backwards, as cells are taken away, a facet between two components of what is missing joins
// them, and the one whose last cell comes earlier ends: the void that this facet closes off and
// that cell fills. The outside comes after all.
template <int D>
template <int A>
void Pairing<D>::pair_cells() {
  const auto cells = filtration_.triangulation().template cells<A>();
  const SimplexTable<D>& table = filtration_.table();
  const auto owners = table.facet_owners();
  const KeyedSimplices facets(filtration_, A - 1), tops(filtration_, A);
  const auto outside = static_cast<std::uint32_t>(cells.size());
  cuts_.assign(facets.count(), false);
  const auto beyond = [&](std::uint32_t cell, std::uint32_t corner) {
    const std::uint32_t neighbour = cells[cell].neighbours[corner];
    return neighbour == kOutside ? outside : neighbour / 4;
  };
  // The last facet of each cell, and the apparent pairs.
  RawVector<std::uint32_t> last(outside), tree(outside + 1);
  {
    const auto later = [&](std::uint32_t facet, std::uint32_t than) {
      return than == kNone || facets.key(facet) > facets.key(than);
    };
    std::fill(last.begin(), last.end(), kNone);
    for (std::uint32_t facet = 0; facet < facets.count(); ++facet) {
      const std::uint32_t cell = owners[facet] / 4, other = beyond(cell, owners[facet] % 4);
      if (later(facet, last[cell])) last[cell] = facet;
      if (other != outside && later(facet, last[other])) last[other] = facet;
    }
  }
  std::vector<std::uint32_t> roots;
  for (std::uint32_t cell = 0; cell < outside; ++cell) {
    const std::uint32_t owner = owners[last[cell]] / 4;
    const std::uint32_t other = owner == cell ? beyond(cell, owners[last[cell]] % 4) : owner;
    const bool is_apparent = other == outside || tops.key(cell) < tops.key(other);
    tree[cell] = is_apparent ? other : cell;
    if (is_apparent) {
      cuts_[last[cell]] = true;
      add(A - 1, facets.id(last[cell]), tops.id(cell));
    } else {
      roots.push_back(cell);
    }
  }
  tree[outside] = outside;
  std::uint32_t tree_count = number_roots(tree, Threads(1));
  // What is left is few: the facets that join trees, from the last on.
  std::vector<std::uint64_t> joining;
  const std::uint32_t facet_count = facets.count();
  const auto joint = [&](std::uint32_t i) -> Joint {
    const std::uint32_t facet = facet_count - 1 - i;
    const std::uint32_t cell = owners[facet] / 4;
    return {tree[cell], tree[beyond(cell, owners[facet] % 4)], ~facets.enters(facet), facet};
  };
  join(joints_of(facet_count, Threads(1), joint), tree_count, Threads(1),
       [&](std::size_t, std::uint32_t facet) {
         cuts_[facet] = true;
         joining.push_back(facets.key(facet));
       });
  std::sort(joining.begin(), joining.end(), std::greater<>());
  // [tree]: numbered from the last root on; the outside is first.
  std::vector<std::uint64_t> keys{std::numeric_limits<std::uint64_t>::max()};
  for (const std::uint32_t root : roots) keys.push_back(tops.key(root));
  std::sort(keys.begin(), keys.end(), std::greater<>());
  RawVector<std::uint32_t> rank(keys.size());
  rank[tree[outside]] = 0;
  for (std::uint32_t i = 1; i < keys.size(); ++i) {
    rank[tree[static_cast<std::uint32_t>(keys[i])]] = i;
  }
  UnionFind components(keys.size());
  for (const std::uint64_t key : joining) {
    const auto facet = static_cast<std::uint32_t>(key);
    const std::uint32_t cell = owners[facet] / 4;
    const std::uint32_t a = components.find(rank[tree[cell]]),
                        b = components.find(rank[tree[beyond(cell, owners[facet] % 4)]]);
    add(A - 1, facets.id(facet), tops.id(static_cast<std::uint32_t>(keys[std::max(a, b)])));
    (void)components.unite(a, b);
  }
}

// The triangles that cut fill nothing, and the edges that join close nothing: neither is needed.
template <int D>
void Pairing<D>::pair_tunnels() {
  if constexpr (D == 3) {
    const KeyedSimplices edges(filtration_, 1), triangles(filtration_, 2);
    const TunnelReduction reduction(filtration_, joins_, cuts_);
    for (std::uint32_t edge = 0; edge < edges.count(); ++edge) {
      const std::uint32_t triangle = reduction.filled_by(edge);
      if (triangle != TunnelReduction::kNone) add(1, edges.id(edge), triangles.id(triangle));
    }
  }
}

}  // namespace

template <int D>
PersistencePairs<D> persistence_pairs(const Filtration<D>& filtration, WantedPairs wanted,
                                      Threads threads) {
  return Pairing<D>(filtration, wanted).found(threads);
}

template <int D>
PersistencePairs<D> pairs_of_length(const Filtration<D>& filtration, PersistencePairs<D> pairs,
                                    double least) {
  const auto is_short = [&](const PersistencePair& pair) {
    if (!pair.death.exists()) return false;
    const double length = filtration.alpha2(filtration.enters(pair.death)) -
                          filtration.alpha2(filtration.enters(pair.birth));
    return length < least;
  };
  for (auto& of_dimension : pairs) std::erase_if(of_dimension, is_short);
  return pairs;
}

template PersistencePairs<2> persistence_pairs<2>(const Filtration<2>&, WantedPairs, Threads);
template PersistencePairs<3> persistence_pairs<3>(const Filtration<3>&, WantedPairs, Threads);
template PersistencePairs<2> pairs_of_length<2>(const Filtration<2>&, PersistencePairs<2>, double);
template PersistencePairs<3> pairs_of_length<3>(const Filtration<3>&, PersistencePairs<3>, double);

}  // namespace orthoball
