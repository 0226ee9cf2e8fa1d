// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/topology/persistence.h"
#include "orthoball/topology/tunnel_reduction.h"

namespace orthoball {

/// The edges at the vertices of a triangulation, by number among edges.
class EdgesAtVertices {
 public:
  /// An edge, and the vertex at its other end.
  struct Way {
    std::uint32_t edge, to;
  };

  /// Linear.
  template <int D>
  explicit EdgesAtVertices(const Filtration<D>& filtration);

  /// [vertex], ascending by edge.
  [[nodiscard]] std::span<const Way> of(std::uint32_t vertex) const {
    return std::span(ways_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Way> ways_;
};

/// Short cycles around the tunnels of sites that span space.
///
/// A cycle of a tunnel is born and dies with it, exactly, over Z/2: in the complex of the index
/// that is asked for it is homologous to the chain of edges that reduction finds for the tunnel, up
/// to cycles that are born before and die before. It is short as far as this search goes: the
/// shortest of such loops that a tree of shortest paths and one more edge make, from both ends of
/// the edge of birth, then from some vertices of what was found until that is no shorter. Where
/// there is no such loop, the chain itself, shortened over single triangles and then ring by ring
/// in the same way.
///
/// Refers to what it is made from. Not for several threads at once.
/// @cite busaryev_2012_annotating  @cite erickson_whittlesey_2005
class TunnelCycles {
 public:
  /// @param all      all pairs of the filtration, WantedPairs::all.
  /// @param lengths  [edge], in any unit.
  TunnelCycles(const Filtration<3>& filtration, const PersistencePairs<3>& all,
               const EdgesAtVertices& ways, std::vector<double> lengths);

  /// Numbers of edges, ascending: the cycle of the tunnel that an edge closes, at an index at which
  /// it lives.
  [[nodiscard]] std::vector<std::uint32_t> cycle(std::uint32_t birth_edge, std::uint32_t index);

 private:
  using Edges = std::vector<std::uint32_t>;  // ascending; a chain or a class over Z/2
  struct Loop {
    double length;
    Edges edges;
  };
  struct Reached {
    double distance;
    std::uint32_t edge, from;
    bool is_settled;
    Edges of_class;
  };
  using Tree = std::unordered_map<std::uint32_t, Reached>;

  [[nodiscard]] bool lives(std::uint32_t edge) const;
  [[nodiscard]] const Edges& class_of(std::uint32_t edge);
  [[nodiscard]] const Edges& tunnel_of(std::uint32_t edge);
  [[nodiscard]] std::uint32_t last_of(const Edges& edges) const;
  [[nodiscard]] bool is_free(std::uint32_t edge) const;
  [[nodiscard]] bool is_free_class(Edges of_class);
  [[nodiscard]] Edges chain_of(std::uint32_t birth_edge);
  void look_from(std::uint32_t root, const Edges& wanted, Loop& best);
  void tighten(const Edges& wanted, Loop& best);
  [[nodiscard]] Edges tightened(const Edges& cycle);
  [[nodiscard]] Edges way_back(const Tree& tree, std::uint32_t vertex) const;
  void shorten(Edges& edges) const;
  [[nodiscard]] bool shorten_once(Edges& edges) const;
  void root_forest();
  [[nodiscard]] bool is_in(std::uint32_t edge) const { return edges_.enters(edge) <= index_; }
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t edge) const;

  const Filtration<3>& filtration_;
  const EdgesAtVertices& ways_;
  std::vector<double> lengths_;  // [edge]
  KeyedSimplices edges_, triangles_;
  std::vector<bool> joins_, cuts_;  // [edge] two components; [triangle] off a void
  TunnelReduction reduction_;
  std::uint32_t index_ = 0, birth_ = 0;  // what is looked for
  // Of edges at that index, the part of the basis that they stand for, and their tunnels' classes.
  std::unordered_map<std::uint32_t, Edges> classes_, tunnels_;
  std::vector<std::uint32_t> towards_root_, depth_;  // [vertex]: in the forest of joining edges
};

}  // namespace orthoball
