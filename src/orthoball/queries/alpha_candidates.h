// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/filtration/filtration.h"
#include "orthoball/parallel.h"
#include "orthoball/points/weighted_points.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"

namespace orthoball {

/// An alpha that may be the one to take, with the shape there.
template <int D>
struct AlphaCandidate {
  NotableAlpha alpha;  ///< name, reason, index, alpha2
  Signature<D> at;     ///< of the shape at its index; where there is none, empty
  /// The indices from..to - 1 around it at which all Betti numbers are as they are there; `to` is
  /// never() where they stay so to the end.
  std::uint32_t stable_from = 0, stable_to = 0;
  /// By how much the largest ball grows meanwhile: a ratio of radii, 1 or more. 2 for a stretch
  /// without an end; 1 where the ball begins with radius 0, and where there is no index.
  double stability = 1.0;
};

/// The alphas that are worth a look, the most stable first, those without an index last, others in
/// this order:
///
/// - `signature`: in the middle of the most stable stretch that has an end, with all vertices in
/// and
///   no more components than half of them: the topology that lasts longest, all Betti numbers taken
///   together;
/// - the notable alphas of `notable_alphas`;
/// - `plateau_1` .. `plateau_3`: in the middle of the longest stretches on which the volume grows
///   by no more than 5 %, with an end and from 1 % to 95 % of the convex hull's where they begin;
///   only those in which the largest ball grows by 10 % or more;
/// - `spectrum_gap`: before the widest gap of the spectrum, with as few components and the volume
/// no
///   more than 95 % of the convex hull's: later there are slivers only;
/// - `manifold`: the first index at which every vertex is a corner of a cell, nothing is singular
///   and the boundary is a closed manifold as it is: manifold_solid has nothing to change;
/// - for molecules `dual_complex`, alpha2 = 0, and `probe`, the alpha of a water molecule, 1.4.
///
/// Lengths of stretches are ratios of the radii that the largest ball has, sqrt(alpha2 - alpha2_1),
/// so scales do not matter; its middle is the geometric one. Indices are exact but for what is
/// compared as rounded: volumes and these radii.
/// One scan of the signatures, and the cells around vertices up to the index of `manifold`.
template <int D>
[[nodiscard]] std::vector<AlphaCandidate<D>> alpha_candidates(const Filtration<D>& filtration,
                                                              WeightMeaning weights,
                                                              Threads threads = {});

/// The names that candidates can have in dimension D.
[[nodiscard]] std::vector<std::string> candidate_names(int dimension);

/// How candidates are found again in parts of the sites.
struct ResampleOptions {
  std::uint32_t count = 20;  ///< how many parts
  double share = 0.8;        ///< of the sites in each
  std::uint64_t seed = 1;
};

/// What became of a candidate in parts of the sites.
struct AlphaSpread {
  std::uint32_t found = 0;                     ///< in how many parts there is one of its name
  std::uint32_t same_betti = 0;                ///< in how many with the same Betti numbers
  double low = 0.0, median = 0.0, high = 0.0;  ///< the quartiles of its alpha; length. 0 for none
};

/// One for each candidate, in their order: the same candidates of subsamples of the points.
/// As many times the work of building the filtration as there are parts.
/// @param points  what the candidates' filtration was made of.
template <int D>
[[nodiscard]] std::vector<AlphaSpread> alpha_spreads(const WeightedPoints& points,
                                                     std::span<const AlphaCandidate<D>> candidates,
                                                     WeightMeaning weights,
                                                     const ResampleOptions& options,
                                                     Threads threads = {});

extern template std::vector<AlphaCandidate<2>> alpha_candidates<2>(const Filtration<2>&,
                                                                   WeightMeaning, Threads);
extern template std::vector<AlphaCandidate<3>> alpha_candidates<3>(const Filtration<3>&,
                                                                   WeightMeaning, Threads);
extern template std::vector<AlphaSpread> alpha_spreads<2>(const WeightedPoints&,
                                                          std::span<const AlphaCandidate<2>>,
                                                          WeightMeaning, const ResampleOptions&,
                                                          Threads);
extern template std::vector<AlphaSpread> alpha_spreads<3>(const WeightedPoints&,
                                                          std::span<const AlphaCandidate<3>>,
                                                          WeightMeaning, const ResampleOptions&,
                                                          Threads);

}  // namespace orthoball
