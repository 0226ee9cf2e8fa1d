// SPDX-License-Identifier: MIT
#include "orthoball/queries/edge_rings.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace orthoball {
namespace {

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

// A way from one vertex along an edge to another.
struct Way {
  std::uint32_t from, to;
  std::size_t edge;
  friend bool operator<(const Way& a, const Way& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  }
};

}  // namespace

std::vector<std::vector<std::uint32_t>> edge_rings(
    std::span<const std::array<std::uint32_t, 2>> edges) {
  std::vector<Way> ways;
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto [a, b] = edges[edge];
    ways.push_back({a, b, edge});
    ways.push_back({b, a, edge});
  }
  std::sort(ways.begin(), ways.end());
  // By place of a vertex's first way: the next way not gone, and where the walk has been there.
  std::vector<std::size_t> next(ways.size()), place(ways.size(), kNowhere);
  for (std::size_t way = 0; way < ways.size(); ++way) next[way] = way;
  std::vector<bool> is_gone(edges.size(), false);
  const auto first_of = [&](std::uint32_t vertex) {
    const auto found = std::lower_bound(ways.begin(), ways.end(), Way{vertex, 0, 0});
    return static_cast<std::size_t>(found - ways.begin());
  };
  // The smallest way left at a vertex, which is gone then; null if none is.
  const auto way_on = [&](std::uint32_t vertex) -> const Way* {
    std::size_t& way = next[first_of(vertex)];
    while (way < ways.size() && ways[way].from == vertex && is_gone[ways[way].edge]) ++way;
    if (way == ways.size() || ways[way].from != vertex) return nullptr;
    is_gone[ways[way].edge] = true;
    return &ways[way];
  };

  std::vector<std::vector<std::uint32_t>> rings;
  for (const Way& begin : ways) {
    if (is_gone[begin.edge]) continue;
    std::vector<std::uint32_t> walk{begin.from};
    place[first_of(begin.from)] = 0;
    while (const Way* const way = way_on(walk.back())) {
      const std::size_t seen = place[first_of(way->to)];
      if (seen == kNowhere) {
        place[first_of(way->to)] = walk.size();
        walk.push_back(way->to);
        continue;
      }
      const auto ring = walk.begin() + static_cast<std::ptrdiff_t>(seen);
      rings.emplace_back(ring, walk.end());
      for (std::size_t i = seen + 1; i < walk.size(); ++i) place[first_of(walk[i])] = kNowhere;
      walk.resize(seen + 1);
    }
    for (const std::uint32_t vertex : walk) place[first_of(vertex)] = kNowhere;
  }
  return rings;
}

}  // namespace orthoball
