// SPDX-License-Identifier: MIT
//
// Everything happens in the memory that the cells have. First they are grouped by their smallest
// corner: a counting sort gives each cell its place, neighbours are rewritten to these, and records
// are moved along the cycles of that permutation, several at a time, for each step waits for
// memory. Then the cells of each group, few and side by side, are put in order with their corners,
// and neighbours are rewritten once more: all they refer to is near by then.
#include "orthoball/triangulation/canonical_cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "orthoball/raw_vector.h"

namespace orthoball {
namespace {

/// Which corner of the new record each old corner has become, 2 bits each.
using CornerMap = std::uint8_t;

std::uint32_t mapped(CornerMap map, std::uint32_t old_corner) {
  return std::uint32_t{map} >> (2 * old_corner) & 3U;
}

template <int A>
struct SortedCorners {
  std::array<std::uint32_t, std::size_t{A + 1}> corners;
  CornerMap map;
};

// The corners in ascending order, the last two exchanged after an odd permutation where orientation
// matters. By ranks, without branches: the order of four is as good as random.
template <int A>
SortedCorners<A> sorted_corners(const std::array<std::uint32_t, std::size_t{A + 1}>& old,
                                bool is_oriented) {
  std::array<std::uint32_t, std::size_t{A + 1}> rank{};
  std::uint32_t inversions = 0;
  for (std::size_t i = 0; i <= A; ++i) {
    for (std::size_t j = i + 1; j <= A; ++j) {
      const std::uint32_t inverted = old[i] > old[j] ? 1 : 0;
      rank[i] += inverted;
      rank[j] += 1 - inverted;
      inversions += inverted;
    }
  }
  const bool is_exchanged = is_oriented && inversions % 2 == 1;
  SortedCorners<A> sorted;
  std::uint32_t map = 0;
  for (std::uint32_t i = 0; i <= A; ++i) {
    if (is_exchanged && rank[i] + 1 >= A) rank[i] = 2 * A - 1 - rank[i];
    sorted.corners[rank[i]] = old[i];
    map |= rank[i] << (2 * i);
  }
  sorted.map = static_cast<CornerMap>(map);
  return sorted;
}

/// A cell among those that share its first corner.
template <int A>
struct CellAtSite {
  std::uint64_t key;  // the other corners, ascending, but for the largest of four
  std::uint32_t last;

  explicit CellAtSite(const std::array<std::uint32_t, std::size_t{A + 1}>& corners) {
    const auto [low, high] = std::minmax(corners[A - 1], corners[A]);
    key = A == 3 ? std::uint64_t{corners[1]} << 32U | low : std::uint64_t{low} << 32U | high;
    last = high;
  }
  // 1 if *this comes before `other`: no branches.
  [[nodiscard]] std::uint32_t precedes(const CellAtSite& other) const {
    return static_cast<std::uint32_t>(key < other.key) |
           (static_cast<std::uint32_t>(key == other.key) &
            static_cast<std::uint32_t>(last < other.last));
  }
};

// Puts into ranks[i] how many of the cells come before cells[i].
template <int A>
void rank(const std::vector<CellAtSite<A>>& cells, std::vector<std::uint32_t>& ranks) {
  constexpr std::size_t kFew = 32;
  ranks.assign(cells.size(), 0);
  if (cells.size() <= kFew) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const std::uint32_t precedes = cells[i].precedes(cells[j]);
        ranks[j] += precedes;
        ranks[i] += 1 - precedes;
      }
    }
    return;
  }
  std::vector<std::uint32_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return cells[i].precedes(cells[j]) != 0; });
  for (std::uint32_t i = 0; i < order.size(); ++i) ranks[order[i]] = i;
}

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
    move();
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
                       const auto [is_kept, vertex] = kept(cells_[cell]);
                       place_[cell] = is_kept ? next[part][vertex]++ : kNowhere;
                     }
                   });
  }

  // Neighbours become places; kOutside where they are not kept.
  void redirect() {
    parallel_parts(threads_, cells_.size(), parts(),
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t cell = begin; cell < end; ++cell) {
                       if (place_[cell] == kNowhere) continue;
                       for (std::uint32_t& facet : cells_[cell].neighbours) {
                         const std::uint32_t place = place_[facet / 4];
                         facet = place == kNowhere ? kOutside : 4 * place + facet % 4;
                       }
                     }
                   });
  }

  // Moves every kept cell to its place: a cell in hand is put down where it belongs and what was
  // there taken up, until that is a gap. Several hands work in turn, so that they wait for memory
  // together; any gap ends the way of any hand.
  void move() {
    struct Hand {
      CellRecord<A> cell;
      std::uint32_t place = kNowhere;
    };
    constexpr std::size_t kHands = 24;
    std::array<Hand, kHands> hands;
    std::uint32_t start = 0;
    const auto size = static_cast<std::uint32_t>(cells_.size());
    // The next cell that is not where it belongs; leaves a gap there.
    const auto take_up = [&](Hand& hand) {
      while (start < size && (place_[start] == kNowhere || place_[start] == start)) ++start;
      if (start == size) return false;
      hand = {cells_[start], place_[start]};
      place_[start++] = kNowhere;
      return true;
    };
    for (bool is_busy = true; is_busy;) {
      is_busy = false;
      for (Hand& hand : hands) {
        if (hand.place == kNowhere && !take_up(hand)) continue;
        is_busy = true;
        const std::uint32_t here = hand.place;
        const CellRecord<A> there = cells_[here];
        cells_[here] = hand.cell;
        hand = {there, std::exchange(place_[here], kNowhere)};
        if (hand.place == kNowhere) continue;
        __builtin_prefetch(&cells_[hand.place], 1);
        __builtin_prefetch(&place_[hand.place], 1);
      }
    }
  }

  // Finds the final places of the cells of some vertices, and puts their corners in order.
  void rank(std::size_t begin, std::size_t end) {
    std::vector<CellAtSite<A>> at_site;
    std::vector<std::uint32_t> ranks;
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      at_site.clear();
      for (std::uint32_t cell = begins_[vertex]; cell < begins_[vertex + 1]; ++cell) {
        const SortedCorners<A> sorted = sorted_corners<A>(cells_[cell].corners, is_oriented_);
        cells_[cell].corners = sorted.corners;
        maps_[cell] = sorted.map;
        at_site.emplace_back(sorted.corners);
      }
      orthoball::rank(at_site, ranks);
      for (std::uint32_t i = 0; i < ranks.size(); ++i) {
        place_[begins_[vertex] + i] = begins_[vertex] + ranks[i];
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
