// SPDX-License-Identifier: MIT
#include "orthoball/queries/edges_at_vertices.h"

#include <algorithm>

#include "orthoball/filtration/face_vertices.h"
#include "orthoball/topology/keyed_simplices.h"

namespace orthoball {

template <int D>
EdgesAtVertices::EdgesAtVertices(const Filtration<D>& filtration)
    : first_(filtration.count(0) + 1, 0), ways_(2 * filtration.count(1)) {
  const KeyedSimplices edges(filtration, 1);
  for (std::uint32_t edge = 0; edge < edges.count(); ++edge) {
    for (const std::uint32_t end : face_vertices<2>(filtration, edges.id(edge))) ++first_[end + 1];
  }
  for (std::size_t vertex = 1; vertex < first_.size(); ++vertex) {
    first_[vertex] += first_[vertex - 1];
  }
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t edge = 0; edge < edges.count(); ++edge) {
    const auto [v, w] = face_vertices<2>(filtration, edges.id(edge));
    ways_[next[v]++] = {edge, w};
    ways_[next[w]++] = {edge, v};
  }
  for (std::size_t vertex = 0; vertex + 1 < first_.size(); ++vertex) {
    std::sort(ways_.begin() + first_[vertex], ways_.begin() + first_[vertex + 1],
              [&](const Way& a, const Way& b) { return edges.key(a.edge) < edges.key(b.edge); });
  }
}
template EdgesAtVertices::EdgesAtVertices(const Filtration<2>&);
template EdgesAtVertices::EdgesAtVertices(const Filtration<3>&);

}  // namespace orthoball
