// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/ids.h"
#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/edges_at_vertices.h"
#include "orthoball/queries/tunnel_cycles.h"
#include "orthoball/topology/persistence.h"

namespace orthoball {

/// What makes a class of persistent homology, in the complex of one index of its life. In input
/// units.
struct Representative {
  int dimension = 0;
  PersistencePair pair;
  std::uint32_t index = 0;
  /// Ascending: of a component all its vertices, else the vertices of the cycle.
  std::vector<SiteId> rows;
  /// Simplices of this dimension, ascending: the vertex that a component began with, or a cycle
  /// that belongs to the class, edges of a tunnel, of a void all facets that enclose it.
  std::vector<SimplexId> cycle;
  /// Of a cycle of edges: the rings that it consists of, each closed from its last row to its
  /// first. Two may have a vertex in common, none has one twice.
  std::vector<std::vector<SiteId>> rings;
  std::vector<SimplexId> cells;  ///< of a void (in the plane: hole), ascending: what is in it
  double size = 0.0;             ///< of the cycle: length or area; 0 of a component
  double volume = 0.0;           ///< of the cells; length^A for cells of dimension A
};

/// Finds what makes the classes of a filtration.
///
/// Voids (holes, where the sites span a plane): the component of the complement that the class's
/// last cell is in; all of it is exact. Tunnels: a short cycle of the class, see TunnelCycles. All
/// cycles are cycles, and from birth to death they bound nothing.
///
/// Takes in space about 40 bytes a simplex, with all pairs and those that last; a third of it
/// before the first tunnel. Refers to the filtration. Not for several threads at once.
template <int D>
class Representatives {
 public:
  /// @param all  all pairs of the filtration, WantedPairs::all.
  Representatives(const Filtration<D>& filtration, const PersistencePairs<D>& all);

  /// The index at which a class is shown unless another is asked for. Of a component the last of
  /// its life, at which it has most vertices; of a void that of its birth, at which it is largest;
  /// of a tunnel that half way in alpha2, for at its birth there may be but one long way around.
  [[nodiscard]] std::uint32_t usual_index(int dimension, const PersistencePair& pair) const;

  /// @param dimension, pair  one of the pairs, that lives at `index`.
  /// @throws InputError where it does not.
  [[nodiscard]] Representative at(int dimension, const PersistencePair& pair, std::uint32_t index);

 private:
  using Place = std::array<double, 3>;

  [[nodiscard]] std::vector<Place> places(SimplexId simplex) const;
  void add_component(Representative& result) const;
  template <int A>
  void add_void(Representative& result) const;
  void add_tunnel(Representative& result);
  void measure(Representative& result) const;

  const Filtration<D>& filtration_;
  const PersistencePairs<D>& all_;
  ScaledBalls<D> balls_;
  EdgesAtVertices ways_;
  std::optional<TunnelCycles> tunnels_;  // made when the first is asked for
};

extern template class Representatives<2>;  // defined in representatives.cpp
extern template class Representatives<3>;

}  // namespace orthoball
