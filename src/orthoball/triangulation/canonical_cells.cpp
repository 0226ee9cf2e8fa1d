// SPDX-License-Identifier: MIT
//
// Everything happens in the memory that the cells have. First they are grouped by their smallest
// corner: a counting sort gives each cell its place, neighbours are rewritten to these, and records
// are moved along the cycles of that permutation, several at a time, for each step waits for
// memory. The smallest corner follows from the place, so meanwhile a record carries its place
// instead: nothing but records is touched. Then the cells of each group, few and side by side, are
// put in order with their corners, and neighbours are rewritten once more: all they refer to is
// near by then.
#include "orthoball/triangulation/canonical_cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "orthoball/raw_vector.h"

namespace orthoball {
namespace {

/// Which corner of the new record each old corner has become, 2 bits each.
using CornerMap = std::uint8_t;

std::uint32_t mapped(CornerMap map, std::uint32_t old_corner) {
  return std::uint32_t{map} >> (2 * old_corner) & 3U;
}

// The ranks of A + 1 corners by their size, 2 bits each: no branches, for the order of four is as
// good as random.
template <int A>
CornerMap ranks_of(const std::array<std::uint32_t, std::size_t{A + 1}>& corners) {
  if constexpr (A == 3) {
    using Four = std::int32_t __attribute__((vector_size(16)));  // vertices are below 2^31
    // Not as they lie in memory: a load of all would wait for the stores of each.
    const auto signed_corner = [&](std::size_t i) { return static_cast<std::int32_t>(corners[i]); };
    const Four all = {signed_corner(0), signed_corner(1), signed_corner(2), signed_corner(3)};
    const Four ranks = (all > __builtin_shufflevector(all, all, 1, 2, 3, 0)) +
                       (all > __builtin_shufflevector(all, all, 2, 3, 0, 1)) +
                       (all > __builtin_shufflevector(all, all, 3, 0, 1, 2));  // negative
    return static_cast<CornerMap>(-(ranks[0] + 4 * ranks[1] + 16 * ranks[2] + 64 * ranks[3]));
  } else {
    std::uint32_t ranks = 0;
    for (std::uint32_t i = 0; i <= A; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) ranks += 1U << (2 * (corners[i] > corners[j] ? i : j));
    }
    return static_cast<CornerMap>(ranks);
  }
}

// [ranks]: the map that sorts corners of these ranks, the last two exchanged after an odd
// permutation.
template <int A>
constexpr std::array<CornerMap, 256> kOrientedMaps = [] {
  std::array<CornerMap, 256> maps{};
  for (std::uint32_t ranks = 0; ranks < 256; ++ranks) {
    std::uint32_t inversions = 0;
    for (std::uint32_t i = 0; i <= A; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        inversions += (ranks >> (2 * j) & 3U) > (ranks >> (2 * i) & 3U) ? 1U : 0U;
      }
    }
    std::uint32_t map = 0;
    for (std::uint32_t i = 0; i <= A; ++i) {
      std::uint32_t rank = ranks >> (2 * i) & 3U;
      if (inversions % 2 == 1 && rank + 1 >= A && rank <= A) rank = 2 * A - 1 - rank;
      map |= rank << (2 * i);
    }
    maps[ranks] = static_cast<CornerMap>(map);
  }
  return maps;
}();

// Puts the corners in ascending order into `sorted`, the last two exchanged after an odd
// permutation where orientation matters.
template <int A>
CornerMap sort_corners(const std::array<std::uint32_t, std::size_t{A + 1}>& corners,
                       bool is_oriented, std::array<std::uint32_t, std::size_t{A + 1}>& sorted) {
  const CornerMap ranks = ranks_of<A>(corners);
  const CornerMap map = is_oriented ? kOrientedMaps<A>[ranks] : ranks;
  for (std::uint32_t i = 0; i <= A; ++i) sorted[mapped(map, i)] = corners[i];
  return map;
}

/// The other corners of a cell, ascending, as one number, by which cells that share their first
/// corner are told apart: by their distance from it, which nearly always fits.
template <int A>
struct CellAtSite {
  static constexpr unsigned kBits = A == 3 ? 21 : 32;  // a corner

  std::uint64_t key = 0;
  bool fits;

  explicit CellAtSite(const std::array<std::uint32_t, std::size_t{A + 1}>& corners) {
    auto ascending = corners;
    std::tie(ascending[A - 1], ascending[A]) = std::minmax({corners[A - 1], corners[A]});
    for (std::size_t i = 1; i <= A; ++i) key = key << kBits | (ascending[i] - corners[0]);
    fits = ascending[A] - corners[0] < std::uint64_t{1} << kBits;
  }
};

/// Ranks the cells that share their first corner by the others.
template <int A>
class CellRanking {
 public:
  /// Puts into ranks()[i] how many of the cells come before cells[i].
  void rank(std::span<const CellRecord<A>> cells) {
    keys_.clear();
    bool fit = true;
    for (const CellRecord<A>& cell : cells) {
      const CellAtSite<A> at_site(cell.corners);
      keys_.push_back(at_site.key);
      fit &= at_site.fits;
    }
    ranks_.assign(cells.size(), 0);
    if (!fit || cells.size() > kFew) return sort(cells);
    for (std::uint32_t i = 0; i < keys_.size(); ++i) {
      std::uint32_t before = i;
      for (std::uint32_t j = 0; j < i; ++j) {
        const std::uint32_t precedes = keys_[i] < keys_[j] ? 1 : 0;
        ranks_[j] += precedes;
        before -= precedes;
      }
      ranks_[i] = before;
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> ranks() const { return ranks_; }

 private:
  static constexpr std::size_t kFew = 32;

  void sort(std::span<const CellRecord<A>> cells) {
    std::vector<std::uint32_t> order(cells.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const auto ascending = [&](std::uint32_t i) {
      auto corners = cells[i].corners;
      std::tie(corners[A - 1], corners[A]) = std::minmax({corners[A - 1], corners[A]});
      return corners;
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return ascending(i) < ascending(j); });
    for (std::uint32_t i = 0; i < order.size(); ++i) ranks_[order[i]] = i;
  }

  std::vector<std::uint64_t> keys_;   // [cell]
  std::vector<std::uint32_t> ranks_;  // [cell]
};

/// Where the cells of each vertex go, with its cells told apart by the smallest corner.
template <int A>
class CanonicalOrder {
 public:
  CanonicalOrder(CellStore<A> cells, std::size_t vertices, bool is_oriented, Threads threads)
      : cells_(cells.take()),
        infinity_(cells.infinity()),
        is_oriented_(is_oriented),
        threads_(threads.for_work(cells_.size(), 1U << 15U)),
        begins_(vertices + 1, 0),
        place_(cells_.size()) {}

  CellArray<A> cells() {
    find_places();
    redirect();
    move(0, static_cast<std::uint32_t>(cells_.size()), threads_);
    cells_.resize(begins_.back());
    maps_.resize(cells_.size());
    parallel_parts(threads_, vertices(), parts(),
                   [&](std::size_t, std::size_t begin, std::size_t end) { rank(begin, end); });
    parallel_parts(threads_, vertices(), parts(),
                   [&](std::size_t, std::size_t begin, std::size_t end) { settle(begin, end); });
    return std::move(cells_);
  }

 private:
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;  // the place of a cell that is not kept

  [[nodiscard]] std::size_t vertices() const { return begins_.size() - 1; }
  [[nodiscard]] std::size_t parts() const { return threads_.count(); }

  // Whether a cell is neither dead nor at infinity, and its smallest corner.
  [[nodiscard]] std::pair<bool, std::uint32_t> kept(const CellRecord<A>& cell) const {
    const auto [least, largest] = std::minmax_element(cell.corners.begin(), cell.corners.end());
    return {!CellStore<A>::is_dead(cell) && *largest < infinity_, *least};
  }

  // Fills begins_ and place_. Each part of the cells counts by itself, and then knows where its own
  // begin.
  void find_places() {
    // [part][vertex]: how many cells, then where the next goes.
    std::vector<std::vector<std::uint32_t>> next(parts());
    parallel_parts(threads_, cells_.size(), parts(),
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     next[part].resize(vertices());
                     for (std::size_t cell = begin; cell < end; ++cell) {
                       const auto [is_kept, vertex] = kept(cells_[cell]);
                       place_[cell] = is_kept ? vertex : kNowhere;
                       if (is_kept) ++next[part][vertex];
                     }
                   });
    std::uint32_t sum = 0;
    for (std::size_t vertex = 0; vertex < vertices(); ++vertex) {
      begins_[vertex] = sum;
      for (auto& of_part : next) sum += std::exchange(of_part[vertex], sum);
    }
    begins_.back() = sum;
    parallel_parts(threads_, cells_.size(), parts(),
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     for (std::size_t cell = begin; cell < end; ++cell) {
                       std::uint32_t& place = place_[cell];  // as yet the smallest corner
                       if (place != kNowhere) place = next[part][place]++;
                     }
                   });
  }

  // Neighbours become places; kOutside where they are not kept. What is not kept becomes a gap.
  void redirect() {
    parallel_parts(threads_, cells_.size(), parts(),
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t cell = begin; cell < end; ++cell) {
                       carry(cells_[cell].corners, place_[cell]);
                       if (place_[cell] == kNowhere) continue;
                       for (std::uint32_t& facet : cells_[cell].neighbours) {
                         const std::uint32_t place = place_[facet / 4];
                         facet = place == kNowhere ? kOutside : 4 * place + facet % 4;
                       }
                     }
                   });
  }

  // While it is on its way a record has its place, and where its smallest corner was, instead of
  // the first corner, which is where the smallest was.
  using Corners = std::array<std::uint32_t, std::size_t{A + 1}>;
  static constexpr unsigned kPlaceBits = 29;
  static void carry(Corners& corners, std::uint32_t place) {
    const auto smallest = static_cast<std::uint32_t>(
        std::min_element(corners.begin(), corners.end()) - corners.begin());
    corners[smallest] = corners[0];
    corners[0] = place == kNowhere ? kNowhere : smallest << kPlaceBits | place;
  }
  static std::uint32_t carried_place(const CellRecord<A>& cell) {
    const std::uint32_t first = cell.corners[0];
    return first == kNowhere ? kNowhere : first & ((1U << kPlaceBits) - 1);
  }
  [[gnu::always_inline]] static Corners put_back(const Corners& carried, std::uint32_t smallest) {
    const std::uint32_t at = carried[0] >> kPlaceBits;
    const std::uint32_t first = carried[at];
    Corners corners;
    for (std::uint32_t i = 0; i <= A; ++i) {
      corners[i] = i == at ? smallest : i == 0 ? first : carried[i];
    }
    return corners;
  }

  // Moves the cells of slots begin..end - 1, which are those of these places, to their places; each
  // half by itself once the halves have exchanged what does not belong to them. That is little, for
  // most cells are near their places.
  void move(std::uint32_t begin, std::uint32_t end, Threads threads) {
    if (threads.count() == 1) return move_alone(begin, end);
    const unsigned below = threads.count() / 2;
    const auto middle =
        static_cast<std::uint32_t>(begin + std::uint64_t{end - begin} * below / threads.count());
    std::uint32_t low = begin, high = middle;
    while (true) {
      while (high < end && carried_place(cells_[high]) >= middle) ++high;  // or nowhere
      if (high == end) break;
      while (carried_place(cells_[low]) < middle) ++low;
      std::swap(cells_[low++], cells_[high++]);
    }
    parallel_for(Threads(2), 2, [&](std::size_t half) {
      if (half == 0) return move(begin, middle, Threads(below));
      move(middle, end, Threads(threads.count() - below));
    });
  }

  // A cell in hand is put down where it belongs and what was there taken up, until that is a gap.
  // Several hands work in turn, so that they wait for memory together; any gap ends the way of any
  // hand.
  void move_alone(std::uint32_t begin, std::uint32_t end) {
    struct Hand {
      CellRecord<A> cell;
      std::uint32_t place = kNowhere;
    };
    constexpr std::size_t kHands = 24;
    std::array<Hand, kHands> hands;
    std::uint32_t start = begin;
    // The next cell that is not where it belongs; leaves a gap there.
    const auto take_up = [&](Hand& hand) {
      for (; start < end; ++start) {
        const std::uint32_t place = carried_place(cells_[start]);
        if (place == kNowhere || place == start) continue;
        hand = {cells_[start], place};
        cells_[start++].corners[0] = kNowhere;
        return true;
      }
      return false;
    };
    for (bool is_busy = true; is_busy;) {
      is_busy = false;
      for (Hand& hand : hands) {
        if (hand.place == kNowhere && !take_up(hand)) continue;
        is_busy = true;
        const CellRecord<A> there = cells_[hand.place];
        cells_[hand.place] = hand.cell;
        hand = {there, carried_place(there)};
        if (hand.place != kNowhere) __builtin_prefetch(&cells_[hand.place], 1);
      }
    }
  }

  // Finds the final places of the cells of some vertices, and puts their corners in order.
  void rank(std::size_t begin, std::size_t end) {
    CellRanking<A> ranking;
    for (auto vertex = static_cast<std::uint32_t>(begin); vertex < end; ++vertex) {
      const std::uint32_t first = begins_[vertex], behind = begins_[vertex + 1];
      for (std::uint32_t cell = first; cell < behind; ++cell) {
        Corners& corners = cells_[cell].corners;
        maps_[cell] = sort_corners<A>(put_back(corners, vertex), is_oriented_, corners);
      }
      ranking.rank({cells_.data() + first, behind - first});
      for (std::uint32_t cell = first; cell < behind; ++cell) {
        place_[cell] = first + ranking.ranks()[cell - first];
      }
    }
  }

  // Brings the cells of some vertices to their final places.
  void settle(std::size_t begin, std::size_t end) {
    std::vector<CellRecord<A>> of_vertex;
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      const std::uint32_t first = begins_[vertex];
      of_vertex.assign(cells_.data() + first, cells_.data() + begins_[vertex + 1]);
      for (std::uint32_t i = 0; i < of_vertex.size(); ++i) {
        CellRecord<A>& record = cells_[place_[first + i]];
        record.corners = of_vertex[i].corners;
        for (std::uint32_t corner = 0; corner <= A; ++corner) {
          const std::uint32_t facet = of_vertex[i].neighbours[corner];
          record.neighbours[mapped(maps_[first + i], corner)] =
              facet == kOutside ? kOutside
                                : 4 * place_[facet / 4] + mapped(maps_[facet / 4], facet % 4);
        }
      }
    }
  }

  CellArray<A> cells_;
  std::uint32_t infinity_;
  bool is_oriented_;
  Threads threads_;
  std::vector<std::uint32_t> begins_;  // [vertex] where the cells begin of which it is the smallest
  RawVector<std::uint32_t> place_;     // [cell] where it goes
  RawVector<CornerMap> maps_;          // [cell]
};

}  // namespace

template <int A>
CellArray<A> canonical_cells(CellStore<A> cells, const std::vector<bool>& is_hidden,
                             bool is_oriented, Threads threads) {
  const std::size_t sites = is_hidden.size();
  CellArray<A> result = CanonicalOrder<A>(std::move(cells), sites, is_oriented, threads).cells();
  if (std::find(is_hidden.begin(), is_hidden.end(), true) == is_hidden.end()) return result;
  std::vector<std::uint32_t> vertex_of(sites);  // [site]; means nothing where hidden
  std::uint32_t vertices = 0;
  for (std::size_t site = 0; site < sites; ++site) {
    vertex_of[site] = vertices;
    vertices += is_hidden[site] ? 0U : 1U;
  }
  for (CellRecord<A>& record : result) {
    for (std::uint32_t& corner : record.corners) corner = vertex_of[corner];
  }
  return result;
}

template CellArray<1> canonical_cells<1>(CellStore<1>, const std::vector<bool>&, bool, Threads);
template CellArray<2> canonical_cells<2>(CellStore<2>, const std::vector<bool>&, bool, Threads);
template CellArray<3> canonical_cells<3>(CellStore<3>, const std::vector<bool>&, bool, Threads);

}  // namespace orthoball
