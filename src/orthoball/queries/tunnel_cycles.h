// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/queries/edge_chain.h"
#include "orthoball/queries/edge_classes.h"
#include "orthoball/queries/edges_at_vertices.h"
#include "orthoball/topology/persistence.h"

namespace orthoball {

/// Short cycles around the tunnels of sites that span space.
///
/// A cycle of a tunnel is born and dies with it, exactly, over Z/2: in the complex of the index
/// that is asked for it is homologous to the chain of edges that reduction finds for the tunnel, up
/// to cycles that are born before and die before. It is short as far as this search goes: that
/// chain, shortened over single triangles; if that is shorter, the shortest of such loops that a
/// tree of shortest paths and one more edge make, from both ends of the edge of birth, then from
/// some vertices of what was found until that is no shorter. Where there is no such loop, the chain
/// ring by ring in the same way.
///
/// The search for one cycle reaches no more than some thousand vertices and, for the tunnel with
/// the r-th longest life, 8 / r times as many as there are: then it keeps what it has. So all
/// cycles together cost nearly what is linear in the vertices and the chains. 60 bytes a vertex, 13
/// an edge, the classes that are kept (4 bytes for each tunnel in each) and EdgeClasses. Refers to
/// what it is made from. Not for several threads at once.
/// @cite erickson_whittlesey_2005
class TunnelCycles {
 public:
  /// @param all      all pairs of the filtration, WantedPairs::all.
  /// @param lengths  [edge], in any unit.
  TunnelCycles(const Filtration<3>& filtration, const PersistencePairs<3>& all,
               const EdgesAtVertices& ways, std::vector<double> lengths);

  /// The cycle of the tunnel that an edge closes, at an index at which it lives.
  [[nodiscard]] EdgeChain cycle(std::uint32_t birth_edge, std::uint32_t index);

 private:
  struct Loop {
    double length;
    EdgeChain edges;
  };
  // A vertex in the tree of one search.
  struct Reached {
    double distance = 0.0;
    std::uint32_t search = 0, edge = 0, from = 0;
    bool is_settled = false;
    EdgeChain of_class;
  };

  void rank_lives(const std::vector<PersistencePair>& tunnels);
  [[nodiscard]] EdgeChain chain_of(std::uint32_t birth_edge);
  void add_way_between_ends(std::uint32_t edge, EdgeChain& edges) const;
  void look_from(std::uint32_t root, const EdgeChain& wanted, Loop& best);
  void tighten(const EdgeChain& wanted, std::set<std::uint32_t> seen, Loop& best);
  [[nodiscard]] EdgeChain tightened(const EdgeChain& cycle);
  void add_way_back(std::uint32_t vertex, EdgeChain& edges) const;
  [[nodiscard]] EdgeChain shortened(const EdgeChain& chain);
  [[nodiscard]] std::uint32_t shortcut(std::uint32_t edge) const;
  void root_forest();
  [[nodiscard]] bool is_in(std::uint32_t edge) const {
    return classes_.edges().enters(edge) <= classes_.index();
  }
  [[nodiscard]] double length_of(const EdgeChain& chain) const;
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t edge) const;

  const Filtration<3>& filtration_;
  const EdgesAtVertices& ways_;
  std::vector<double> lengths_;  // [edge]
  EdgeClasses classes_;
  std::uint32_t birth_ = 0;                          // whose tunnel is looked for
  std::vector<Reached> tree_;                        // [vertex]: in the last search to reach it
  std::uint32_t search_ = 0;                         // the number of the last one
  std::uint64_t left_ = 0;                           // so many vertices may still be reached
  std::vector<bool> is_in_chain_;                    // [edge]: while a chain is shortened
  std::vector<std::uint32_t> rank_;                  // [edge]: of its tunnel, 1 lives longest
  std::vector<std::uint32_t> towards_root_, depth_;  // [vertex]: in the forest of joining edges
};

}  // namespace orthoball
