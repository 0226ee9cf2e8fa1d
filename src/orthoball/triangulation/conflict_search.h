// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "orthoball/exact/power_sides_across.h"
#include "orthoball/exact/processor.h"
#include "orthoball/exact/unrolled.h"
#include "orthoball/triangulation/cell_store.h"
#include "orthoball/triangulation/conflict_test.h"
#include "orthoball/triangulation/territory.h"

namespace orthoball {

/// Four words of a record at once.
using Words = std::uint32_t __attribute__((vector_size(16)));

/// A facet of the boundary of a conflict region. (site, vertices...) is positively oriented, but on
/// a line, where that is for whoever makes cells to see to. With the site in the place of `outside`
/// its words are the corners of the new cell.
template <int A>
struct alignas(A == 3 ? 16 : 4) BoundaryFacet {
  std::uint32_t outside;                               ///< 4 * cell + corner of the cell that stays
  std::array<std::uint32_t, std::size_t{A}> vertices;  ///< by number
};
static_assert(sizeof(BoundaryFacet<3>) == sizeof(Words));

/// Finds the cells that a site invalidates: a ball of cells around the site, for perturbation
/// leaves no ties.
///
/// The search goes over the neighbours of dead cells, breadth first: the list of dead cells is the
/// queue. There is no branch on whether a cell is in conflict, which would be mispredicted every
/// other time: all neighbours of a dead cell are tested at once, and each is written to the list of
/// dead cells and to the boundary and counted in one of them, or in none if it was dead before.
template <int A, int D>
class ConflictSearch {
 public:
  /// Keeps references.
  ConflictSearch(CellStore<A>& cells, const Sites<D>& sites) : cells_(cells), sites_(sites) {}

  /// Kills the cells in conflict with `site`, found from `start`, which is one of them; false, and
  /// nothing is changed, if one of them is not in the territory.
  bool find(std::uint32_t site, std::uint32_t start, const Territory<A, D>& territory) {
    cells_.kill(start);
    dead_[0] = start;
    dead_count_ = 1;
    facet_count_ = 0;
    const bool is_found =
        is_wide_ ? spread_wide(site, territory) : spread(site, territory, PlainGlance{*this});
    if (!is_found) revive();
    return is_found;
  }
  /// Gives the dead cells back their lives.
  void revive() {
    for (const std::uint32_t cell : dead()) cells_.revive(cell);
  }

  /// The dead cells.
  [[nodiscard]] std::span<const std::uint32_t> dead() const { return {dead_.data(), dead_count_}; }
  /// The facets between dead cells and those that stay.
  [[nodiscard]] std::span<const BoundaryFacet<A>> boundary() const {
    return {boundary_.data(), facet_count_};
  }

 private:
  using Cell = CellRecord<A>;
  static constexpr std::size_t kRoom = 256;  // at first

  // Which neighbours of a cell die and which stay, a bit for each.
  struct Fates {
    std::uint32_t dying, staying;
  };
  // What lies beyond the facets of a cell.
  struct View {
    Corners<A> apexes;
    std::uint32_t alive;
  };

  // The answers that a glance has left open or found to be ties.
  [[nodiscard, gnu::noinline]] Fates settled(const Cell& record, std::uint32_t site, Fates fates,
                                             std::uint32_t open, std::uint32_t ties) const {
    for (std::uint32_t rest = open | ties; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(rest));
      const std::uint32_t beyond = record.neighbours[i] / 4;
      const bool is_tie = (ties >> i & 1U) != 0;
      const bool dies = is_tie ? perturbed_conflict<A, D>(sites_, cells_[beyond].corners, site)
                               : in_conflict<A, D>(cells_, sites_, beyond, site);
      (dies ? fates.dying : fates.staying) |= 1U << i;
    }
    return fates;
  }

  // Without vectors everything is open.
  struct PlainGlance {
    const ConflictSearch& search;
    Fates operator()(const Cell& record, const View& view, std::uint32_t site) const {
      return search.settled(record, site, {0, 0}, view.alive, 0);
    }
  };

#ifdef ORTHOBALL_WIDE_CODE
  struct WideGlance {
    const ConflictSearch& search;
    const PowerSidesAcross<D> sides_across;
    ORTHOBALL_AVX2 Fates operator()(const Cell& record, const View& view,
                                    std::uint32_t site) const {
      const GlancedSides sides = sides_across(record.corners, view.apexes);
      const Fates fates{sides.positive & view.alive, sides.negative & view.alive};
      const std::uint32_t open = sides.open & view.alive, ties = sides.zero & view.alive;
      if ((open | ties) == 0) [[likely]] {
        return fates;
      }
      return search.settled(record, site, fates, open, ties);
    }
  };
  [[gnu::flatten]] ORTHOBALL_AVX2 bool spread_wide(std::uint32_t site,
                                                   const Territory<A, D>& territory) {
    if constexpr (A == D) {
      return spread(site, territory, WideGlance{*this, {sites_, site}});
    } else {
      return spread(site, territory, PlainGlance{*this});
    }
  }
#else
  bool spread_wide(std::uint32_t site, const Territory<A, D>& territory) {
    return spread(site, territory, PlainGlance{*this});
  }
#endif

  // From every dead cell over its facets; false if a cell in conflict is not in the territory. What
  // the loop needs is at hand in local variables, which no store to a record can change.
  template <class Glance>
  [[gnu::always_inline]] bool spread(std::uint32_t site, const Territory<A, D>& territory,
                                     const Glance& glance) {
    const bool is_whole = territory.is_whole();
    Cell* const cells = &cells_[0];
    std::uint32_t* dead = dead_.data();
    BoundaryFacet<A>* boundary = boundary_.data();
    std::size_t dead_count = dead_count_;
    std::size_t facet_count = facet_count_;
    std::size_t room = room_left();
    for (std::size_t next = 0; next < dead_count; ++next) {
      if (std::max(dead_count, facet_count) > room) [[unlikely]] {
        make_room();
        dead = dead_.data();
        boundary = boundary_.data();
        room = room_left();
      }
      const Cell record = without_mark(cells[dead[next]]);
      const View view = view_from(cells, record);
      const Fates fates = glance(record, view, site);
      const std::uint32_t dying = fates.dying, staying = fates.staying;
      if (!is_whole && leaves(territory, view, dying)) [[unlikely]] {
        dead_count_ = dead_count;
        return false;
      }
      unrolled<std::size_t{A + 1}>([&](std::size_t i) __attribute__((always_inline)) {
        const std::uint32_t dies = dying >> i & 1U;
        cells[record.neighbours[i] / 4].neighbours[0] |= dies * CellStore<A>::kDead;
        dead[dead_count] = record.neighbours[i] / 4;
        dead_count += dies;
        boundary[facet_count] = facet_of(record, i);
        facet_count += staying >> i & 1U;
      });
    }
    dead_count_ = dead_count;
    facet_count_ = facet_count;
    return true;
  }

  // Its neighbours word by word: a load of several would wait until the mark, which may have been
  // stored just now, has left the processor's queue. The empty asm keeps GCC from joining them.
  [[gnu::always_inline]] static Cell without_mark(const Cell& cell) {
    Cell record;
    record.corners = cell.corners;
    unrolled<std::size_t{A + 1}>([&](std::size_t i) __attribute__((always_inline)) {
      std::uint32_t word = cell.neighbours[i];
      if constexpr (A == 3) asm("" : "+r"(word));
      record.neighbours[i] = word;
    });
    record.neighbours[0] &= ~CellStore<A>::kDead;
    return record;
  }

  [[gnu::always_inline]] static View view_from(const Cell* cells, const Cell& record) {
    View view{{}, 0};
    unrolled<std::size_t{A + 1}>([&](std::size_t i) __attribute__((always_inline)) {
      const Cell& beyond = cells[record.neighbours[i] / 4];
      view.apexes[i] = beyond.corners[record.neighbours[i] % 4];
      view.alive |= std::uint32_t{!CellStore<A>::is_dead(beyond)} << i;
    });
    return view;
  }

  // Whether a neighbour that dies is not in the territory. Only its apex is asked about: the facet
  // is that of a cell in the territory.
  [[gnu::always_inline]] static bool leaves(const Territory<A, D>& territory, const View& view,
                                            std::uint32_t dying) {
    std::uint32_t not_at_once = 0;
    unrolled<std::size_t{A + 1}>([&](std::size_t i) __attribute__((always_inline)) {
      not_at_once |= std::uint32_t{!territory.has_at_once(view.apexes[i])} << i;
    });
    // Of a copy, for what a call can see would not stay in registers.
    return (not_at_once & dying) != 0 &&
           !has_all(territory, Corners<A>(view.apexes), not_at_once & dying);
  }
  [[gnu::noinline]] static bool has_all(const Territory<A, D>& territory, const Corners<A>& apexes,
                                        std::uint32_t bits) {
    bool all = true;
    for (std::uint32_t i = 0; i <= A; ++i) {
      all &= (bits >> i & 1U) == 0 || territory.has(apexes[i]);
    }
    return all;
  }

  // The facet opposite corner i. (i, its corners...) is an even permutation of the corners, for A =
  // 1 an odd one.
  [[gnu::always_inline]] static BoundaryFacet<A> facet_of(const Cell& record, std::size_t i) {
    BoundaryFacet<A> facet;
    if constexpr (A == 3) {
      // As one vector, which GCC would put together word by word.
      Words words;
      std::memcpy(&words, &record.corners, sizeof words);
      words = i == 0   ? words
              : i == 1 ? __builtin_shufflevector(words, words, 1, 0, 3, 2)
              : i == 2 ? __builtin_shufflevector(words, words, 2, 0, 1, 3)
                       : __builtin_shufflevector(words, words, 3, 0, 2, 1);
      words[0] = record.neighbours[i];
      std::memcpy(&facet, &words, sizeof words);
    } else {
      facet.outside = record.neighbours[i];
      for (std::size_t k = 0; k < A; ++k) {
        facet.vertices[k] = record.corners[(i + 1 + k) % (A + 1)];
      }
    }
    return facet;
  }

  // Up to how many dead cells and facets one more cell can be looked at.
  [[nodiscard]] std::size_t room_left() const { return dead_.size() - (A + 1); }
  [[gnu::noinline]] void make_room() {
    dead_.resize(2 * dead_.size());
    boundary_.resize(2 * boundary_.size());
  }

  CellStore<A>& cells_;
  const Sites<D>& sites_;
  const bool is_wide_ = has_avx2();
  std::size_t dead_count_ = 0;
  std::size_t facet_count_ = 0;
  std::vector<std::uint32_t> dead_ = std::vector<std::uint32_t>(kRoom);
  std::vector<BoundaryFacet<A>> boundary_ = std::vector<BoundaryFacet<A>>(kRoom);
};

}  // namespace orthoball
