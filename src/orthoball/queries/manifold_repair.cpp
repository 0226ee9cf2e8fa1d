// SPDX-License-Identifier: MIT
//
// The boundary of a solid is a manifold where the cells around every vertex are at most one part
// inside and one part outside (StarParts). What is more is surplus, and the sum of it over all
// vertices is to become 0.
//
// A step at a vertex changes the sides of some of its cells: a whole part, or the cheapest path of
// cells that joins one part to another of its side (PartSteps). It is taken if the surplus of all
// vertices of its cells, summed, becomes smaller, first those that change the least volume for each
// surplus part less. So there are no more steps than surplus at first.
//
// The steps at a vertex are its plan. When the cheapest step of all plans is due, it is looked at
// anew and, if it takes away less than was thought, it waits again. A plan is made anew when a part
// of the cells around its vertex has changed that grows with their number: around few cells
// whenever one has, around many so seldom that all plans together take time in proportion to what
// changed. What is missed so is found in rounds: when no plan has a step left, the vertices near
// cells that changed are planned anew, and when that gives none, all, then with steps of very many
// cells, too. Rounds are limited.
//
// Where no step is left but surplus is, the solid gives up all cells around some vertices, which
// never come back: a vertex with surplus has cells that it has not given up, so that happens no
// more than once a vertex, and ends, at worst, with no cells at all.
//
// Last, cells are changed back, one after the other, where that brings no surplus: a step may have
// made another one needless.
#include "orthoball/queries/manifold_repair.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "orthoball/measures/cell_gap.h"

namespace orthoball {
namespace {

// A plan is made anew when one in so many of the cells around its vertex has changed.
constexpr std::size_t kKeptFor = 64;
// What a step gains is known when it is planned if it has no more cells than kFewCells; of others
// it is thought to be kHighGain, which is much, until it is their turn.
constexpr std::size_t kFewCells = 7;
constexpr std::int64_t kHighGain = 4;
// Rounds of planning before vertices are cleared; more than a dozen are rare.
constexpr int kMostRounds = 100;
// Of the vertices with surplus, one in so many is cleared at once.
constexpr std::size_t kClearedAtOnce = 8;
// How often all changed cells are looked at whether they can be changed back; ten times is much.
constexpr std::uint32_t kMostPasses = 64;

template <int D>
std::vector<double> cell_volumes(const Filtration<D>& filtration, const ScaledBalls<D>& balls) {
  const auto cells = filtration.triangulation().template cells<D>();
  std::vector<double> volumes(cells.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    std::array<Sphere<D>, std::size_t{D} + 1> corners;
    for (std::size_t i = 0; i <= D; ++i) corners[i] = balls.spheres()[cells[cell].corners[i]];
    volumes[cell] = cell_volume(corners);
  }
  return volumes;
}

template <class Entry>
void push(std::vector<Entry>& heap, const Entry& entry) {
  heap.push_back(entry);
  std::push_heap(heap.begin(), heap.end(), std::greater<>());
}

template <class Entry>
Entry pop(std::vector<Entry>& heap) {
  std::pop_heap(heap.begin(), heap.end(), std::greater<>());
  const Entry entry = heap.back();
  heap.pop_back();
  return entry;
}

void sort_unique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

template <int D>
ManifoldRepair<D>::ManifoldRepair(const Filtration<D>& filtration, const ScaledBalls<D>& balls,
                                  std::vector<bool> solid)
    : volumes_(cell_volumes(filtration, balls)),
      stars_(filtration, std::move(solid)),
      at_first_(stars_.solid()),
      is_cleared_(volumes_.size(), false),
      steps_(stars_, volumes_, is_cleared_),
      turned_at_(filtration.count(0), 0) {}

template <int D>
std::vector<std::uint32_t> ManifoldRepair<D>::offending() const {
  std::vector<std::uint32_t> result;
  for (std::uint32_t vertex = 0; vertex < turned_at_.size(); ++vertex) {
    if (stars_.surplus(vertex) > 0) result.push_back(vertex);
  }
  return result;
}

template <int D>
std::vector<std::uint32_t> ManifoldRepair<D>::changed() const {
  std::vector<std::uint32_t> result;
  for (std::uint32_t cell = 0; cell < volumes_.size(); ++cell) {
    if (solid()[cell] != at_first_[cell]) result.push_back(cell);
  }
  return result;
}

template <int D>
void ManifoldRepair<D>::plan(std::uint32_t vertex, bool of_any_size) {
  if (stars_.surplus(vertex) == 0) return;
  work_ += stars_.cells(vertex).size();
  Plan& plan = plans_[vertex];
  plan = {steps_.at(vertex, of_any_size), {}, ++version_, 0};
  for (std::uint32_t step = 0; step < plan.steps.size(); ++step) {
    const auto& [volume, cells] = plan.steps[step];
    const std::int64_t gain = cells.size() > kFewCells ? kHighGain : stars_.most_gain(cells);
    if (gain > 0) plan.left.push_back({volume / static_cast<double>(gain), step});
  }
  std::make_heap(plan.left.begin(), plan.left.end(), std::greater<>());
  wait(vertex, plan);
}

template <int D>
void ManifoldRepair<D>::wait(std::uint32_t vertex, const Plan& plan) {
  if (!plan.left.empty()) push(waiting_, {plan.left[0].cost, vertex, plan.version});
}

template <int D>
void ManifoldRepair<D>::take_planned() {
  while (!waiting_.empty()) {
    const Waiting next = pop(waiting_);
    const auto found = plans_.find(next.vertex);
    if (found == plans_.end() || found->second.version != next.version) continue;
    take_next(next.vertex, found->second);
  }
}

// Whether cells changed beside those around a vertex since its plan was made, so that its steps
// gain more or less now. Around many cells nobody looks.
template <int D>
bool ManifoldRepair<D>::is_old(std::uint32_t vertex, const Plan& plan) const {
  const auto star = stars_.cells(vertex);
  if (star.size() > kKeptFor) return false;
  return std::any_of(star.begin(), star.end(), [&](std::uint32_t cell) {
    const auto& corners = stars_.records()[cell].corners;
    return std::any_of(corners.begin(), corners.end(),
                       [&](std::uint32_t corner) { return turned_at_[corner] > plan.version; });
  });
}

// The cheapest step of a plan, unless it turns out to be dearer: then it waits.
template <int D>
void ManifoldRepair<D>::take_next(std::uint32_t vertex, Plan& plan) {
  if (is_old(vertex, plan)) return this->plan(vertex, false);
  const Planned next = pop(plan.left);
  PartStep& step = plan.steps[next.step];
  const bool is_inside = solid()[step.cells[0]];
  const bool is_as_it_was =
      std::all_of(step.cells.begin(), step.cells.end(),
                  [&](std::uint32_t cell) { return solid()[cell] == is_inside; });
  const std::int64_t gain = is_as_it_was ? stars_.gain(step.cells, 1) : 0;
  work_ += step.cells.size();
  const double cost = gain > 0 ? step.cost / static_cast<double>(gain) : next.cost;
  if (cost > next.cost) push(plan.left, {cost, next.step});
  wait(vertex, plan);
  if (gain > 0 && cost <= next.cost) apply(PartStep(std::move(step)));  // may make another plan
}

template <int D>
void ManifoldRepair<D>::turn(std::span<const std::uint32_t> cells) {
  ++applied_count_;
  work_ += cells.size();
  stars_.turn(cells);
  ++version_;
  for (const std::uint32_t cell : cells) {
    const CellRecord<D>& record = stars_.records()[cell];
    for (const std::uint32_t corner : record.corners) turned_at_[corner] = version_;
    near_.insert(near_.end(), record.corners.begin(), record.corners.end());
    for (const std::uint32_t beyond : record.neighbours) {
      if (beyond != kOutside) near_.push_back(stars_.records()[beyond / 4].corners[beyond % 4]);
    }
  }
}

template <int D>
void ManifoldRepair<D>::apply(const PartStep& step) {
  turn(step.cells);
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t cell : step.cells) {
    const auto& corners = stars_.records()[cell].corners;
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t first = 0, end = 0; first < vertices.size(); first = end) {
    const std::uint32_t vertex = vertices[first];
    while (end < vertices.size() && vertices[end] == vertex) ++end;
    if (stars_.surplus(vertex) == 0) {
      plans_.erase(vertex);
      continue;
    }
    const auto found = plans_.find(vertex);
    if (found != plans_.end()) {
      found->second.turned += end - first;
      if (found->second.turned * kKeptFor < stars_.cells(vertex).size()) continue;
    }
    plan(vertex, false);
  }
}

template <int D>
void ManifoldRepair<D>::take_all_steps() {
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<std::uint32_t> vertices = std::exchange(near_, {});
    sort_unique(vertices);
    for (const std::uint32_t vertex : vertices) plan(vertex, false);
    const bool is_last = waiting_.empty();
    if (is_last) {
      for (const std::uint32_t vertex : offending()) plan(vertex, true);
    }
    const std::uint64_t before = applied_count_;
    take_planned();
    if (is_last && applied_count_ == before) return;
  }
}

template <int D>
void ManifoldRepair<D>::clear(std::uint32_t vertex) {
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t cell : stars_.cells(vertex)) {
    is_cleared_[cell] = true;
    if (solid()[cell]) cells.push_back(cell);
  }
  turn(cells);
}

// Of the vertices with surplus, those with the least volume of solid around them.
template <int D>
void ManifoldRepair<D>::clear_some() {
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const std::uint32_t vertex : offending()) {
    double volume = 0.0;
    for (const std::uint32_t cell : stars_.cells(vertex)) {
      if (solid()[cell]) volume += volumes_[cell];
    }
    work_ += stars_.cells(vertex).size();
    order.emplace_back(volume, vertex);
  }
  std::sort(order.begin(), order.end());
  plans_.clear();
  std::size_t count = 0;
  for (const auto& [volume, vertex] : order) {
    if (stars_.surplus(vertex) == 0) continue;
    clear(vertex);
    if (++count * kClearedAtOnce >= order.size()) return;
  }
}

// The largest first, until none can be.
template <int D>
void ManifoldRepair<D>::change_back() {
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const std::uint32_t cell : changed()) order.emplace_back(-volumes_[cell], cell);
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> pass_of(turned_at_.size(),
                                     0);  // in which cells around it changed last
  std::uint32_t pass = 1;
  const auto can_be = [&](std::uint32_t cell) {
    const auto& corners = stars_.records()[cell].corners;
    const auto is_new = [&](std::uint32_t vertex) { return pass_of[vertex] + 1 >= pass; };
    if (std::none_of(corners.begin(), corners.end(), is_new)) return false;
    ++work_;
    const std::array<std::uint32_t, 1> one{cell};
    if (stars_.gain(one, 0) < 0) return false;
    stars_.turn(one);
    for (const std::uint32_t vertex : corners) pass_of[vertex] = pass;
    return true;
  };
  while (pass <= kMostPasses &&
         std::erase_if(order, [&](const auto& one) { return can_be(one.second); }) > 0) {
    ++pass;
  }
}

template <int D>
void ManifoldRepair<D>::run() {
  for (const std::uint32_t vertex : offending()) plan(vertex, false);
  take_all_steps();
  while (stars_.offending_count() > 0) {
    clear_some();
    take_all_steps();
  }
  change_back();
}

template class ManifoldRepair<2>;
template class ManifoldRepair<3>;

}  // namespace orthoball
