// SPDX-License-Identifier: MIT
#include "orthoball/output/snapshot_cycles.h"

#include <algorithm>
#include <map>
#include <utility>

#include "orthoball/queries/representatives.h"

namespace orthoball {
namespace {

constexpr std::size_t kMostCycles = 100;
constexpr std::size_t kMostEdges = 20'000;

}  // namespace

template <int D>
SnapshotCycles snapshot_cycles(const Filtration<D>& filtration,
                               const std::vector<PersistencePair>& tunnels, Threads threads) {
  SnapshotCycles result;
  const bool is_in_space = D == 3 && filtration.triangulation().affine_dimension() == 3;
  if (!is_in_space || tunnels.empty() || filtration.size() > kMostSimplicesForCycles) return result;
  std::vector<std::pair<double, std::uint32_t>> lives;  // less than 0, and the pair
  for (std::uint32_t pair = 0; pair < tunnels.size(); ++pair) {
    const auto alpha2 = [&](SimplexId simplex) {
      return filtration.alpha2(filtration.enters(simplex));
    };
    lives.emplace_back(alpha2(tunnels[pair].birth) - alpha2(tunnels[pair].death), pair);
  }
  std::sort(lives.begin(), lives.end());
  const auto all = persistence_pairs(filtration, WantedPairs::all, threads);
  Representatives<D> representatives(filtration, all);
  std::map<std::uint32_t, std::vector<SimplexId>> cycles;
  std::size_t edges = 0;
  for (const auto& [life, pair] : lives) {
    if (cycles.size() == kMostCycles) break;
    const PersistencePair& tunnel = tunnels[pair];
    auto cycle = representatives.at(1, tunnel, representatives.usual_index(1, tunnel)).cycle;
    edges += cycle.size();
    if (edges > kMostEdges) break;
    cycles.emplace(pair, std::move(cycle));
  }
  for (const auto& [pair, cycle] : cycles) {
    for (const SimplexId edge : cycle) {
      result.edges.push_back(edge.row() - filtration.table().first(1));
    }
    result.pairs.push_back(pair);
    result.ends.push_back(static_cast<std::uint32_t>(result.edges.size()));
  }
  return result;
}

template SnapshotCycles snapshot_cycles<2>(const Filtration<2>&,
                                           const std::vector<PersistencePair>&, Threads);
template SnapshotCycles snapshot_cycles<3>(const Filtration<3>&,
                                           const std::vector<PersistencePair>&, Threads);

}  // namespace orthoball
