// SPDX-License-Identifier: MIT
//
// A counting sort by the smallest corner, then a small sort among the cells that share it. Records
// are sorted where they will stay. Until the neighbours are filled in, each new record has its old
// cell's number in the place of the first of them, and each old cell, whose corners are no longer
// needed, its new number and the way its corners went.
#include "orthoball/triangulation/canonical_cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace orthoball {
namespace {

/// Which corner of the new record each old corner has become, 2 bits each.
using CornerMap = std::uint32_t;

std::uint32_t mapped(CornerMap map, std::uint32_t old_corner) {
  return map >> (2 * old_corner) & 3U;
}

// Puts the corners in ascending order, the last two exchanged after an odd permutation where
// orientation matters. By ranks, without branches: the order of four is as good as random.
template <int A>
CornerMap sort_corners(std::array<std::uint32_t, std::size_t{A + 1}>& corners, bool is_oriented) {
  const auto old = corners;
  std::array<std::uint32_t, std::size_t{A + 1}> rank{};
  std::uint32_t inversions = 0;
  for (std::size_t i = 0; i <= A; ++i) {
    for (std::size_t j = i + 1; j <= A; ++j) {
      const std::uint32_t inverted = old[i] > old[j] ? 1 : 0;
      rank[i] += inverted;
      rank[j] += 1 - inverted;
      inversions += inverted;
    }
  }
  const bool is_exchanged = is_oriented && inversions % 2 == 1;
  CornerMap map = 0;
  for (std::uint32_t i = 0; i <= A; ++i) {
    if (is_exchanged && rank[i] + 1 >= A) rank[i] = 2 * A - 1 - rank[i];
    corners[rank[i]] = old[i];
    map |= rank[i] << (2 * i);
  }
  return map;
}

template <int A>
bool comes_before(const CellRecord<A>& a, const CellRecord<A>& b) {
  // The last two corners may have changed places: the smaller one counts first.
  for (std::size_t i = 0; i + 1 < A; ++i) {
    if (a.corners[i] != b.corners[i]) return a.corners[i] < b.corners[i];
  }
  const auto last_two = [](const CellRecord<A>& cell) {
    return std::minmax(cell.corners[A - 1], cell.corners[A]);
  };
  return last_two(a) < last_two(b);
}

}  // namespace

template <int A>
std::vector<CellRecord<A>> canonical_cells(CellStore<A> cells, const std::vector<bool>& is_hidden,
                                           bool is_oriented) {
  const std::size_t sites = is_hidden.size();
  const auto old_cells = static_cast<std::uint32_t>(cells.size());
  std::vector<std::uint32_t> vertex_of(sites + 1, kOutside);  // [site]; infinity is none
  std::uint32_t vertices = 0;
  for (std::size_t site = 0; site < sites; ++site) {
    if (!is_hidden[site]) vertex_of[site] = vertices++;
  }
  // Dead cells take part in nothing more: they look like cells at infinity.
  for (const std::uint32_t cell : cells.released()) cells[cell].corners[0] = cells.infinity();
  const auto is_kept = [&](std::uint32_t cell) { return cells.is_finite(cells[cell]); };

  std::vector<std::uint32_t> begin_with(sites + 1, 0);  // [site] cells with a smaller first corner
  for (std::uint32_t cell = 0; cell < old_cells; ++cell) {
    if (!is_kept(cell)) continue;
    const auto& corners = cells[cell].corners;
    ++begin_with[*std::min_element(corners.begin(), corners.end()) + 1];
  }
  for (std::size_t site = 0; site < sites; ++site) begin_with[site + 1] += begin_with[site];

  std::vector<std::uint32_t> old_of(begin_with[sites]);  // [new cell, before the small sorts]
  std::vector<std::uint32_t> next_with(begin_with.begin(), begin_with.end() - 1);
  for (std::uint32_t cell = 0; cell < old_cells; ++cell) {
    auto& corners = cells[cell].corners;
    if (!is_kept(cell)) {
      corners[0] = kOutside;
      continue;
    }
    old_of[next_with[*std::min_element(corners.begin(), corners.end())]++] = cell;
  }

  // Old cells are far apart in memory where new ones are neighbours: ask for them ahead of use.
  constexpr std::size_t kAhead = 16;
  std::vector<CellRecord<A>> result;
  result.reserve(old_of.size());
  for (std::size_t cell = 0; cell < old_of.size(); ++cell) {
    if (cell + kAhead < old_of.size()) __builtin_prefetch(&cells[old_of[cell + kAhead]]);
    auto& old_corners = cells[old_of[cell]].corners;
    CellRecord<A> record{old_corners, {}};
    old_corners[1] = sort_corners<A>(record.corners, is_oriented);
    for (std::uint32_t& corner : record.corners) corner = vertex_of[corner];
    record.neighbours[0] = old_of[cell];
    result.push_back(record);
  }
  for (std::size_t site = 0; site < sites; ++site) {
    std::sort(result.begin() + begin_with[site], result.begin() + begin_with[site + 1],
              comes_before<A>);
    for (std::uint32_t cell = begin_with[site]; cell < begin_with[site + 1]; ++cell) {
      cells[result[cell].neighbours[0]].corners[0] = cell;
    }
  }

  for (std::size_t cell = 0; cell < result.size(); ++cell) {
    if (cell + 2 * kAhead < result.size()) {
      __builtin_prefetch(&cells[result[cell + 2 * kAhead].neighbours[0]]);
      for (const std::uint32_t facet : cells[result[cell + kAhead].neighbours[0]].neighbours) {
        __builtin_prefetch(&cells[facet / 4]);
      }
    }
    CellRecord<A>& record = result[cell];
    const auto& old = cells[record.neighbours[0]];
    for (std::uint32_t i = 0; i <= A; ++i) {
      const auto& beyond = cells[old.neighbours[i] / 4];
      const std::uint32_t corner = mapped(beyond.corners[1], old.neighbours[i] % 4);
      record.neighbours[mapped(old.corners[1], i)] =
          beyond.corners[0] == kOutside ? kOutside : 4 * beyond.corners[0] + corner;
    }
  }
  return result;
}

template std::vector<CellRecord<1>> canonical_cells<1>(CellStore<1>, const std::vector<bool>&,
                                                       bool);
template std::vector<CellRecord<2>> canonical_cells<2>(CellStore<2>, const std::vector<bool>&,
                                                       bool);
template std::vector<CellRecord<3>> canonical_cells<3>(CellStore<3>, const std::vector<bool>&,
                                                       bool);

}  // namespace orthoball
