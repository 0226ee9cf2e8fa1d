// SPDX-License-Identifier: MIT
#include "orthoball/queries/edge_rings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace orthoball {

std::vector<std::vector<std::uint32_t>> edge_rings(
    std::span<const std::array<std::uint32_t, 2>> edges) {
  std::map<std::uint32_t, std::set<std::uint32_t>> ways;
  for (const auto& [a, b] : edges) {
    ways[a].insert(b);
    ways[b].insert(a);
  }
  std::vector<std::vector<std::uint32_t>> rings;
  while (!ways.empty()) {
    std::vector<std::uint32_t> walk{ways.begin()->first};
    while (true) {
      const std::uint32_t from = walk.back();
      const auto here = ways.find(from);
      if (here == ways.end()) break;
      const std::uint32_t to = *here->second.begin();
      for (const auto& [a, b] : {std::pair(from, to), std::pair(to, from)}) {
        const auto way = ways.find(a);
        way->second.erase(b);
        if (way->second.empty()) ways.erase(way);
      }
      const auto seen = std::find(walk.begin(), walk.end(), to);
      if (seen == walk.end()) {
        walk.push_back(to);
        continue;
      }
      rings.emplace_back(seen, walk.end());
      walk.erase(seen + 1, walk.end());
    }
  }
  return rings;
}

}  // namespace orthoball
