// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filtration.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "orthoball/filtration/attached_simplices.h"
#include "orthoball/filtration/filter_order.h"
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
  indices_ = critical_indices(triangulation_, table_, edges_of_cells, is_attached_, order,
                              ranks.starts, threads);
  edges_of_cells = typename SimplexTable<D>::EdgesOfCells();
  filter_.resize(size());
  index_starts_ = fill_filter(order, ranks.starts, indices_.enters, is_attached_, threads, filter_);
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

template <int D>
std::size_t Filtration<D>::complex_size(std::uint32_t index) const {
  const auto beyond =
      std::upper_bound(filter_.begin(), filter_.end(), index,
                       [&](std::uint32_t i, SimplexId simplex) { return i < enters(simplex); });
  return static_cast<std::size_t>(beyond - filter_.begin());
}

template <int D>
std::vector<SimplexId> Filtration<D>::filter_by_rows() const {
  struct Keyed {
    FewOf<SiteId, D> rows;
    SimplexId simplex;
  };
  std::vector<SimplexId> sorted(filter_.begin(), filter_.end());
  std::vector<Keyed> tied;
  for (std::size_t begin = 0; begin < sorted.size();) {
    const auto is_tied = [&](SimplexId simplex) {
      return enters(simplex) == enters(sorted[begin]) &&
             dimension(simplex) == dimension(sorted[begin]);
    };
    std::size_t end = begin + 1;
    while (end < sorted.size() && is_tied(sorted[end])) ++end;
    if (end - begin > 1) {
      tied.clear();
      for (std::size_t i = begin; i < end; ++i) tied.push_back({rows(sorted[i]), sorted[i]});
      std::sort(tied.begin(), tied.end(), [](const Keyed& a, const Keyed& b) {
        return std::lexicographical_compare(a.rows.begin(), a.rows.end(), b.rows.begin(),
                                            b.rows.end());
      });
      for (std::size_t i = begin; i < end; ++i) sorted[i] = tied[i - begin].simplex;
    }
    begin = end;
  }
  return sorted;
}

template class Filtration<2>;
template class Filtration<3>;

}  // namespace orthoball
