// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filtration.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/filtration/attached_simplices.h"
#include "orthoball/filtration/ranks_among.h"
#include "orthoball/filtration/value_ranks.h"
#include "orthoball/large_blocks.h"

namespace orthoball {
namespace {

std::size_t count_ones(std::span<const std::uint64_t> words) {
  std::size_t ones = 0;
  for (const std::uint64_t word : words) ones += static_cast<std::size_t>(std::popcount(word));
  return ones;
}

}  // namespace

template <int D>
Filtration<D>::Filtration(RegularTriangulation<D> triangulation, Threads threads)
    : triangulation_(std::move(triangulation)) {
  const LargeBlockReuse reuse;
  typename SimplexTable<D>::EdgesOfCells edges_of_cells;
  table_ = SimplexTable<D>(triangulation_, edges_of_cells, threads);
  is_attached_ = attached_simplices(triangulation_, table_, edges_of_cells, threads);
  RawVector<SimplexId> order(size() - count_ones(is_attached_));
  ValueRanks ranks = value_ranks(triangulation_, table_, is_attached_, std::span(order), threads);
  spectrum_ = std::move(ranks.spectrum);
  indices_ = critical_indices(
      triangulation_, table_, edges_of_cells, is_attached_, spectrum_size(),
      [&](std::span<std::uint32_t> enters) { deal_ranks(order, ranks.starts, enters, threads); },
      threads);
}

template <int D>
Filtration<D>::Filtration(RegularTriangulation<D> triangulation, std::span<const double> alpha2,
                          Threads threads)
    : triangulation_(std::move(triangulation)),
      spectrum_(alpha2.begin(), alpha2.end()),
      is_coarse_(true) {
  spectrum_.push_back(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < alpha2.size(); ++i) {
    if (std::isfinite(alpha2[i]) && alpha2[i] < spectrum_[i + 1]) continue;
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "values of alpha2 must be finite and ascend; value " + std::to_string(i) +
                         " is " + std::to_string(alpha2[i]));
  }
  const LargeBlockReuse reuse;
  typename SimplexTable<D>::EdgesOfCells edges_of_cells;
  table_ = SimplexTable<D>(triangulation_, edges_of_cells, threads);
  is_attached_ = attached_simplices(triangulation_, table_, edges_of_cells, threads);
  indices_ = critical_indices(
      triangulation_, table_, edges_of_cells, is_attached_, spectrum_size(),
      [&](std::span<std::uint32_t> enters) {
        ranks_among(alpha2, triangulation_, table_, is_attached_, enters, threads);
      },
      threads);
}

template <int D>
FewOf<SiteId, D> Filtration<D>::rows(SimplexId simplex) const {
  FewOf<SiteId, D> result;
  for (const VertexId vertex : vertices(simplex)) {
    result.insert(triangulation_.sites().row(vertex.row()));
  }
  return result;
}

template <int D>
std::uint32_t Filtration<D>::index(double alpha2) const {
  const auto beyond = std::upper_bound(spectrum().begin(), spectrum().end(), alpha2);
  return static_cast<std::uint32_t>(beyond - spectrum().begin());
}

template class Filtration<2>;
template class Filtration<3>;

}  // namespace orthoball
