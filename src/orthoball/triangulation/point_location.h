// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "orthoball/exact/orient.h"
#include "orthoball/exact/orients_around.h"
#include "orthoball/exact/processor.h"
#include "orthoball/triangulation/cell_store.h"
#include "orthoball/triangulation/territory.h"

namespace orthoball {

/// Finds the cell that contains a site, by a walk: cross any facet that has the site strictly
/// beyond it.
///
/// In a regular triangulation such a walk cannot return to a cell, so it ends: in a finite cell
/// that contains the site (boundary included), or at infinity behind a hull facet that has the site
/// strictly beyond it.  @cite devillers_pion_teillaud_2002
template <int A, int D>
class PointLocation {
 public:
  /// Keeps references.
  PointLocation(const CellStore<A>& cells, const Sites<D>& sites) : cells_(cells), sites_(sites) {}

  /// The cell that contains `site`; the cell before the first outside the territory, with
  /// `is_found` false, if the walk leaves it.
  struct Place {
    std::uint32_t cell;
    bool is_found;
  };
  /// @param start  a finite cell or a cell at infinity in the territory.
  [[nodiscard]] Place locate(std::uint32_t site, std::uint32_t start,
                             const Territory<A, D>& territory) const {
    if constexpr (A == 2 && D == 2) {
      return walk(site, start, territory, [&](const Corners<2>& corners, std::uint32_t of) {
        return first_of(glanced_orients_around(sites_, corners, of), corners, of);
      });
    } else {
      return is_wide_ ? walk_wide(site, start, territory) : walk_plain(site, start, territory);
    }
  }

 private:
  // A facet of a finite cell that has the site strictly beyond it, A + 1 if there is none.
  [[nodiscard, gnu::noinline]] unsigned facet_before(const Corners<A>& corners,
                                                     std::uint32_t site) const {
    for (unsigned i = 0; i <= A; ++i) {
      Corners<A> facet_and_site = corners;
      facet_and_site[i] = site;
      if (orient<A, D>(sites_, facet_and_site) == Sign::negative) return i;
    }
    return A + 1;
  }

  // The same from what a glance has told.
  [[nodiscard, gnu::always_inline]] unsigned first_of(const GlancedOrients& orients,
                                                      const Corners<A>& corners,
                                                      std::uint32_t site) const {
    if (orients.negative != 0) return static_cast<unsigned>(std::countr_zero(orients.negative));
    return orients.open == 0 ? unsigned{A + 1} : facet_before(corners, site);
  }

  template <class FacetBefore>
  [[nodiscard, gnu::always_inline]] Place walk(std::uint32_t site, std::uint32_t start,
                                               const Territory<A, D>& territory,
                                               const FacetBefore& facet_before_site) const {
    const bool is_whole = territory.is_whole();
    std::uint32_t cell = start;
    // The cell at hand is in the territory, so of the next one only the corner off their facet is
    // asked about.
    const auto leaves = [&](std::uint32_t facet) {
      return !is_whole && !territory.has(cells_[facet / 4].corners[facet % 4]);
    };
    if (const std::size_t infinite = cells_.corner_at_infinity(cells_[cell]); infinite <= A) {
      const std::uint32_t inside = cells_[cell].neighbours[infinite];
      if (leaves(inside)) return {cell, false};
      cell = inside / 4;
    }
    for (;;) {
      const CellRecord<A>& record = cells_[cell];
      const unsigned facet = facet_before_site(record.corners, site);
      if (facet > A) return {cell, true};
      const std::uint32_t beyond = record.neighbours[facet];
      if (leaves(beyond)) return {cell, false};
      cell = beyond / 4;
      if (!cells_.is_finite(cells_[cell])) return {cell, true};
    }
  }

  [[nodiscard]] Place walk_plain(std::uint32_t site, std::uint32_t start,
                                 const Territory<A, D>& territory) const {
    return walk(site, start, territory, [&](const Corners<A>& corners, std::uint32_t of) {
      return facet_before(corners, of);
    });
  }

#ifdef ORTHOBALL_WIDE_CODE
  [[nodiscard]] ORTHOBALL_AVX2 Place walk_wide(std::uint32_t site, std::uint32_t start,
                                               const Territory<A, D>& territory) const {
    if constexpr (A == 3) {
      return walk(site, start, territory,
                  [&](const Corners<A>& corners, std::uint32_t of) ORTHOBALL_AVX2 {
                    return first_of(glanced_orients_around(sites_, corners, of), corners, of);
                  });
    } else {
      return walk_plain(site, start, territory);
    }
  }
#else
  [[nodiscard]] Place walk_wide(std::uint32_t site, std::uint32_t start,
                                const Territory<A, D>& territory) const {
    return walk_plain(site, start, territory);
  }
#endif

  const CellStore<A>& cells_;
  const Sites<D>& sites_;
  const bool is_wide_ = has_avx2();
};

}  // namespace orthoball
