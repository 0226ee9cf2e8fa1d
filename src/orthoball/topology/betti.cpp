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

#include <limits>
#include <span>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/filtration/face_vertices.h"
#include "orthoball/topology/spanning_forest.h"

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
    constexpr std::size_t kPart = D == 3 ? 7 : 3;
    return filtration.enters(filtration.filter()[filtration.size() / kPart]);
  }

 private:
  [[nodiscard]] SimplexId simplex(std::uint32_t edge) const {
    return SimplexId(filtration.table().first(1) + edge);
  }
};

// The cells, the outside as the last node, and the triangles between them; the last triangle of the
// filter is the least.
struct Voids {
  const Filtration<3>& filtration;
  std::span<const CellRecord<3>> cells = filtration.triangulation().cells<3>();
  std::span<const std::uint32_t> owners = filtration.table().facet_owners();

  [[nodiscard]] std::uint32_t node_count() const { return outside() + 1; }
  [[nodiscard]] std::uint32_t edge_count() const {
    return static_cast<std::uint32_t>(owners.size());
  }
  [[nodiscard]] Ends ends(std::uint32_t edge) const {
    const std::uint32_t owner = owners[triangle(edge)];
    const std::uint32_t beyond = cells[owner / 4].neighbours[owner % 4];
    return {owner / 4, beyond == kOutside ? outside() : beyond / 4};
  }
  [[nodiscard]] std::uint32_t weight(std::uint32_t edge) const {
    const SimplexId simplex(filtration.table().first(2) + triangle(edge));
    return filtration.spectrum_size() - filtration.enters(simplex);
  }
  [[nodiscard]] std::uint32_t light_weight() const { return filtration.spectrum_size(); }
  [[nodiscard]] std::uint32_t triangle(std::uint32_t edge) const { return edge_count() - 1 - edge; }

 private:
  [[nodiscard]] std::uint32_t outside() const { return static_cast<std::uint32_t>(cells.size()); }
};

}  // namespace

template <int D>
CycleMarks<D>::CycleMarks(const Filtration<D>& filtration)
    : first_edge_(filtration.table().first(1)),
      first_triangle_(filtration.table().first(2)),
      size_(static_cast<std::uint32_t>(filtration.size())),
      forests_(filtration.size() / 64 + 1, 0) {
  if (filtration.count(1) > 0) {
    mark_spanning_forest(Components<D>{filtration},
                         [&](std::uint32_t edge) { mark(first_edge_ + edge); });
  }
  if constexpr (D == 3) {
    const Voids voids{filtration};
    if (voids.cells.empty()) return;
    mark_spanning_forest(voids,
                         [&](std::uint32_t edge) { mark(first_triangle_ + voids.triangle(edge)); });
  }
}

template <int D>
BettiScan<D>::BettiScan(const Filtration<D>& filtration) {
  const CycleMarks<D> marks(filtration);
  const auto entering = [&](const auto& visit) {
    return [&](SimplexId simplex) { visit(filtration.enters(simplex)); };
  };
  joining_ = {filtration.spectrum_size(),
              [&](const auto& visit) { marks.for_each_joining(entering(visit)); }};
  cutting_ = {filtration.spectrum_size(),
              [&](const auto& visit) { marks.for_each_cutting(entering(visit)); }};
}

template <int D>
void BettiScan<D>::advance(const ByDimension<D>& entering) {
  ++index_;
  const std::uint32_t joining = joining_.count(index_);
  const std::uint32_t cutting = cutting_.count(index_);
  betti_[0] += entering[0] - joining;
  betti_[1] += (entering[1] - joining) - (entering[2] - cutting);
  if constexpr (D == 3) betti_[2] += cutting - entering[3];
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
