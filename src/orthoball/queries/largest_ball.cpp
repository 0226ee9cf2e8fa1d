// SPDX-License-Identifier: MIT
//
// The distance to the nearest ball is largest at a vertex of the Voronoi diagram: an orthocentre,
// if all radii are equal. If they are not, balls grow from some orthocentres (inscribed_ball.h),
// and then it is shown that none is much larger, or a larger one is found, by branch and bound:
// from every point of a simplex a ball is no farther than from the farthest corner, so the least of
// these distances bounds the balls around all its points. The simplex with the largest bound is
// halved, until no bound is much larger than the largest ball. Balls that are farther than another
// from everywhere in a simplex are not looked at again in its parts.
#include "orthoball/queries/largest_ball.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace orthoball {
namespace {

template <int D>
using Point = std::array<double, std::size_t{D}>;
template <int D>
using Simplex = std::array<Point<D>, std::size_t{D} + 1>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <int D>
double distance(const Point<D>& a, const Point<D>& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < D; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return std::sqrt(sum);
}

template <int D>
Point<D> middle(std::span<const Point<D>> points) {
  Point<D> sum{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (const Point<D>& point : points) sum[axis] += point[axis];
    sum[axis] /= static_cast<double>(points.size());
  }
  return sum;
}

// No ball around a point of the simplex is larger than this and outside of `ball`.
template <int D>
double bound(const Simplex<D>& simplex, const Sphere<D>& ball) {
  double farthest = 0.0;
  for (const Point<D>& corner : simplex) {
    farthest = std::max(farthest, distance<D>(corner, ball.x));
  }
  return farthest - ball.radius;
}

// Both parts of a simplex that is cut across its longest edge.
template <int D>
std::array<Simplex<D>, 2> halves(const Simplex<D>& simplex) {
  std::array<std::size_t, 2> ends{0, 1};
  double longest = -1.0;
  for (std::size_t j = 0; j <= D; ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const double length = distance<D>(simplex[i], simplex[j]);
      if (length > longest) {
        longest = length;
        ends = {i, j};
      }
    }
  }
  std::array<Simplex<D>, 2> result{simplex, simplex};
  const Point<D> cut = middle<D>(std::array{simplex[ends[0]], simplex[ends[1]]});
  for (std::size_t half = 0; half < 2; ++half) result[half][ends[half]] = cut;
  return result;
}

// No ball around a point of the simplex is larger and outside of all corners of its cell.
template <int D>
double bound(const Simplex<D>& simplex, const VoidCell<D>& cell, double enough, int halvings) {
  double least = kInfinity;
  for (const Sphere<D>& corner : cell.corners) {
    if (corner.radius > 0.0) least = std::min(least, bound<D>(simplex, corner));
  }
  if (halvings == 0 || least <= enough || least == kInfinity) return least;
  const auto [first, second] = halves<D>(simplex);
  return std::max(bound<D>(first, cell, enough, halvings - 1),
                  bound<D>(second, cell, enough, halvings - 1));
}

template <int D>
class BallSearch {
 public:
  explicit BallSearch(std::span<const Sphere<D>> balls) : balls_(balls) {
    double least = balls.empty() ? 0.0 : kInfinity;
    for (const Sphere<D>& ball : balls) least = std::min(least, ball.radius);
    little_ = least / 1024;
  }

  void grow_from(const Point<D>& start) {
    const InscribedBall<D> found = inscribed_ball<D>(start, balls_);
    if (found.radius > largest_.radius) largest_ = found;
  }
  void divide(std::span<const VoidCell<D>> cells);
  [[nodiscard]] const InscribedBall<D>& largest() const { return largest_; }

 private:
  static constexpr std::uint32_t kMostParts = std::uint32_t{1} << 16U;

  // A part of a cell, with the balls that may be the nearest to some of its points.
  struct Part {
    double bound;
    std::uint32_t number;
    Simplex<D> simplex;
    std::uint32_t near;                                    // of lists_
    friend bool operator<(const Part& a, const Part& b) {  // the first is the largest
      return a.bound != b.bound ? a.bound < b.bound : a.number > b.number;
    }
  };

  // Balls that are not larger are not looked for.
  [[nodiscard]] double enough() const {
    const double found = std::max(0.0, largest_.radius);
    return found + std::max(found / 128, little_);
  }
  void look_at(const Part& part);

  std::span<const Sphere<D>> balls_;
  double little_;
  InscribedBall<D> largest_{{}, -1.0};
  std::priority_queue<Part> waiting_;
  std::vector<std::vector<std::uint32_t>> lists_;  // of balls, by number
  std::vector<double> gaps_;                       // of balls from the middle of a part
  std::uint32_t parts_ = 0;
};

template <int D>
void BallSearch<D>::divide(std::span<const VoidCell<D>> cells) {
  lists_.emplace_back(balls_.size());
  std::iota(lists_[0].begin(), lists_[0].end(), 0U);
  for (const VoidCell<D>& cell : cells) {
    constexpr int kHalvings = 6;  // before all balls are asked
    Simplex<D> simplex;
    for (std::size_t i = 0; i <= D; ++i) simplex[i] = cell.corners[i].x;
    const double most = bound<D>(simplex, cell, enough(), kHalvings);
    if (most > enough()) waiting_.push({most, parts_++, simplex, 0});
  }
  const std::uint32_t most = parts_ + kMostParts;
  while (!waiting_.empty() && parts_ < most && waiting_.top().bound > enough()) {
    const Part part = waiting_.top();
    waiting_.pop();
    look_at(part);
  }
}

template <int D>
void BallSearch<D>::look_at(const Part& part) {
  const Point<D> centre = middle<D>(part.simplex);
  double half_width = 0.0;
  for (const Point<D>& corner : part.simplex) {
    half_width = std::max(half_width, distance<D>(corner, centre));
  }
  gaps_.clear();
  double least_gap = kInfinity, least_bound = part.bound;
  for (const std::uint32_t number : lists_[part.near]) {
    const Sphere<D>& ball = balls_[number];
    gaps_.push_back(distance<D>(centre, ball.x) - ball.radius);
    least_gap = std::min(least_gap, gaps_.back());
    if (gaps_.back() < least_bound) {  // as no bound is smaller than the gap
      least_bound = std::min(least_bound, bound<D>(part.simplex, ball));
    }
  }
  if (least_gap > largest_.radius) grow_from(centre);
  if (least_bound <= enough()) return;
  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    if (gaps_[i] - half_width <= least_bound) near.push_back(lists_[part.near][i]);
  }
  const auto list = static_cast<std::uint32_t>(lists_.size());
  lists_.push_back(std::move(near));
  for (const Simplex<D>& half : halves<D>(part.simplex)) {
    waiting_.push({least_bound, parts_++, half, list});
  }
}

// The orthocentres around which balls are largest, the corners of their own cells alone
// considered.
template <int D>
std::vector<Point<D>> best_starts(std::span<const VoidCell<D>> cells) {
  constexpr std::size_t kMost = 32;
  std::vector<std::pair<double, std::uint32_t>> starts;  // radius less than 0, cell
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    starts.emplace_back(-ball_around<D>(cells[cell].orthocentre, cells[cell].corners).radius, cell);
  }
  const std::size_t size = std::min(kMost, starts.size());
  std::partial_sort(starts.begin(), starts.begin() + static_cast<std::ptrdiff_t>(size),
                    starts.end());
  std::vector<Point<D>> result;
  for (std::size_t i = 0; i < size; ++i) result.push_back(cells[starts[i].second].orthocentre);
  return result;
}

}  // namespace

template <int D>
InscribedBall<D> largest_ball(std::span<const VoidCell<D>> cells,
                              std::span<const Sphere<D>> balls) {
  BallSearch<D> search(balls);
  if (balls.size() <= D) return search.largest();
  for (const Point<D>& start : best_starts<D>(cells)) search.grow_from(start);
  const bool are_equal = std::all_of(balls.begin(), balls.end(), [&](const Sphere<D>& ball) {
    return ball.radius == balls[0].radius;
  });
  if (!are_equal) search.divide(cells);
  return search.largest();
}

template InscribedBall<2> largest_ball(std::span<const VoidCell<2>>, std::span<const Sphere<2>>);
template InscribedBall<3> largest_ball(std::span<const VoidCell<3>>, std::span<const Sphere<3>>);

}  // namespace orthoball
