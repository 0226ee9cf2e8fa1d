// SPDX-License-Identifier: MIT
//
// A counting sort by the smallest corner, then a small sort among the cells that share it, on
// their way to the place where they stay. Until the neighbours are filled in, each new record has
// its old cell's number in the place of the first of them, and each old cell, whose corners are no
// longer needed, its new number and the way its corners went.
#include "orthoball/triangulation/canonical_cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace orthoball {
namespace {

/// Which corner of the new record each old corner has become, 2 bits each.
using CornerMap = std::uint32_t;

std::uint32_t mapped(CornerMap map, std::uint32_t old_corner) {
  return map >> (2 * old_corner) & 3U;
}

template <int A>
struct SortedCorners {
  std::array<std::uint32_t, std::size_t{A + 1}> corners;
  CornerMap map;
};

// The corners in ascending order, the last two exchanged after an odd permutation where orientation
// matters. By ranks, without branches: the order of four is as good as random.
template <int A>
SortedCorners<A> sorted_corners(const std::array<std::uint32_t, std::size_t{A + 1}>& old,
                                bool is_oriented) {
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
  SortedCorners<A> sorted{{}, 0};
  for (std::uint32_t i = 0; i <= A; ++i) {
    if (is_exchanged && rank[i] + 1 >= A) rank[i] = 2 * A - 1 - rank[i];
    sorted.corners[rank[i]] = old[i];
    sorted.map |= rank[i] << (2 * i);
  }
  return sorted;
}

/// The finite cells by their smallest corner.
struct ByFirstCorner {
  std::vector<std::uint32_t> begin;  // [site] where its cells begin; at the end, their number
  std::vector<std::uint32_t> cells;
};

// Leaves kOutside in the first corner of cells at infinity.
template <int A>
ByFirstCorner by_first_corner(CellStore<A>& cells, std::size_t sites) {
  const std::uint32_t old_cells = cells.size();
  const auto is_kept = [&](std::uint32_t cell) {
    return !cells.is_dead(cells[cell]) && cells.is_finite(cells[cell]);
  };
  const auto first_corner = [&](std::uint32_t cell) {
    const auto& corners = cells[cell].corners;
    return *std::min_element(corners.begin(), corners.end());
  };
  ByFirstCorner order{std::vector<std::uint32_t>(sites + 1, 0), {}};
  for (std::uint32_t cell = 0; cell < old_cells; ++cell) {
    if (is_kept(cell)) ++order.begin[first_corner(cell) + 1];
  }
  for (std::size_t site = 0; site < sites; ++site) order.begin[site + 1] += order.begin[site];

  order.cells.resize(order.begin[sites]);
  std::vector<std::uint32_t> next(order.begin.begin(), order.begin.end() - 1);
  for (std::uint32_t cell = 0; cell < old_cells; ++cell) {
    if (is_kept(cell)) {
      order.cells[next[first_corner(cell)]++] = cell;
    } else {
      cells[cell].corners[0] = kOutside;
    }
  }
  return order;
}

/// A cell among those that share its first corner.
template <int A>
struct CellAtSite {
  SortedCorners<A> sorted;
  std::uint32_t old;
  std::uint64_t key;  // the other corners, ascending, but for the largest of four
  std::uint32_t last;

  CellAtSite(const SortedCorners<A>& of, std::uint32_t cell) : sorted(of), old(cell) {
    const auto [low, high] = std::minmax(of.corners[A - 1], of.corners[A]);
    key = A == 3 ? std::uint64_t{of.corners[1]} << 32U | low : std::uint64_t{low} << 32U | high;
    last = high;
  }
  // 1 if *this comes before `other`: no branches.
  [[nodiscard]] std::uint32_t precedes(const CellAtSite& other) const {
    return static_cast<std::uint32_t>(key < other.key) |
           (static_cast<std::uint32_t>(key == other.key) &
            static_cast<std::uint32_t>(last < other.last));
  }
};

// Puts into ranks[i] how many of the cells come before cells[i].
template <int A>
void rank(const std::vector<CellAtSite<A>>& cells, std::vector<std::uint32_t>& ranks) {
  constexpr std::size_t kFew = 32;
  ranks.assign(cells.size(), 0);
  if (cells.size() <= kFew) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const std::uint32_t precedes = cells[i].precedes(cells[j]);
        ranks[j] += precedes;
        ranks[i] += 1 - precedes;
      }
    }
    return;
  }
  std::vector<std::uint32_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return cells[i].precedes(cells[j]) != 0; });
  for (std::uint32_t i = 0; i < order.size(); ++i) ranks[order[i]] = i;
}

}  // namespace

template <int A>
std::vector<CellRecord<A>> canonical_cells(CellStore<A> cells, const std::vector<bool>& is_hidden,
                                           bool is_oriented) {
  const std::size_t sites = is_hidden.size();
  std::vector<std::uint32_t> vertex_of(sites);  // [site]; means nothing where hidden
  std::uint32_t vertices = 0;
  for (std::size_t site = 0; site < sites; ++site) {
    vertex_of[site] = vertices;
    vertices += is_hidden[site] ? 0U : 1U;
  }
  const ByFirstCorner order = by_first_corner(cells, sites);

  // Old cells are far apart in memory where new ones are neighbours: ask for them ahead of use.
  constexpr std::size_t kAhead = 16;
  const std::size_t count = order.cells.size();
  std::vector<CellRecord<A>> result;
  result.reserve(count);
  std::vector<CellAtSite<A>> at_site;
  std::vector<std::uint32_t> ranks;
  for (std::size_t site = 0; site < sites; ++site) {
    at_site.clear();
    for (std::size_t i = order.begin[site]; i < order.begin[site + 1]; ++i) {
      if (i + kAhead < count) __builtin_prefetch(&cells[order.cells[i + kAhead]], 1);
      at_site.emplace_back(sorted_corners<A>(cells[order.cells[i]].corners, is_oriented),
                           order.cells[i]);
    }
    rank(at_site, ranks);
    result.resize(order.begin[site + 1]);
    for (std::size_t i = 0; i < at_site.size(); ++i) {
      const std::uint32_t cell = order.begin[site] + ranks[i];
      const auto& [corners, map] = at_site[i].sorted;
      for (std::size_t corner = 0; corner <= A; ++corner) {
        result[cell].corners[corner] = vertex_of[corners[corner]];
      }
      result[cell].neighbours[0] = at_site[i].old;
      auto& old_corners = cells[at_site[i].old].corners;
      old_corners[0] = cell;
      old_corners[1] = map;
    }
  }

  for (std::size_t cell = 0; cell < count; ++cell) {
    if (cell + 2 * kAhead < count) {
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
