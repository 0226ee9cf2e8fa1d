// SPDX-License-Identifier: MIT
//
// The pieces of a union (contact_facets.cpp) that change with alpha2 between two indices belong to
// simplices on the boundary of the complex. What is left of a ball is told by all edges of its
// centre, so that of the edges those count that have an end on the boundary.
#include "orthoball/signatures/ball_signature.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "orthoball/measures/compensated_sum.h"
#include "orthoball/measures/contact_facets.h"
#include "orthoball/measures/input_units.h"
#include "orthoball/signatures/signature.h"

namespace orthoball {
namespace {

// The simplices whose intervals contain an index, ascending.
std::vector<SimplexId> at_index(const IntervalTree& tree, std::uint32_t first,
                                std::uint32_t index) {
  std::vector<SimplexId> result;
  tree.for_each_containing(index, [&](std::uint32_t row) { result.emplace_back(first + row); });
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

template <int D>
BallBoundaries<D>::BallBoundaries(const Filtration<D>& filtration) : filtration_(&filtration) {
  std::vector<IndexInterval> intervals;
  for (std::uint32_t vertex = 0; vertex < filtration.count(0); ++vertex) {
    const SimplexId id(vertex);
    intervals.push_back({filtration.enters(id), filtration.interior(id)});
  }
  vertices_ = IntervalTree(intervals);
  const std::uint32_t first = filtration.table().first(1);
  std::vector<IndexInterval> of_edges;
  for (std::uint32_t edge = 0; edge < filtration.count(1); ++edge) {
    const SimplexId id(first + edge);
    std::uint32_t end = 0;
    for (const VertexId vertex : filtration.vertices(id)) {
      end = std::max(end, intervals[vertex.row()].end);
    }
    of_edges.push_back({filtration.enters(id), end});
  }
  edges_ = IntervalTree(of_edges);
}

template <int D>
typename BallBoundaries<D>::Measures BallBoundaries<D>::measures(const BallAlpha& alpha,
                                                                 Threads threads) const {
  constexpr double kAllDirections = (D == 3 ? 4 : 2) * std::numbers::pi;
  const ContactFacets<D> facets(*filtration_, alpha.index, alpha.alpha2, threads);
  std::vector<double> taken(filtration_->count(0), 0.0);
  CompensatedSum volume, area;
  for_each_facet<D>(facets, at_index(edges_, filtration_->table().first(1), alpha.index), threads,
                    [&](const ContactFacet<D>& facet) {
                      volume.add(facet.pieces);
                      for (std::size_t end = 0; end < 2; ++end) {
                        taken[facet.ends[end]] += facet.taken[end];
                      }
                    });
  for (const SimplexId vertex : at_index(vertices_, 0, alpha.index)) {
    const double r = facets.spheres()[vertex.row()].radius;
    const double exposed = std::max(0.0, kAllDirections - taken[vertex.row()]);
    const double own = exposed * (D == 3 ? r * r : r);
    area.add(own);
    volume.add(own * r / D);
  }
  return {facets.units(D)(volume.value()), facets.units(D - 1)(area.value())};
}

template <int D>
std::vector<BallSignature<D>> ball_signatures(const Filtration<D>& filtration,
                                              std::span<const BallAlpha> alphas, Threads threads) {
  std::vector<std::uint32_t> indices;
  for (const BallAlpha& alpha : alphas) indices.push_back(alpha.index);
  const std::vector<Signature<D>> of_complex = signatures<D>(filtration, indices, threads);
  std::vector<BallSignature<D>> result;
  if (alphas.empty()) return result;
  const BallBoundaries<D> boundaries(filtration);
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const auto of_balls = boundaries.measures(alphas[i], threads);
    const Signature<D>& signature = of_complex[i];
    result.push_back({alphas[i].index, alphas[i].alpha2, signature.betti, signature.euler,
                      signature.volume + of_balls.volume, of_balls.area});
  }
  return result;
}

template class BallBoundaries<2>;
template class BallBoundaries<3>;
template std::vector<BallSignature<2>> ball_signatures(const Filtration<2>&,
                                                       std::span<const BallAlpha>, Threads);
template std::vector<BallSignature<3>> ball_signatures(const Filtration<3>&,
                                                       std::span<const BallAlpha>, Threads);

}  // namespace orthoball
