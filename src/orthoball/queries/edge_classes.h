// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/queries/edge_chain.h"
#include "orthoball/topology/persistence.h"
#include "orthoball/topology/tunnel_reduction.h"

namespace orthoball {

/// Of what homology class the cycles of edges are, of sites that span space, in the complex of an
/// index.
///
/// The loops that are closed by edges whose tunnels live there are a basis of the homology, and a
/// class is a chain of such edges. Every edge has a part in it, and the sum of the parts of the
/// edges of a cycle is its class, exactly, over Z/2.
///
/// What was found is used again at other indices where it holds, and at later ones what follows
/// from it. 40 bytes an edge and TunnelReduction. Refers to the filtration. Not for several threads
/// at once.
/// @cite busaryev_2012_annotating
class EdgeClasses {
 public:
  /// @param all  all pairs of the filtration, WantedPairs::all.
  EdgeClasses(const Filtration<3>& filtration, const PersistencePairs<3>& all);

  [[nodiscard]] const KeyedSimplices& edges() const { return edges_; }
  [[nodiscard]] const KeyedSimplices& triangles() const { return triangles_; }
  [[nodiscard]] const TunnelReduction& reduction() const { return reduction_; }
  /// Whether an edge joins two components.
  [[nodiscard]] bool joins(std::uint32_t edge) const { return joins_[edge]; }

  /// The index of which the rest speaks.
  void go_to(std::uint32_t index) { index_ = index; }
  [[nodiscard]] std::uint32_t index() const { return index_; }
  /// The part of an edge of the complex. Until the index changes.
  [[nodiscard]] const EdgeChain& part_of(std::uint32_t edge);
  /// The class of the chain of an edge whose tunnel lives; the edge is its last. As long.
  [[nodiscard]] const EdgeChain& tunnel_of(std::uint32_t edge);
  /// The last edge in filter order; of a chain that is not empty.
  [[nodiscard]] std::uint32_t last_of(const EdgeChain& chain) const;

  /// Whether the tunnel of an edge is born before that of another and dies before it.
  [[nodiscard]] bool is_free(std::uint32_t edge, std::uint32_t other) const;
  /// Whether a class is a sum of tunnels of which that is true.
  [[nodiscard]] bool is_free_class(EdgeChain of_class, std::uint32_t other);

 private:
  struct Known {
    std::uint32_t from = std::numeric_limits<std::uint32_t>::max(), until = 0;  // indices: [ )
    EdgeChain chain;
  };

  [[nodiscard]] bool lives(std::uint32_t edge) const;
  [[nodiscard]] std::uint32_t death(std::uint32_t edge) const;
  [[nodiscard]] bool holds(const Known& known) const {
    return known.from <= index_ && index_ < known.until;
  }
  [[nodiscard]] bool held(std::uint32_t edge) const;
  template <class Visit>
  void for_each_source(std::uint32_t edge, const Visit& visit) const;
  void find_part(std::uint32_t edge);

  KeyedSimplices edges_, triangles_;
  std::vector<bool> joins_, cuts_;  // [edge] two components; [triangle] off a void
  TunnelReduction reduction_;
  std::uint32_t index_ = 0;
  std::vector<Known> parts_;                          // [edge]
  std::unordered_map<std::uint32_t, Known> tunnels_;  // by edge
};

}  // namespace orthoball
