// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "orthoball/exact/certified_label.h"
#include "orthoball/exact/corner_block.h"
#include "orthoball/exact/sign.h"
#include "orthoball/exact/sites.h"

namespace orthoball {

/// Which facets of a simplex are attached by their opposite vertex: bit i is set where the site of
/// vertex i has less power than the squared orthoradius at the orthocentre of the facet opposite,
/// that is, where the orthocentre of the whole simplex lies strictly beyond that facet.
///
/// Exact: a tie (the orthocentre on the facet) is not attached. 2 to D + 1 corners.
template <int D, std::size_t Corners>
[[nodiscard]] unsigned attached_facets(const Sites<D>& sites, const CornerSites<Corners>& simplex);

/// The squared orthoradius of each simplex in input units squared, `labels[i]` of `simplices[i]`.
///
/// Correctly rounded (to nearest, ties to even), so independent of the order of corners, and never
/// in the wrong order: labels that differ are in the order of the exact values. Infinite where the
/// value is beyond the double range. 1 to D + 1 corners.
template <int D, std::size_t Corners>
void squared_orthoradii(const Sites<D>& sites, std::span<const CornerSites<Corners>> simplices,
                        std::span<double> labels);

/// How far the squared orthoradius of `simplex` is above its `label`, in a unit that all simplices
/// of `sites` share: of two with the same label, that with the smaller value is the one whose
/// bounds are below the other's. Certain; nothing follows where bounds touch. -infinity to infinity
/// where no bounds are known, as for vertices.
template <int D>
[[nodiscard]] Bounds label_remainder(const Sites<D>& sites, std::span<const std::uint32_t> simplex,
                                     double label);

/// Compares the squared orthoradii of many simplices with that of one, whose fraction is kept.
///
/// Exact: the values are compared as the rational numbers they are. Refers to the sites. Any
/// number of threads may use one.
template <int D>
class OrthoradiusPivot {
 public:
  /// @param pivot  1 to D + 1 corners.
  OrthoradiusPivot(const Sites<D>& sites, std::span<const std::uint32_t> pivot);
  ~OrthoradiusPivot();

  /// The sign of the squared orthoradius of `simplex` (1 to D + 1 corners) less that of the pivot.
  [[nodiscard]] Sign compare(std::span<const std::uint32_t> simplex) const;

 private:
  struct Fractions;

  const Sites<D>& sites_;
  std::unique_ptr<const Fractions> fractions_;
};

/// The stages of the functions above, for tests: not part of the public interface.
namespace orthoradius_stages {

/// Doubles with a forward error bound; nothing where that hides a sign.
template <int D, std::size_t Corners>
[[nodiscard]] std::optional<unsigned> filtered_attached_facets(const Sites<D>& sites,
                                                               const CornerSites<Corners>& simplex);
/// Integers as wide as the sites at hand need.
template <int D, std::size_t Corners>
[[nodiscard]] unsigned exact_attached_facets(const Sites<D>& sites,
                                             const CornerSites<Corners>& simplex);

/// Pairs of doubles with a forward error bound; nothing where that leaves two candidates.
template <int D, std::size_t Corners>
[[nodiscard]] std::optional<double> certified_label(const Sites<D>& sites,
                                                    const CornerSites<Corners>& simplex);
/// The exact fraction, rounded.
template <int D, std::size_t Corners>
[[nodiscard]] double exact_label(const Sites<D>& sites, const CornerSites<Corners>& simplex);

}  // namespace orthoradius_stages
}  // namespace orthoball
