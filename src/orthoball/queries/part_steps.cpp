// SPDX-License-Identifier: MIT
//
// Shortest paths from all parts at once give every cell to the part of the other side that is
// nearest to it. On the cheapest path from a part to any other there are two cells next to each
// other that belong to it and to another part, or one that belongs to it and touches another.
#include "orthoball/queries/part_steps.h"

#include <algorithm>
#include <functional>

namespace orthoball {

// Whether there are several parts that a path through the cell could join.
template <int D>
bool PartSteps<D>::has_paths(std::uint32_t vertex, std::uint32_t cell) const {
  return stars_.part_count(vertex, !stars_.is_inside(cell)) > 1;
}

// A path comes to a cell; `by` as it was before.
template <int D>
void PartSteps<D>::reach(std::uint32_t cell, Reach by) {
  by.cost += volumes_[cell];
  ++by.length;
  if (is_fixed_[cell] || !(by.cost < reached(cell).cost)) return;
  reached(cell) = by;
  front_.emplace_back(by.cost, cell);
  std::push_heap(front_.begin(), front_.end(), std::greater<>());
}

template <int D>
void PartSteps<D>::grow(std::uint32_t vertex) {
  const auto star = stars_.cells(vertex);
  for (std::uint32_t place = 0; place < star.size(); ++place) place_[star[place]] = place;
  reached_.assign(star.size(), {});
  for (const std::uint32_t cell : star) {
    if (!has_paths(vertex, cell)) continue;
    for_each_beside(stars_.records(), vertex, cell, [&](std::uint32_t beside) {
      if (stars_.is_inside(beside) == stars_.is_inside(cell)) return;
      reach(cell, {0.0, stars_.part(vertex, beside), kNone, 0});
    });
  }
  while (!front_.empty()) {
    std::pop_heap(front_.begin(), front_.end(), std::greater<>());
    const auto [cost, cell] = front_.back();
    front_.pop_back();
    Reach by = reached(cell);
    if (cost > by.cost) continue;
    by.before = cell;
    const bool is_inside = stars_.is_inside(cell);
    for_each_beside(stars_.records(), vertex, cell, [&](std::uint32_t beside) {
      if (beside != kOutside && stars_.is_inside(beside) == is_inside) reach(beside, by);
    });
  }
}

// Where paths end at another part, or meet: the cheapest from every part.
template <int D>
void PartSteps<D>::meet(std::uint32_t vertex) {
  const auto offer = [&](std::uint32_t part, const Path& path) {
    if (path.cost < paths_[part].cost) paths_[part] = path;
  };
  for (const std::uint32_t cell : stars_.cells(vertex)) {
    const Reach here = reached(cell);
    if (here.part == kNone) continue;
    for_each_beside(stars_.records(), vertex, cell, [&](std::uint32_t beside) {
      std::uint32_t other = kNone;
      Path path{here.cost, here.length, {cell, kNone}};
      if (stars_.is_inside(beside) != stars_.is_inside(cell)) {
        other = stars_.part(vertex, beside);
      } else if (beside != kOutside) {
        const Reach& there = reached(beside);
        other = there.part;
        path = {here.cost + there.cost, here.length + there.length, {cell, beside}};
      }
      if (other == kNone || other == here.part) return;
      offer(here.part, path);
      offer(other, path);
    });
  }
}

template <int D>
void PartSteps<D>::add(std::vector<PartStep>& steps, std::vector<std::uint32_t> cells) const {
  std::sort(cells.begin(), cells.end());
  PartStep& step = steps.emplace_back();
  for (const std::uint32_t cell : cells) step.cost += volumes_[cell];
  step.cells = std::move(cells);
}

// Of those with many cells the cheapest.
template <int D>
void PartSteps<D>::add_paths(std::vector<PartStep>& steps) {
  const Path* cheapest = nullptr;
  for (const Path& path : paths_) {
    if (path.length > kManyCells && (cheapest == nullptr || path.cost < cheapest->cost)) {
      cheapest = &path;
    }
  }
  for (const Path& path : paths_) {
    if (path.length == 0 || (path.length > kManyCells && &path != cheapest)) continue;
    std::vector<std::uint32_t> cells;
    for (std::uint32_t at : path.ends) {
      for (; at != kNone; at = reached(at).before) cells.push_back(at);
    }
    add(steps, std::move(cells));
  }
}

template <int D>
void PartSteps<D>::add_wholes(std::vector<PartStep>& steps, std::uint32_t vertex) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // parts and cells
  for (const std::uint32_t cell : stars_.cells(vertex)) {
    if (stars_.part_count(vertex, stars_.is_inside(cell)) < 2) continue;
    order.emplace_back(stars_.part(vertex, cell), cell);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    const std::uint32_t part = order[first].first;
    bool may_turn = part > 0 || !stars_.has_outside(vertex);
    std::vector<std::uint32_t> cells;
    for (; end < order.size() && order[end].first == part; ++end) {
      cells.push_back(order[end].second);
      if (is_fixed_[order[end].second]) may_turn = false;
    }
    if (may_turn) add(steps, std::move(cells));
  }
}

template <int D>
std::vector<PartStep> PartSteps<D>::at(std::uint32_t vertex, bool of_any_size) {
  paths_.assign(stars_.cells(vertex).size() + 1, {});
  grow(vertex);
  meet(vertex);
  std::vector<PartStep> steps;
  add_paths(steps);
  add_wholes(steps, vertex);
  std::sort(steps.begin(), steps.end(), [](const PartStep& a, const PartStep& b) {
    if (a.cost != b.cost) return a.cost < b.cost;
    return a.cells.size() != b.cells.size() ? a.cells.size() < b.cells.size() : a.cells < b.cells;
  });
  bool has_many = !of_any_size;
  std::erase_if(steps, [&](const PartStep& step) {
    return step.cells.size() > kManyCells && std::exchange(has_many, true);
  });
  return steps;
}

template class PartSteps<2>;
template class PartSteps<3>;

}  // namespace orthoball
