// SPDX-License-Identifier: MIT
//
// Shortest paths from all parts of a side at once give every cell of the other side to the part
// that is nearest to it. On the cheapest path from a part to any other there are two cells next to
// each other that belong to it and to another part, or one that touches both.
#include "orthoball/queries/part_steps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>

namespace orthoball {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

template <int D>
class Paths {
 public:
  // From the parts of one side.
  Paths(const StarParts<D>& stars, std::size_t count, bool is_inside,
        const std::vector<double>& volumes)
      : stars_(stars),
        outside_(count),
        is_inside_(is_inside),
        volumes_(volumes),
        cost_(count, std::numeric_limits<double>::infinity()),
        owner_(count, kNone),
        before_(count, kNone),
        best_(stars.parts().size()) {
    grow();
    for (std::size_t place = 0; place < count; ++place) {
      if (owner_[place] != kNone) meet(place);
    }
  }

  // The cheapest path from a part: places; none if there is none.
  [[nodiscard]] std::vector<std::size_t> path(std::size_t part) const {
    std::vector<std::size_t> places;
    for (std::size_t at : best_[part].ends) {
      for (; at != kNone; at = before_[at]) places.push_back(at);
    }
    return places;
  }

 private:
  struct Best {
    double cost = std::numeric_limits<double>::infinity();
    std::array<std::size_t, 2> ends{kNone, kNone};
  };

  // The part of this side that a place beside has; kNone if it is of the other side.
  [[nodiscard]] std::size_t part_at(std::size_t place) const {
    const std::size_t part = place == outside_ ? 0 : stars_.part_of()[place];
    return stars_.parts()[part].is_inside == is_inside_ ? part : kNone;
  }

  void grow() {
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    const auto reach = [&](std::size_t place, double so_far, std::size_t part, std::size_t from) {
      const double total = so_far + volumes_[place];
      if (!(total < cost_[place])) return;
      cost_[place] = total;
      owner_[place] = part;
      before_[place] = from;
      front.emplace(total, place);
    };
    for (std::size_t place = 0; place < outside_; ++place) {
      if (part_at(place) != kNone) continue;
      stars_.for_each_beside(place, [&](std::size_t beside) {
        if (part_at(beside) != kNone) reach(place, 0.0, part_at(beside), kNone);
      });
    }
    while (!front.empty()) {
      const auto [so_far, place] = front.top();
      front.pop();
      if (so_far > cost_[place]) continue;
      stars_.for_each_beside(place, [&](std::size_t beside) {
        if (beside != outside_ && part_at(beside) == kNone) {
          reach(beside, so_far, owner_[place], place);
        }
      });
    }
  }

  // Whether a path ends or meets another here.
  void meet(std::size_t place) {
    stars_.for_each_beside(place, [&](std::size_t beside) {
      const std::size_t part = part_at(beside);
      if (part != kNone) {
        offer(owner_[place], part, cost_[place], {place, kNone});
      } else if (beside != outside_ && owner_[beside] != kNone) {
        offer(owner_[place], owner_[beside], cost_[place] + cost_[beside], {place, beside});
      }
    });
  }

  void offer(std::size_t a, std::size_t b, double cost, const std::array<std::size_t, 2>& ends) {
    if (a == b) return;
    for (const std::size_t part : {a, b}) {
      if (cost < best_[part].cost) best_[part] = {cost, ends};
    }
  }

  const StarParts<D>& stars_;
  std::size_t outside_;
  bool is_inside_;
  const std::vector<double>& volumes_;  // [place]
  std::vector<double> cost_;            // [place]: of the path that ends there
  std::vector<std::size_t> owner_;      // [place]: the part that it comes from
  std::vector<std::size_t> before_;     // [place]: where it comes from
  std::vector<Best> best_;              // [part]
};

}  // namespace

template <int D>
std::vector<PartStep> part_steps(const StarParts<D>& stars, std::span<const std::uint32_t> cells,
                                 const std::function<double(std::uint32_t)>& volume) {
  const auto parts = stars.parts();
  std::vector<double> volumes;
  for (const std::uint32_t cell : cells) volumes.push_back(volume(cell));
  std::vector<std::vector<std::size_t>> of_part(parts.size());
  for (std::size_t place = 0; place < cells.size(); ++place) {
    of_part[stars.part_of()[place]].push_back(place);
  }
  std::vector<PartStep> steps;
  const auto add = [&](const std::vector<std::size_t>& places) {
    if (places.empty()) return;
    PartStep& step = steps.emplace_back();
    for (const std::size_t place : places) {
      step.cost += volumes[place];
      step.cells.push_back(cells[place]);
    }
    std::sort(step.cells.begin(), step.cells.end());
  };
  for (const bool is_inside : {false, true}) {
    const auto count = std::count_if(parts.begin(), parts.end(), [&](const StarPart& part) {
      return part.is_inside == is_inside;
    });
    if (count < 2) continue;
    const Paths<D> paths(stars, cells.size(), is_inside, volumes);
    for (std::size_t part = 0; part < parts.size(); ++part) {
      if (parts[part].is_inside != is_inside) continue;
      if (!parts[part].has_outside) add(of_part[part]);
      add(paths.path(part));
    }
  }
  std::sort(steps.begin(), steps.end(), [](const PartStep& a, const PartStep& b) {
    if (a.cost != b.cost) return a.cost < b.cost;
    return a.cells.size() != b.cells.size() ? a.cells.size() < b.cells.size() : a.cells < b.cells;
  });
  return steps;
}

template std::vector<PartStep> part_steps(const StarParts<2>&, std::span<const std::uint32_t>,
                                          const std::function<double(std::uint32_t)>&);
template std::vector<PartStep> part_steps(const StarParts<3>&, std::span<const std::uint32_t>,
                                          const std::function<double(std::uint32_t)>&);

}  // namespace orthoball
