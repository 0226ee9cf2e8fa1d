// SPDX-License-Identifier: MIT
#include "orthoball/queries/star_parts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// In a list that ascends.
template <class Beside>
std::uint32_t parts_in(std::span<const Beside> list) {
  std::uint32_t parts = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i == 0 || list[i].part != list[i - 1].part) ++parts;
  }
  return parts;
}

}  // namespace

template <int D>
StarParts<D>::StarParts(const Filtration<D>& filtration, std::vector<bool> solid)
    : records_(filtration.triangulation().template cells<D>()),
      solid_(std::move(solid)),
      first_(filtration.count(0) + 1, 0),
      cells_((std::size_t{D} + 1) * records_.size()),
      part_(cells_.size(), kNone),
      sizes_(cells_.size() + filtration.count(0), 0),
      last_part_(filtration.count(0), 0),
      count_(filtration.count(0), Count{}),
      has_outside_(filtration.count(0), false),
      pieces_(records_),
      place_(records_.size()) {
  for (const CellRecord<D>& cell : records_) {
    for (const std::uint32_t vertex : cell.corners) ++first_[vertex + 1];
  }
  for (std::size_t vertex = 1; vertex < first_.size(); ++vertex) {
    first_[vertex] += first_[vertex - 1];
  }
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t cell = 0; cell < records_.size(); ++cell) {
    for (const std::uint32_t vertex : records_[cell].corners) cells_[next[vertex]++] = cell;
  }
  for (std::uint32_t vertex = 0; vertex < count_.size(); ++vertex) {
    divide(vertex);
    if (surplus(vertex) > 0) ++offending_count_;
  }
}

template <int D>
void StarParts<D>::divide(std::uint32_t vertex) {
  const auto start = [&](std::uint32_t cell, std::uint32_t part) {
    if (part_[slot(vertex, cell)] == kNone) flood(vertex, cell, part);
  };
  for (const std::uint32_t cell : cells(vertex)) {
    for_each_beside(records_, vertex, cell, [&](std::uint32_t beside) {
      if (beside != kOutside) return;
      has_outside_[vertex] = true;
      if (!solid_[cell]) start(cell, 0);
    });
  }
  std::uint32_t parts = 0;
  if (has_outside_[vertex]) {
    ++parts;
    ++count_[vertex][0];
  }
  for (const std::uint32_t cell : cells(vertex)) {
    if (part_[slot(vertex, cell)] != kNone) continue;
    ++count_[vertex][solid_[cell] ? 1 : 0];
    start(cell, parts++);
  }
  last_part_[vertex] = parts == 0 ? 0 : parts - 1;
}

// Gives a cell, and those joined to it that are of its side and have its part, another.
template <int D>
void StarParts<D>::flood(std::uint32_t vertex, std::uint32_t start, std::uint32_t part) {
  const std::uint32_t old = part_[slot(vertex, start)];
  const bool side = solid_[start];
  std::uint32_t count = 0;
  const auto come = [&](std::uint32_t cell) {
    if (cell == kOutside || solid_[cell] != side) return;
    std::uint32_t& here = part_[slot(vertex, cell)];
    if (here != old) return;
    here = part;
    front_.push_back(cell);
    ++count;
  };
  come(start);
  while (!front_.empty()) {
    const std::uint32_t cell = front_.back();
    front_.pop_back();
    for_each_beside(records_, vertex, cell, come);
  }
  if (old != kNone) size(vertex, old) -= count;
  size(vertex, part) += count;
  work_ += count;
}

// The number of no part. There are never more parts than cells and one.
template <int D>
std::uint32_t StarParts<D>::new_part(std::uint32_t vertex) {
  const auto end = static_cast<std::uint32_t>(cells(vertex).size() + 1);
  std::uint32_t& part = last_part_[vertex];
  do {
    part = part + 1 < end ? part + 1 : 0;
  } while (size(vertex, part) > 0 || (part == 0 && has_outside_[vertex]));
  return part;
}

// What the cells that turn around one vertex leave and join, and how many parts there are then if
// what they leave stays in one piece.
template <int D>
void StarParts<D>::look_at(Change& change) {
  const std::uint32_t vertex = change.vertex;
  const auto turned = change.turned.of(turned_);
  const bool was_inside = solid_[turned[0].cell];
  change.joined.first = joined_.size();
  change.seeds.first = seeds_.size();
  std::vector<std::uint32_t>& left = front_;  // parts
  for (std::uint32_t i = 0; i < turned.size(); ++i) {
    left.push_back(part(vertex, turned[i].cell));
    for_each_beside(records_, vertex, turned[i].cell, [&](std::uint32_t beside) {
      if (pieces_.is_out(beside)) return;
      auto& list = is_inside(beside) == was_inside ? seeds_ : joined_;
      list.push_back({part(vertex, beside), beside, i});
    });
  }
  const auto joined = joined_.begin() + static_cast<std::ptrdiff_t>(change.joined.first);
  const auto seeds = seeds_.begin() + static_cast<std::ptrdiff_t>(change.seeds.first);
  std::sort(joined, joined_.end());
  std::sort(seeds, seeds_.end());
  const auto is_same = [](const Beside& a, const Beside& b) { return a.cell == b.cell; };
  seeds_.erase(std::unique(seeds, seeds_.end(), is_same), seeds_.end());
  change.joined.end = joined_.size();
  change.seeds.end = seeds_.size();
  std::sort(left.begin(), left.end());
  const auto left_count = std::unique(left.begin(), left.end()) - left.begin();
  left.clear();
  change.count = count_[vertex];
  std::uint32_t &from = change.count[was_inside ? 1 : 0], &to = change.count[was_inside ? 0 : 1];
  from += parts_in<Beside>(change.seeds.of(seeds_)) - static_cast<std::uint32_t>(left_count);
  to -= parts_in<Beside>(change.joined.of(joined_));
  to += turned.size() == 1 ? 1U : static_cast<std::uint32_t>(groups(change).set_count());
}

// Of the cells that turn around a vertex: joined if they are next to each other or to one part.
template <int D>
UnionFind StarParts<D>::groups(const Change& change) {
  const auto turned = change.turned.of(turned_);
  const auto joined = change.joined.of(joined_);
  UnionFind groups(turned.size());
  for (std::uint32_t i = 0; i < turned.size(); ++i) place_[turned[i].cell] = i;
  for (std::uint32_t i = 0; i < turned.size(); ++i) {
    for_each_beside(records_, change.vertex, turned[i].cell, [&](std::uint32_t beside) {
      if (pieces_.is_out(beside)) groups.unite(i, place_[beside]);
    });
  }
  for (std::size_t i = 1; i < joined.size(); ++i) {
    if (joined[i].part == joined[i - 1].part) groups.unite(joined[i].turned, joined[i - 1].turned);
  }
  return groups;
}

// What is around all vertices of cells that are to turn.
template <int D>
void StarParts<D>::look(std::span<const std::uint32_t> cells) {
  pieces_.take_out(cells);
  turned_.clear();
  changes_.clear();
  joined_.clear();
  seeds_.clear();
  for (const std::uint32_t cell : cells) {
    for (const std::uint32_t vertex : records_[cell].corners) turned_.push_back({vertex, cell});
  }
  std::sort(turned_.begin(), turned_.end());
  for (std::size_t first = 0, end = 0; first < turned_.size(); first = end) {
    while (end < turned_.size() && turned_[end].vertex == turned_[first].vertex) ++end;
    look_at(changes_.emplace_back(Change{turned_[first].vertex, {first, end}}));
  }
}

// Calls `visit(pieces)` with the number of pieces in which every part remains, if any.
template <int D>
template <class Visit>
void StarParts<D>::for_each_cut(const Change& change, const Visit& visit) {
  const auto seeds = change.seeds.of(seeds_);
  std::vector<std::uint32_t> of_part;
  for (std::size_t first = 0, end = 0; first < seeds.size(); first = end) {
    of_part.clear();
    while (end < seeds.size() && seeds[end].part == seeds[first].part) {
      of_part.push_back(seeds[end++].cell);
    }
    if (of_part.size() == 1) continue;
    visit(static_cast<std::uint32_t>(pieces_.count(change.vertex, solid_, of_part)));
  }
}

template <int D>
std::int64_t StarParts<D>::most_gain(std::span<const std::uint32_t> cells) {
  look(cells);
  std::int64_t gain = 0;
  for (const Change& change : changes_)
    gain += surplus(change.vertex) - std::int64_t{surplus_of(change.count)};
  return gain;
}

template <int D>
std::int64_t StarParts<D>::gain(std::span<const std::uint32_t> cells, std::int64_t least) {
  std::int64_t gain = most_gain(cells);
  const std::size_t side = cells.empty() || !solid_[cells[0]] ? 0 : 1;
  for (const Change& change : changes_) {
    if (gain < least) break;
    Count count = change.count;
    gain += surplus_of(count);
    for_each_cut(change, [&](std::uint32_t pieces) { count[side] += pieces - 1; });
    gain -= surplus_of(count);
  }
  return gain;
}

// New parts for the pieces into which parts fall.
template <int D>
void StarParts<D>::cut(Change& change) {
  const std::uint32_t vertex = change.vertex;
  const std::size_t side = solid_[turned_[change.turned.first].cell] ? 1 : 0;
  for_each_cut(change, [&](std::uint32_t pieces) {
    change.count[side] += pieces - 1;
    if (pieces == 1) return;
    for (const auto& piece : pieces_.cut_off()) {
      const std::uint32_t old = part(vertex, piece[0]), part = new_part(vertex);
      for (const std::uint32_t cell : piece) part_[slot(vertex, cell)] = part;
      size(vertex, old) -= static_cast<std::uint32_t>(piece.size());
      size(vertex, part) += static_cast<std::uint32_t>(piece.size());
    }
  });
}

// The cells that turn go to the largest of the parts that they join, or to that which has what is
// beyond the hull, and so do the other ones; or they are new parts.
template <int D>
void StarParts<D>::join(const Change& change) {
  const std::uint32_t vertex = change.vertex;
  const auto turned = change.turned.of(turned_);
  for (const Turned& one : turned) --size(vertex, part(vertex, one.cell));
  UnionFind groups = this->groups(change);
  std::vector<std::uint32_t> target(turned.size(), kNone);
  const auto rank = [&](std::uint32_t part) {
    return std::pair(part == 0 && has_outside_[vertex], size(vertex, part));
  };
  for (const Beside& one : change.joined.of(joined_)) {
    std::uint32_t& part = target[groups.find(one.turned)];
    if (part == kNone || rank(one.part) > rank(part)) part = one.part;
  }
  for (const Beside& one : change.joined.of(joined_)) {
    const std::uint32_t part = target[groups.find(one.turned)];
    if (this->part(vertex, one.cell) != part) flood(vertex, one.cell, part);
  }
  for (std::uint32_t i = 0; i < turned.size(); ++i) {
    std::uint32_t& part = target[groups.find(i)];
    if (part == kNone) part = new_part(vertex);
    part_[slot(vertex, turned[i].cell)] = part;
    ++size(vertex, part);
  }
}

template <int D>
void StarParts<D>::turn(std::span<const std::uint32_t> cells) {
  look(cells);
  for (Change& change : changes_) {
    cut(change);
    join(change);
    const bool was_offending = surplus(change.vertex) > 0;
    count_[change.vertex] = change.count;
    const bool is_offending = surplus(change.vertex) > 0;
    if (is_offending && !was_offending) ++offending_count_;
    if (!is_offending && was_offending) --offending_count_;
  }
  for (const std::uint32_t cell : cells) solid_[cell] = !solid_[cell];
}

template class StarParts<2>;
template class StarParts<3>;

}  // namespace orthoball
