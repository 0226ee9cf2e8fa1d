// SPDX-License-Identifier: MIT
//
// The boundary of a solid is a manifold where the cells around every vertex are at most one part
// inside and one part outside (StarParts). What is more is surplus, and the sum of it over all
// vertices is to become 0.
//
// A step at a vertex changes the sides of some of its cells: a whole part, or the cheapest path of
// cells that joins one part to another of its side. It is taken if the surplus of all vertices of
// its cells, summed, becomes smaller, first those that change the least volume for each surplus
// part less. So there are no more steps than surplus at first. Where no step is left but surplus
// is, the solid gives up all cells around one vertex, which never come back: a vertex with surplus
// has cells that it has not given up, so that happens no more than once a vertex, and ends, at
// worst, with no cells at all. In practice it hardly ever happens.
//
// A vertex with very many cells waits until no other has a step. Then its steps are found all at
// once (part_steps) and those that still gain are taken, the cheapest first; that repeats until
// none is. What a step changes there is known without looking at all of the cells (LargeStar).
//
// Last, cells are changed back, one after the other, where that brings no surplus: a step may have
// made another one needless.
#include "orthoball/queries/manifold_repair.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "orthoball/measures/cell_gap.h"
#include "orthoball/queries/part_steps.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kManyCells = 200;  // around a vertex; 27 are usual in space

}  // namespace

template <int D>
ManifoldRepair<D>::ManifoldRepair(const Filtration<D>& filtration, const ScaledBalls<D>& balls,
                                  std::vector<bool> solid)
    : filtration_(filtration),
      cells_(filtration.triangulation().template cells<D>()),
      balls_(balls),
      solid_(std::move(solid)),
      at_first_(solid_),
      is_cleared_(solid_.size(), false),
      stars_(filtration),
      surplus_(filtration.count(0), 0),
      version_(filtration.count(0), 0) {
  for (std::uint32_t vertex = 0; vertex < surplus_.size(); ++vertex) {
    surplus_[vertex] = surplus(vertex);
    if (stars_.cells(vertex).size() > kManyCells) {
      large_.emplace(vertex, LargeStar<D>(filtration, stars_, vertex, solid_));
    }
  }
}

template <int D>
std::uint32_t ManifoldRepair<D>::surplus(std::uint32_t vertex) {
  stars_.read(vertex, solid_);
  return stars_.surplus();
}

template <int D>
double ManifoldRepair<D>::volume(std::uint32_t cell) const {
  std::array<Sphere<D>, std::size_t{D} + 1> corners;
  for (std::size_t i = 0; i <= D; ++i) corners[i] = balls_.spheres()[cells_[cell].corners[i]];
  return cell_volume(corners);
}

template <int D>
std::vector<std::uint32_t> ManifoldRepair<D>::offending() const {
  std::vector<std::uint32_t> result;
  for (std::uint32_t vertex = 0; vertex < surplus_.size(); ++vertex) {
    if (surplus_[vertex] > 0) result.push_back(vertex);
  }
  return result;
}

template <int D>
std::vector<std::uint32_t> ManifoldRepair<D>::changed() const {
  std::vector<std::uint32_t> result;
  for (std::uint32_t cell = 0; cell < solid_.size(); ++cell) {
    if (solid_[cell] != at_first_[cell]) result.push_back(cell);
  }
  return result;
}

template <int D>
std::vector<std::uint32_t> ManifoldRepair<D>::vertices_of(
    std::span<const std::uint32_t> cells) const {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t cell : cells) {
    vertices.insert(vertices.end(), cells_[cell].corners.begin(), cells_[cell].corners.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

template <int D>
void ManifoldRepair<D>::turn(std::span<const std::uint32_t> cells) {
  for (const std::uint32_t cell : cells) solid_[cell] = !solid_[cell];
}

template <int D>
void ManifoldRepair<D>::add_step(std::vector<Step>& steps, Step step) const {
  const bool is_free = std::none_of(step.cells.begin(), step.cells.end(),
                                    [&](std::uint32_t cell) { return is_cleared_[cell]; });
  if (!is_free || step.cells.empty()) return;
  std::sort(step.cells.begin(), step.cells.end());
  for (const std::uint32_t cell : step.cells) step.cost += volume(cell);
  steps.push_back(std::move(step));
}

// The cheapest path through cells of the other side from a part to another of its side. Around the
// vertex that was read last.
template <int D>
void ManifoldRepair<D>::add_path(std::vector<Step>& steps, std::uint32_t vertex,
                                 std::uint32_t from) {
  const auto star = stars_.cells(vertex);
  const auto parts = stars_.parts();
  const auto part_of = stars_.part_of();
  const std::size_t outside = star.size();
  const auto part_at = [&](std::size_t place) -> std::uint32_t {
    return place == outside ? 0U : part_of[place];  // the part with the outside is the first
  };
  std::vector<double> cost(star.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(star.size(), outside);
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
  const auto reach = [&](std::size_t place, double so_far, std::size_t previous) {
    const double total = so_far + volume(star[place]);
    if (!(total < cost[place])) return;
    cost[place] = total;
    before[place] = previous;
    front.emplace(total, place);
  };
  for (std::size_t place = 0; place < star.size(); ++place) {
    if (parts[part_of[place]].is_inside == parts[from].is_inside) continue;
    bool touches = false;
    stars_.for_each_beside(place, [&](std::size_t next) { touches |= part_at(next) == from; });
    if (touches) reach(place, 0.0, outside);
  }
  while (!front.empty()) {
    const auto [so_far, place] = front.top();
    front.pop();
    if (so_far > cost[place]) continue;
    bool has_arrived = false;
    stars_.for_each_beside(place, [&](std::size_t next) {
      const StarPart& part = parts[part_at(next)];
      if (part.is_inside == parts[from].is_inside) has_arrived |= part_at(next) != from;
    });
    if (has_arrived) {
      Step step;
      for (std::size_t at = place; at != outside; at = before[at]) step.cells.push_back(star[at]);
      return add_step(steps, std::move(step));
    }
    stars_.for_each_beside(place, [&](std::size_t next) {
      if (next == outside || parts[part_of[next]].is_inside == parts[from].is_inside) return;
      reach(next, so_far, place);
    });
  }
}

// What could be done at a vertex, the smallest volume first.
template <int D>
std::vector<typename ManifoldRepair<D>::Step> ManifoldRepair<D>::steps(std::uint32_t vertex) {
  stars_.read(vertex, solid_);
  const auto star = stars_.cells(vertex);
  const auto parts = stars_.parts();
  std::array<std::uint32_t, 2> count{};
  for (const StarPart& part : parts) ++count[part.is_inside ? 1 : 0];
  std::vector<Step> steps;
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    if (count[parts[part].is_inside ? 1 : 0] < 2) continue;
    if (!parts[part].has_outside) {
      Step whole;
      for (std::size_t place = 0; place < star.size(); ++place) {
        if (stars_.part_of()[place] == part) whole.cells.push_back(star[place]);
      }
      add_step(steps, std::move(whole));
    }
    add_path(steps, vertex, part);
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
    return std::pair(a.cost, a.cells.size()) < std::pair(b.cost, b.cells.size());
  });
  return steps;
}

// How much less the surplus of all vertices is after cells, of one side, change to the other; where
// it is less than the least that is of use, it may be told as too much.
template <int D>
std::int64_t ManifoldRepair<D>::gain(std::span<const std::uint32_t> cells, std::int64_t least) {
  std::int64_t gain = 0;
  std::vector<const LargeStar<D>*> large;
  turn(cells);
  for (const std::uint32_t vertex : vertices_of(cells)) {
    gain += surplus_[vertex];
    if (const auto found = large_.find(vertex); found != large_.end()) {
      large.push_back(&found->second);
    } else {
      gain -= surplus(vertex);
    }
  }
  turn(cells);
  for (const LargeStar<D>* const star : large) {
    if (gain < least) break;
    gain -= star->surplus_after(cells);
  }
  return gain;
}

// That which changes the least volume for each surplus part it takes away; one without cells if no
// step takes any.
template <int D>
typename ManifoldRepair<D>::Step ManifoldRepair<D>::best_step(std::uint32_t vertex) {
  Step best;
  for (Step& step : steps(vertex)) {
    const std::int64_t taken = gain(step.cells, 1);
    if (taken <= 0) continue;
    step.cost /= static_cast<double>(taken);
    if (best.cells.empty() || step.cost < best.cost) best = std::move(step);
  }
  return best;
}

template <int D>
void ManifoldRepair<D>::wait(double cost, std::uint32_t vertex) {
  waiting_.push_back({cost, vertex, ++version_[vertex]});
  std::push_heap(waiting_.begin(), waiting_.end(), std::greater<>());
}

// All with surplus, but for those with very many cells.
template <int D>
void ManifoldRepair<D>::wait_all() {
  for (const std::uint32_t vertex : offending()) {
    if (large_.count(vertex) == 0) wait(-1.0, vertex);
  }
}

// Steps depend on the cells around the vertices around theirs: all these vertices wait anew.
template <int D>
void ManifoldRepair<D>::apply(std::span<const std::uint32_t> cells) {
  ++applied_count_;
  turn(cells);
  std::vector<std::uint32_t> around;
  for (const std::uint32_t vertex : vertices_of(cells)) {
    if (const auto large = large_.find(vertex); large != large_.end()) {
      large->second.turn(cells);
      surplus_[vertex] = large->second.surplus();
      continue;
    }
    surplus_[vertex] = surplus(vertex);
    const auto star = stars_.cells(vertex);
    around.insert(around.end(), star.begin(), star.end());
  }
  for (const std::uint32_t vertex : vertices_of(around)) {
    if (surplus_[vertex] > 0 && large_.count(vertex) == 0) wait(-1.0, vertex);
  }
}

template <int D>
void ManifoldRepair<D>::take_steps() {
  while (!waiting_.empty()) {
    std::pop_heap(waiting_.begin(), waiting_.end(), std::greater<>());
    const Waiting next = waiting_.back();
    waiting_.pop_back();
    if (next.version != version_[next.vertex] || surplus_[next.vertex] == 0) continue;
    const Step step = best_step(next.vertex);
    if (step.cells.empty()) continue;
    next.cost < step.cost ? wait(step.cost, next.vertex) : apply(step.cells);
  }
}

// At a vertex with very many cells.
template <int D>
void ManifoldRepair<D>::take_steps_at(std::uint32_t vertex) {
  std::uint32_t before = kNone;
  while (surplus_[vertex] > 0 && applied_count_ != before) {
    before = applied_count_;
    stars_.read(vertex, solid_);
    const std::vector<PartStep> steps = part_steps<D>(
        stars_, stars_.cells(vertex), [&](std::uint32_t cell) { return volume(cell); });
    for (const auto& [cost, cells] : steps) {
      const bool is_inside = solid_[cells[0]];
      const bool is_free = std::none_of(cells.begin(), cells.end(), [&](std::uint32_t cell) {
        return is_cleared_[cell] || solid_[cell] != is_inside;
      });
      if (is_free && gain(cells, 1) > 0) apply(cells);
    }
  }
}

template <int D>
void ManifoldRepair<D>::take_all_steps() {
  for (;;) {
    take_steps();
    const std::uint32_t before = applied_count_;
    for (const auto& [vertex, star] : large_) take_steps_at(vertex);
    if (applied_count_ == before) return;
    wait_all();
  }
}

// Of the vertices with surplus, that with the least volume of solid around it.
template <int D>
bool ManifoldRepair<D>::clear_one() {
  Step least;
  std::uint32_t vertex = kNone;
  for (const std::uint32_t candidate : offending()) {
    Step step;
    for (const std::uint32_t cell : stars_.cells(candidate)) {
      if (!solid_[cell]) continue;
      step.cells.push_back(cell);
      step.cost += volume(cell);
    }
    if (vertex != kNone && !(step.cost < least.cost)) continue;
    least = std::move(step);
    vertex = candidate;
  }
  if (vertex == kNone) return false;
  for (const std::uint32_t cell : stars_.cells(vertex)) is_cleared_[cell] = true;
  ++cleared_count_;
  apply(least.cells);
  return true;
}

// The largest first, until none can be.
template <int D>
void ManifoldRepair<D>::change_back() {
  std::vector<std::pair<double, std::uint32_t>> waiting;
  for (const std::uint32_t cell : changed()) waiting.emplace_back(-volume(cell), cell);
  std::sort(waiting.begin(), waiting.end());
  const auto can_be = [&](std::uint32_t cell) {
    const std::array<std::uint32_t, 1> one{cell};
    if (gain(one, 0) < 0) return false;
    apply(one);
    return true;
  };
  while (std::erase_if(waiting, [&](const auto& one) { return can_be(one.second); }) > 0) {
  }
}

template <int D>
void ManifoldRepair<D>::run() {
  wait_all();
  do {
    take_all_steps();
  } while (clear_one());
  change_back();
}

template class ManifoldRepair<2>;
template class ManifoldRepair<3>;

}  // namespace orthoball
