// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filtration.h"

#include <algorithm>
#include <array>
#include <utility>

namespace orthoball {
namespace {

// Where the elements of each of `counts` begin.
void sum_before(std::span<std::uint32_t> counts) {
  std::uint32_t first = 0;
  for (std::uint32_t& count : counts) first += std::exchange(count, first);
}

// Simplices by (enters, number), and numbers ascend with dimensions: two stable counting sorts, by
// the upper half of the index, then within each bucket by the lower half, which stays in the cache.
// Sets the bit of each position in `starts` at which an index starts.
std::vector<SimplexId> sorted_by(std::span<const std::uint32_t> enters, std::uint32_t indices,
                                 std::vector<std::uint64_t>& starts) {
  std::vector<std::uint32_t> first((indices >> 16U) + 2, 0);
  for (const std::uint32_t index : enters) ++first[index >> 16U];
  sum_before(first);
  std::vector<SimplexId> sorted(enters.size());
  std::vector<std::uint16_t> lower(enters.size());  // [place]
  std::vector<std::uint32_t> next = first;
  for (std::uint32_t simplex = 0; simplex < enters.size(); ++simplex) {
    const std::uint32_t place = next[enters[simplex] >> 16U]++;
    sorted[place] = SimplexId(simplex);
    lower[place] = static_cast<std::uint16_t>(enters[simplex]);
  }

  std::vector<SimplexId> bucket;
  for (std::size_t upper = 0; upper + 1 < first.size(); ++upper) {
    const auto begin = sorted.begin() + first[upper];
    bucket.assign(begin, sorted.begin() + first[upper + 1]);
    next.assign(std::size_t{1} << 16U, 0);
    for (std::size_t i = 0; i < bucket.size(); ++i) ++next[lower[first[upper] + i]];
    sum_before(next);
    for (std::uint32_t start : next) {
      start += first[upper];
      starts[start / 64] |= std::uint64_t{1} << start % 64;
    }
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      begin[next[lower[first[upper] + i]]++] = bucket[i];
    }
  }
  return sorted;
}

}  // namespace

template <int D>
Filtration<D>::Filtration(RegularTriangulation<D> triangulation)
    : triangulation_(std::move(triangulation)) {
  {
    typename SimplexTable<D>::EdgesOfCells edges_of_cells;
    table_ = SimplexTable<D>(triangulation_, edges_of_cells);
    critical_ = critical_alpha2(triangulation_, table_, edges_of_cells);
  }
  index_starts_.assign(size() / 64 + 1, 0);
  filter_ = sorted_by(critical_.enters, spectrum_size(), index_starts_);
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
