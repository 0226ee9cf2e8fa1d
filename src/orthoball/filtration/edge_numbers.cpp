// SPDX-License-Identifier: MIT
//
// Edges numbered by what each cell has in common with smaller ones. First they have names
// (edge_names.h), several where a ring of cells is met in several places; the roots of united
// names, in order, are the edges.
//
// Each range of cells names its edges by itself, at the same time as others. Then names are united
// across the facets between ranges. Such a union makes a root of a range point to a name of a
// range before: these few `crossings` take their number from their root when all roots have
// numbers; until then they, and all names below them, have numbers from first_crossing_ on.
#include "orthoball/filtration/edge_numbers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "orthoball/exact/unrolled.h"
#include "orthoball/filtration/edge_names.h"

namespace orthoball {
namespace {

class Numbering {
 public:
  Numbering(std::span<const CellRecord<3>> cells, std::size_t ranges, Threads threads)
      : cells_(cells), threads_(threads), ranges_(ranges), names_(cells.size(), ranges) {
    result_.of_cells.resize(cells.size());
  }

  EdgeNumbers numbers() {
    name_all();
    if (ranges_.size() > 1) unite_across_ranges();
    number_all();
    for_each_range([&](Range& range) { write(range); });
    result_.owners.resize(edge_count_);
    return std::move(result_);
  }

 private:
  struct Range {
    CellRange cells;
    std::uint32_t end_name;
    std::uint32_t first_number;    // of the edges that it owns; before, how many these are
    std::uint32_t first_crossing;  // what stands for the first of its crossings
    std::uint32_t spare;           // the owner that edges met before are written to
    std::vector<std::uint32_t> facets_across;  // 4 * cell + corner, to ranges before
    std::vector<std::uint32_t> crossings;      // names whose parents are of ranges before
  };

  template <class Visit>
  void for_each_range(const Visit& visit) {
    parallel_for(threads_, ranges_.size(), [&](std::size_t i) { visit(ranges_[i]); });
  }

  void name_all();
  void collect_facets_across(Range& range) const;
  void unite_across_ranges();
  void number_all();
  void count(Range& range) const;
  void number(const Range& range);
  void write(const Range& range);

  std::span<const CellRecord<3>> cells_;
  Threads threads_;
  std::vector<Range> ranges_;
  EdgeNames names_;
  std::vector<std::uint32_t> number_of_crossing_;  // [crossing - first_crossing_]
  std::uint32_t first_crossing_ = 0xFFFFFFFFU;     // edges and crossings are fewer than names
  std::uint32_t edge_count_ = 0;
  EdgeNumbers result_;
};

void Numbering::name_all() {
  parallel_parts(
      threads_, cells_.size(), ranges_.size(),
      [&](std::size_t i, std::size_t begin, std::size_t end) {
        Range& range = ranges_[i];
        const auto first = static_cast<std::uint32_t>(begin);
        range.cells = {first, static_cast<std::uint32_t>(end), EdgeNames::first_name(first, i)};
        range.end_name = name_edges(cells_, range.cells, result_.of_cells.data(), names_);
        if (begin > 0) collect_facets_across(range);
      });
}

void Numbering::collect_facets_across(Range& range) const {
  for (std::uint32_t cell = range.cells.begin; cell < range.cells.end; ++cell) {
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      if (cells_[cell].neighbours[corner] / 4 < range.cells.begin) {
        range.facets_across.push_back(4 * cell + corner);
      }
    }
  }
}

void Numbering::unite_across_ranges() {
  for (const Range& range : ranges_) {
    for (const std::uint32_t facet : range.facets_across) {
      const std::uint32_t cell = facet / 4;
      const std::uint32_t beyond = cells_[cell].neighbours[facet % 4];
      const auto& here = kFacetSlots[ascending_corner(facet % 4, descends(cells_[cell]))];
      const auto& there = kFacetSlots[ascending_corner(beyond % 4, descends(cells_[beyond / 4]))];
      for (std::size_t i = 0; i < 3; ++i) {
        names_.unite(result_.of_cells[cell][here[i]], result_.of_cells[beyond / 4][there[i]]);
      }
    }
  }
}

// Ends the names: from here on number_of() is known.
void Numbering::number_all() {
  for_each_range([&](Range& range) { count(range); });
  std::uint32_t edges = 0;
  std::uint32_t crossings = 0;
  for (Range& range : ranges_) {
    edges += std::exchange(range.first_number, edges);
    crossings += static_cast<std::uint32_t>(range.crossings.size());
  }
  first_crossing_ -= crossings;
  std::uint32_t next = first_crossing_;
  for (Range& range : ranges_) {
    range.first_crossing = next;
    next += static_cast<std::uint32_t>(range.crossings.size());
    for (const std::uint32_t name : range.crossings) {
      number_of_crossing_.push_back(names_.root_now(name));
    }
  }
  for_each_range([&](const Range& range) { number(range); });
  for (std::uint32_t& root : number_of_crossing_) root = names_[root];
  edge_count_ = edges;
  // So far from each other that no two ranges write to the same lines of the cache.
  constexpr std::uint32_t kApart = 32;
  for (Range& range : ranges_) range.spare = edges += kApart;
  result_.owners.resize(edges + std::size_t{1});
}

// The roots, and the names below others of ranges before.
void Numbering::count(Range& range) const {
  const std::uint32_t first = range.cells.first_name;
  range.first_number = 0;
  for (std::uint32_t name = first; name < range.end_name; ++name) {
    range.first_number += names_[name] == name ? 1U : 0U;
    if (names_[name] < first) range.crossings.push_back(name);
  }
}

void Numbering::number(const Range& range) {
  const std::uint32_t first = range.cells.first_name;
  std::uint32_t next = range.first_number;
  std::uint32_t next_crossing = range.first_crossing;
  for (std::uint32_t name = first; name < range.end_name; ++name) {
    const std::uint32_t parent = names_[name];
    if (parent < first) {
      names_[name] = next_crossing++;
      continue;
    }
    const bool is_root = parent == name;
    names_[name] = is_root ? next : names_[parent];  // a smaller one has its number
    next += is_root ? 1 : 0;
  }
}

// From names to numbers. An edge is met for the first time where its number is none of those
// before.
void Numbering::write(const Range& range) {
  std::uint32_t next = range.first_number;
  const std::uint32_t first_crossing = first_crossing_;
  const std::uint32_t* const names = names_.parents();
  std::array<std::uint32_t, 6>* const of_cells = result_.of_cells.data();
  std::uint32_t* const owners = result_.owners.data();
  const std::uint32_t spare = range.spare;
  for (std::uint32_t cell = range.cells.begin; cell < range.cells.end; ++cell) {
    const auto& order = kAscendingSlot[descends(cells_[cell])];
    std::array<std::uint32_t, 6> edges;
    unrolled<6>([&](std::size_t slot) { edges[slot] = names[of_cells[cell][order[slot]]]; });
    std::uint32_t end = next;
    unrolled<6>([&](std::size_t slot) {
      std::uint32_t& edge = edges[slot];
      if (edge >= first_crossing) edge = number_of_crossing_[edge - first_crossing];
      const std::uint32_t met = 0U - static_cast<std::uint32_t>(edge < next);
      owners[(edge & ~met) | (spare & met)] = 6 * cell + static_cast<std::uint32_t>(slot);
      end = std::max(end, edge + 1);
    });
    of_cells[cell] = edges;
    next = end;
  }
}

}  // namespace

EdgeNumbers edge_numbers_in_ranges(std::span<const CellRecord<3>> cells, std::size_t ranges,
                                   Threads threads) {
  return Numbering(cells, ranges, threads).numbers();
}

EdgeNumbers edge_numbers(std::span<const CellRecord<3>> cells, Threads threads) {
  constexpr std::size_t kLeast = std::size_t{1} << 14U;
  const Threads used = threads.for_work(cells.size(), kLeast);
  return edge_numbers_in_ranges(cells, used.count(), used);
}

}  // namespace orthoball
