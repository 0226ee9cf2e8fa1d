// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/parallel.h"

namespace orthoball {

/// Which power cells have a facet in common.
///
/// Two that do are joined by an edge of the triangulation, but not the other way round: where cells
/// of the triangulation have a common orthocentre, as in grids, power cells meet in less than a
/// facet. And a power cell may be flat, without an inside, where a site has just not become hidden:
/// it has no neighbours and is nobody's; the cells on its two sides, if it has a facet's dimension,
/// are neighbours of each other. So is_neighbour is symmetric, and the neighbours of a cell bound
/// it.
///
/// Exact, on the numbers as they are: nothing is perturbed. Linear in the simplices. Refers to
/// nothing once built; immutable; any number of threads may read it.
template <int D>
class PowerNeighbours {
 public:
  explicit PowerNeighbours(const Filtration<D>& filtration, Threads threads = {});

  /// The neighbours of the power cell of a vertex, ascending; none of a flat one, and none of a
  /// vertex that is alone. Valid as long as this.
  [[nodiscard]] std::span<const VertexId> of(VertexId vertex) const {
    const std::size_t begin = first_[vertex.row()], end = first_[vertex.row() + std::size_t{1}];
    return {neighbours_.data() + begin, end - begin};
  }
  /// Whether the power cell of a vertex has an inside.
  [[nodiscard]] bool has_inside(VertexId vertex) const { return !is_flat_[vertex.row()]; }

 private:
  std::vector<VertexId> neighbours_;
  std::vector<std::size_t> first_;  // [vertex]: where its neighbours begin; one more at the end
  std::vector<bool> is_flat_;       // [vertex]
};

extern template class PowerNeighbours<2>;  // defined in power_neighbours.cpp
extern template class PowerNeighbours<3>;

}  // namespace orthoball
