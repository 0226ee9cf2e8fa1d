// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/filtration/interval_tree.h"
#include "orthoball/parallel.h"
#include "orthoball/topology/betti.h"

namespace orthoball {

/// The union of balls of squared radius weight + alpha2 as a whole, in input units. In the plane
/// `volume` is its area and `area` its perimeter.
template <int D>
struct BallSignature {
  std::uint32_t index = 0;  ///< of the dual complex
  double alpha2 = 0.0;      ///< length^2
  BettiNumbers<D> betti{};  ///< components, tunnels[, voids]
  std::int64_t euler = 0;
  double volume = 0.0;  ///< length^D
  double area = 0.0;    ///< length^(D-1)
};

/// At which alpha a union is asked for.
struct BallAlpha {
  std::uint32_t index = 0;  ///< 0..s
  double alpha2 = 0.0;      ///< length^2, between the labels of the index and the next one
};

/// Volume and area of the unions of all balls of a filtration, to be asked for at any alpha2: the
/// volume of the complex's cells, which is known, and the pieces of the union around the simplices
/// on its boundary.
///
/// Refers to the filtration. Immutable; any number of threads may read it. Up to 30 bytes a vertex
/// and an edge: interval trees of the indices at which they matter.
template <int D>
class BallBoundaries {
 public:
  explicit BallBoundaries(const Filtration<D>& filtration);

  /// Of the balls alone, without the cells of the complex.
  struct Measures {
    double volume = 0.0;  ///< length^D
    double area = 0.0;    ///< length^(D-1)
  };
  /// Time grows with the edges at the boundary's vertices, but for passes over the vertices and
  /// over the indices of all simplices.
  /// @throws InputError as ScaledBalls does.
  [[nodiscard]] Measures measures(const BallAlpha& alpha, Threads threads) const;

 private:
  const Filtration<D>* filtration_;
  IntervalTree vertices_;  // from enters to interior
  IntervalTree edges_;     // from enters until both ends are interior
};

/// The unions at the given alphas, in their order. One scan of the filtration for all, then the
/// boundary of each; volumes and areas as those of union_of_balls, but for roundings.
/// @throws InputError for an index beyond the spectrum's size.
template <int D>
[[nodiscard]] std::vector<BallSignature<D>> ball_signatures(const Filtration<D>& filtration,
                                                            std::span<const BallAlpha> alphas,
                                                            Threads threads = {});

extern template class BallBoundaries<2>;  // defined in ball_signature.cpp
extern template class BallBoundaries<3>;

}  // namespace orthoball
