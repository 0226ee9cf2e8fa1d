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
// Simplices near in the filter are far apart in memory. So they are taken in blocks, and each step
// of the way to their entries in the union-find is prefetched for a whole block at once.
#include "orthoball/topology/betti.h"

#include <algorithm>
#include <bit>
#include <span>
#include <string>

#include "orthoball/error.h"
#include "orthoball/filtration/face_vertices.h"
#include "orthoball/topology/union_find.h"

namespace orthoball {
namespace {

constexpr std::size_t kBlock = 256;

// The simplices of one dimension in a stretch of the filter, with two nodes to join for each.
struct Block {
  std::array<std::size_t, kBlock> position;
  std::array<std::uint32_t, kBlock> simplex;
  std::array<std::uint32_t, kBlock> a, b;
  std::size_t size = 0;

  void push(std::size_t at, std::uint32_t id) {
    position[size] = at;
    simplex[size] = id;
    ++size;
  }
};

}  // namespace

template <int D>
CycleMarks<D>::CycleMarks(const Filtration<D>& filtration) : bits_(filtration.size() / 64 + 1, 0) {
  mark_vertices_and_edges(filtration);
  if constexpr (D == 3) mark_triangles(filtration);
}

template <int D>
void CycleMarks<D>::mark_vertices_and_edges(const Filtration<D>& filtration) {
  const std::span<const SimplexId> filter = filtration.filter();
  const SimplexTable<D>& table = filtration.table();
  const std::uint32_t first_edge = table.first(1);
  const auto edge_count = static_cast<std::uint32_t>(table.count(1));
  const auto cells = filtration.triangulation().template cells<D>();
  const std::span<const std::uint32_t> owners = D == 3 ? table.edge_owners() : table.facet_owners();
  constexpr std::uint32_t kOwnerDivisor = D == 3 ? 6 : 4;
  UnionFind components(filtration.triangulation().vertex_count());
  Block block;
  const auto flush = [&] {
    if (components.set_count() == 1) {  // then every edge closes a cycle
      for (std::size_t i = 0; i < block.size; ++i) mark(block.position[i]);
      block.size = 0;
      return;
    }
    if (!cells.empty()) {
      for (std::size_t i = 0; i < block.size; ++i) {
        __builtin_prefetch(&owners[block.simplex[i] - first_edge]);
      }
      for (std::size_t i = 0; i < block.size; ++i) {
        __builtin_prefetch(&cells[owners[block.simplex[i] - first_edge] / kOwnerDivisor]);
      }
    }
    for (std::size_t i = 0; i < block.size; ++i) {
      const auto ends = face_vertices<2>(filtration, SimplexId(block.simplex[i]));
      block.a[i] = ends[0];
      block.b[i] = ends[1];
      components.prefetch(ends[0]);
      components.prefetch(ends[1]);
    }
    for (std::size_t i = 0; i < block.size; ++i) {
      if (!components.unite(block.a[i], block.b[i])) mark(block.position[i]);
    }
    block.size = 0;
  };
  for (std::size_t position = 0; position < filter.size(); ++position) {
    const std::uint32_t simplex = filter[position].row();
    if (simplex < first_edge) mark(position);
    if (simplex - first_edge >= edge_count) continue;
    block.push(position, simplex);
    if (block.size == kBlock) flush();
  }
  flush();
}

template <int D>
void CycleMarks<D>::mark_triangles(const Filtration<D>& filtration) {
  const auto cells = filtration.triangulation().template cells<D>();
  const std::span<const std::uint32_t> owners = filtration.table().facet_owners();
  const auto outside = static_cast<std::uint32_t>(cells.size());
  const std::uint32_t first = filtration.table().first(2);
  const auto count = static_cast<std::uint32_t>(filtration.count(2));
  if (cells.empty()) return;
  UnionFind voids(cells.size() + 1);
  Block block;
  const auto flush = [&] {
    for (std::size_t i = 0; i < block.size; ++i) {
      __builtin_prefetch(&owners[block.simplex[i] - first]);
    }
    for (std::size_t i = 0; i < block.size; ++i) {
      block.a[i] = owners[block.simplex[i] - first];
      __builtin_prefetch(&cells[block.a[i] / 4]);
    }
    for (std::size_t i = 0; i < block.size; ++i) {
      const std::uint32_t cell = block.a[i] / 4;
      const std::uint32_t beyond = cells[cell].neighbours[block.a[i] % 4];
      block.a[i] = cell;
      block.b[i] = beyond == kOutside ? outside : beyond / 4;
      voids.prefetch(block.a[i]);
      voids.prefetch(block.b[i]);
    }
    for (std::size_t i = 0; i < block.size; ++i) {
      if (voids.unite(block.a[i], block.b[i])) mark(block.position[i]);
    }
    block.size = 0;
  };
  const std::span<const SimplexId> filter = filtration.filter();
  for (std::size_t position = filter.size(); position-- > 0;) {
    const std::uint32_t simplex = filter[position].row();
    if (simplex - first >= count) continue;
    block.push(position, simplex);
    if (block.size == kBlock) flush();
  }
  flush();
}

template <int D>
std::uint32_t CycleMarks<D>::count(std::size_t begin, std::size_t end) const {
  std::uint32_t total = 0;
  while (begin < end) {
    const std::size_t shift = begin % 64;
    const std::size_t taken = std::min<std::size_t>(64 - shift, end - begin);
    const std::uint64_t word = bits_[begin / 64] >> shift << (64 - taken);
    total += static_cast<std::uint32_t>(std::popcount(word));
    begin += taken;
  }
  return total;
}

template <int D>
void BettiScan<D>::advance(const ByDimension<D>& entering) {
  for (std::size_t k = 0; k < entering.size(); ++k) {
    if (entering[k] == 0) continue;
    const std::uint32_t closing = marks_.count(position_, position_ + entering[k]);
    if (k < D) betti_[k] += closing;
    if (k > 0) betti_[k - 1] -= entering[k] - closing;
    position_ += entering[k];
  }
}

template <int D>
BettiNumbers<D> betti_numbers(const Filtration<D>& filtration, std::uint32_t index) {
  if (index > filtration.spectrum_size()) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "index " + std::to_string(index) +
                         " is beyond the spectrum; indices are 0 to " +
                         std::to_string(filtration.spectrum_size()));
  }
  BettiScan<D> scan(filtration);
  FilterSteps<D> steps(filtration);
  while (steps.index() < index && steps.next()) scan.advance(steps.entering());
  return scan.betti();
}

template class CycleMarks<2>;
template class CycleMarks<3>;
template class BettiScan<2>;
template class BettiScan<3>;
template BettiNumbers<2> betti_numbers<2>(const Filtration<2>&, std::uint32_t);
template BettiNumbers<3> betti_numbers<3>(const Filtration<3>&, std::uint32_t);

}  // namespace orthoball
