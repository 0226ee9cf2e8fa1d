// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "orthoball/filtration/filtration.h"

namespace orthoball {

/// An index of the spectrum that stands out, with the reason in words.
struct NotableAlpha {
  std::string name;                    ///< one word, snake_case
  std::string reason;                  ///< half a sentence for people
  std::optional<std::uint32_t> index;  ///< none where there is no such index
  double alpha2 = 0.0;                 ///< its label; length^2. 0 where there is no index
  double alpha = 0.0;                  ///< signed root of alpha2; length
};

/// The notable alphas, always the same 6 + D names in this order:
///
/// - `all_vertices`: smallest index with every vertex in the complex.
/// - `all_vertices_in_cells`: smallest with every vertex in a D-cell of the complex.
/// - `connected`: smallest from which on, to the end, betti 0 is 1 and all vertices are in.
/// - `one_region`: smallest from which on the closed D-cells form one component (cells with a
///   common vertex are in one) that contains every vertex.
/// - `solid`: first with all vertices in, betti 0 = 1 and no singular simplex of any dimension.
/// - `solid_from`: first from which on that lasts to the end.
/// - `gap_0` .. `gap_(D-1)`: first index of the run of one constant betti k > 0 that is longest in
///   alpha, the unbounded last run left out; for k = 0 only indices with all vertices in count. The
///   earliest on ties.
///
/// Exact but for the lengths of runs, which are differences of rounded alphas. Nearly linear in the
/// simplices; no measures are taken.
template <int D>
[[nodiscard]] std::vector<NotableAlpha> notable_alphas(const Filtration<D>& filtration);

/// Where the weights of sites come from: what decides which alpha is taken unless the user names
/// one.
enum class WeightMeaning {
  none,            ///< all weights are 0
  given,           ///< a column of the input
  molecule_radii,  ///< squared radii of atoms: alpha2 = 0 is the molecule itself
};

/// The alpha that `--alpha2 auto` takes, with the reason: `dual_complex` (alpha2 = 0) where weights
/// are the radii of a molecule, `solid` where there are none, `connected` otherwise and where
/// nothing is solid; index 0 where there are no sites.
/// @param notable  all notable alphas of `filtration`.
template <int D>
[[nodiscard]] NotableAlpha automatic_alpha(const Filtration<D>& filtration,
                                           std::span<const NotableAlpha> notable,
                                           WeightMeaning weights);

}  // namespace orthoball
