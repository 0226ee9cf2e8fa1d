// SPDX-License-Identifier: MIT
//
// Everything happens in the memory that the cells have. First they are grouped by their smallest
// corner: a counting sort gives each cell its place, neighbours are rewritten to these, corners are
// put in order, and records are moved along the cycles of that permutation, several at a time, for
// each step waits for memory. The smallest corner, now the first, follows from the place, so
// meanwhile a record carries its place instead: nothing but records is touched. Then the cells of
// each group, few and side by side, are put in order, and neighbours are rewritten once more: all
// they refer to is near by then.
#include "orthoball/triangulation/canonical_cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "orthoball/exact/orient.h"
#include "orthoball/exact/processor.h"
#include "orthoball/places_of_parts.h"
#include "orthoball/raw_vector.h"

namespace orthoball {
namespace {

/// Which corner of the new record each old corner has become, 2 bits each.
using CornerMap = std::uint8_t;

constexpr std::uint32_t mapped(CornerMap map, std::uint32_t old_corner) {
  return std::uint32_t{map} >> (2 * old_corner) & 3U;
}

// Which of two corners is larger, a bit for each pair: no branches, for the order of four is as
// good as random.
template <int A>
std::uint32_t comparisons(const Corners<A>& corners) {
  std::uint32_t bits = 0, bit = 0;
  for (std::size_t i = 1; i <= A; ++i) {
    for (std::size_t j = 0; j < i; ++j) bits |= std::uint32_t{corners[j] > corners[i]} << bit++;
  }
  return bits;
}

// [comparisons]: the map that sorts corners that compare so.
template <int A>
constexpr auto kAscendingMaps = [] {
  std::array<CornerMap, std::size_t{1} << (A * (A + 1) / 2)> maps{};
  for (std::uint32_t bits = 0; bits < maps.size(); ++bits) {
    std::uint32_t map = 0, bit = 0;
    for (std::uint32_t i = 1; i <= A; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        map += 1U << (2 * ((bits >> bit++ & 1U) != 0 ? j : i));
      }
    }
    maps[bits] = static_cast<CornerMap>(map);  // means nothing where bits contradict each other
  }
  return maps;
}();

// The same, but with the last two exchanged after an odd permutation. Not for segments, whose first
// corner would not be the smallest.
template <int A>
constexpr auto kOrientedMaps = [] {
  auto maps = kAscendingMaps<A>;
  for (std::uint32_t bits = 0; bits < maps.size(); ++bits) {
    if (std::popcount(bits) % 2 == 0) continue;
    std::uint32_t map = 0;
    for (std::uint32_t i = 0; i <= A; ++i) {
      const std::uint32_t rank = mapped(maps[bits], i);
      map |= (rank + 1 >= A && rank <= A ? 2 * A - 1 - rank : rank) << (2 * i);
    }
    maps[bits] = static_cast<CornerMap>(map);
  }
  return maps;
}();

// What tells cells apart that share their first corner: the distances of the other corners from it,
// ascending, as one number; negative if they do not fit, which is rare.
template <int A>
std::int64_t key_at_first(const Corners<A>& corners) {
  constexpr unsigned kBits = A == 3 ? 21 : 31;  // a corner
  Corners<A> ascending = corners;
  ascending[A - 1] = std::min(corners[A - 1], corners[A]);
  ascending[A] = std::max(corners[A - 1], corners[A]);
  std::int64_t key = 0;
  for (std::size_t i = 1; i <= A; ++i) key = key << kBits | (ascending[i] - corners[0]);
  return ascending[A] - corners[0] < std::uint32_t{1} << kBits ? key : -1;
}

/// Ranks the cells that share their first corner by the others.
template <int A>
class CellRanking {
 public:
  /// Puts into places[i] how many of the cells come before cells[i], plus `first`.
  [[gnu::always_inline]] void rank(std::span<const CellRecord<A>> cells, std::uint32_t first,
                                   std::span<std::uint32_t> places) {
    const std::size_t size = cells.size();
    if (size > kFew) return sort(cells, first, places);
    std::array<std::int64_t, kFew + kLanes - 1> keys;
    bool all_fit = true;
    for (std::size_t i = 0; i < size; ++i) {
      keys[i] = key_at_first<A>(cells[i].corners);
      all_fit &= keys[i] >= 0;
    }
    if (!all_fit) return sort(cells, first, places);
    std::fill_n(keys.begin() + size, kLanes - 1, 0);  // the rest of the last vector
    // Each with each, four at a time, for branches on the order of two would be coin tosses.
    for (std::size_t i = 0; i < size; i += kLanes) {
      const Lanes lanes = {keys[i], keys[i + 1], keys[i + 2], keys[i + 3]};
      Lanes place = Lanes{} + first;
      for (std::size_t j = 0; j < size; ++j) place -= lanes > keys[j];
      for (std::size_t k = 0; k < std::min(kLanes, size - i); ++k) {
        places[i + k] = static_cast<std::uint32_t>(place[k]);
      }
    }
  }

 private:
  static constexpr std::size_t kFew = 32;
  static constexpr std::size_t kLanes = 4;
  using Lanes = std::int64_t __attribute__((vector_size(8 * kLanes)));

  [[gnu::noinline]] void sort(std::span<const CellRecord<A>> cells, std::uint32_t first,
                              std::span<std::uint32_t> places) {
    order_.resize(cells.size());
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    const auto ascending = [&](std::uint32_t i) {
      auto corners = cells[i].corners;
      std::tie(corners[A - 1], corners[A]) = std::minmax({corners[A - 1], corners[A]});
      return corners;
    };
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t i, std::uint32_t j) { return ascending(i) < ascending(j); });
    for (std::uint32_t i = 0; i < order_.size(); ++i) places[order_[i]] = first + i;
  }

  std::vector<std::uint32_t> order_;
};

/// Where the cells of each vertex go, with its cells told apart by the smallest corner.
template <int A>
class CanonicalOrder {
 public:
  CanonicalOrder(CellStore<A> cells, std::size_t vertices, bool is_oriented, Threads threads)
      : cells_(cells.take()),
        infinity_(cells.infinity()),
        is_oriented_(is_oriented && A > 1),
        threads_(threads.for_work(cells_.size(), 1U << 15U)),
        begins_(vertices + 1, 0),
        place_(cells_.size()),
        maps_(cells_.size()) {}

  CellArray<A> cells() {
    find_places();
    redirect();
    move(0, static_cast<std::uint32_t>(cells_.size()), threads_);
    cells_.resize(begins_.back());
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
    std::uint32_t least = cell.corners[0], largest = cell.corners[0];
    for (const std::uint32_t corner : cell.corners) {
      least = std::min(least, corner);
      largest = std::max(largest, corner);
    }
    return {!CellStore<A>::is_dead(cell) && largest < infinity_, least};
  }

  // Fills begins_, place_ and maps_. Each part of the cells counts by itself, and then knows where
  // its own begin.
  void find_places() {
    // [part][vertex]: how many cells, then where the next goes.
    std::vector<std::vector<std::uint32_t>> next(parts());
    parallel_parts(threads_, cells_.size(), parts(),
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     next[part].resize(vertices());
                     const auto& maps = is_oriented_ ? kOrientedMaps<A> : kAscendingMaps<A>;
                     for (std::size_t cell = begin; cell < end; ++cell) {
                       const auto [is_kept, vertex] = kept(cells_[cell]);
                       place_[cell] = is_kept ? vertex : kNowhere;
                       maps_[cell] = maps[comparisons<A>(cells_[cell].corners)];
                       if (is_kept) ++next[part][vertex];
                     }
                   });
    find_places_of_parts(next, begins_);
    parallel_parts(threads_, cells_.size(), parts(),
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     for (std::size_t cell = begin; cell < end; ++cell) {
                       std::uint32_t& place = place_[cell];  // as yet the smallest corner
                       if (place != kNowhere) place = next[part][place]++;
                     }
                   });
  }

  // Puts the corners in order, and the place instead of the first. Neighbours become places;
  // kOutside where they are not kept. What is not kept becomes a gap.
  void redirect() {
    parallel_parts(threads_, cells_.size(), parts(),
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t cell = begin; cell < end; ++cell) {
                       const std::uint32_t place = place_[cell];
                       if (place != kNowhere) redirect(cells_[cell], maps_[cell]);
                       cells_[cell].corners[0] = place;
                     }
                   });
  }
  void redirect(CellRecord<A>& record, CornerMap map) const {
    const CellRecord<A> old = record;
    for (std::uint32_t corner = 0; corner <= A; ++corner) {
      const std::uint32_t facet = old.neighbours[corner];
      const std::uint32_t place = place_[facet / 4];
      const std::uint32_t to = mapped(map, corner);
      record.corners[to] = old.corners[corner];
      record.neighbours[to] =
          place == kNowhere ? kOutside : 4 * place + mapped(maps_[facet / 4], facet % 4);
    }
  }
  static std::uint32_t carried_place(const CellRecord<A>& cell) { return cell.corners[0]; }

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

  // Finds the final places of the cells of some vertices, which become their first corners again.
  // The same code twice, the compiler's own vectors being too narrow for the keys.
  void rank(std::size_t begin, std::size_t end) {
    if (has_avx2()) return rank_wide(begin, end);
    rank_inline(begin, end);
  }
  [[gnu::flatten]] ORTHOBALL_AVX2 void rank_wide(std::size_t begin, std::size_t end) {
    rank_inline(begin, end);
  }
  [[gnu::always_inline]] void rank_inline(std::size_t begin, std::size_t end) {
    CellRanking<A> ranking;
    for (auto vertex = static_cast<std::uint32_t>(begin); vertex < end; ++vertex) {
      const std::uint32_t first = begins_[vertex], behind = begins_[vertex + 1];
      for (std::uint32_t cell = first; cell < behind; ++cell) cells_[cell].corners[0] = vertex;
      const std::size_t size = behind - first;
      ranking.rank({cells_.data() + first, size}, first, {place_.data() + first, size});
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
        record = of_vertex[i];
        for (std::uint32_t& facet : record.neighbours) {
          if (facet != kOutside) facet = 4 * place_[facet / 4] + facet % 4;
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
