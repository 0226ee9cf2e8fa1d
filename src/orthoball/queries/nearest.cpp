// SPDX-License-Identifier: MIT
//
// The simplices of the boundary are halved again and again along the longest side of the box around
// their centres; boxes are searched the nearer first, and not at all where the whole box is farther
// away than what was found.
#include "orthoball/queries/nearest.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "orthoball/measures/scaled_balls.h"
#include "orthoball/queries/query_points.h"
#include "orthoball/vectors.h"

namespace orthoball {
namespace {

constexpr std::size_t kLeaf = 4;         // simplices at most
constexpr std::size_t kLeastPart = 256;  // points for a thread of its own
constexpr double kFar = std::numeric_limits<double>::infinity();

template <int D>
using Point = std::array<double, std::size_t{D}>;

template <int D>
Point<D> along(const Point<D>& from, const Point<D>& direction, double t) {
  Point<D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = from[i] + t * direction[i];
  return result;
}
template <int D>
double square_distance(const Point<D>& a, const Point<D>& b) {
  const Point<D> d = difference(a, b);
  return inner(d, d);
}

template <int D>
Point<D> nearest_on_segment(const Point<D>& a, const Point<D>& b, const Point<D>& q) {
  const Point<D> direction = difference(b, a);
  const double t = inner(difference(q, a), direction) / inner(direction, direction);
  if (!(t > 0.0)) return a;
  return t < 1.0 ? along<D>(a, direction, t) : b;
}

// On its sides, or inside where the point above it is.
Point<3> nearest_on_triangle(const std::array<Point<3>, 3>& corners, const Point<3>& q) {
  Point<3> best = nearest_on_segment<3>(corners[0], corners[1], q);
  for (const auto& [i, j] : {std::pair{1, 2}, std::pair{2, 0}}) {
    const Point<3> other = nearest_on_segment<3>(corners[static_cast<std::size_t>(i)],
                                                 corners[static_cast<std::size_t>(j)], q);
    if (square_distance<3>(other, q) < square_distance<3>(best, q)) best = other;
  }
  // With u, v the sides at corner 0: the normal equations of |q - corner - s u - t v|.
  const Point<3> u = difference(corners[1], corners[0]);
  const Point<3> v = difference(corners[2], corners[0]);
  const Point<3> w = difference(q, corners[0]);
  const double uu = inner(u, u), uv = inner(u, v), vv = inner(v, v);
  const double wu = inner(w, u), wv = inner(w, v), area = uu * vv - uv * uv;
  const double s = (vv * wu - uv * wv) / area, t = (uu * wv - uv * wu) / area;
  if (!(s > 0.0 && t > 0.0 && s + t < 1.0)) return best;
  const Point<3> inside = along<3>(along<3>(corners[0], u, s), v, t);
  return square_distance<3>(inside, q) < square_distance<3>(best, q) ? inside : best;
}

// A simplex of the boundary: its first `count` corners.
template <int D>
struct Piece {
  std::array<Point<D>, std::size_t{D}> corners{};
  std::size_t count = 0;
  SimplexId simplex{};

  [[nodiscard]] Point<D> nearest(const Point<D>& q) const {
    if constexpr (D == 3) {
      if (count == 3) return nearest_on_triangle(corners, q);
    }
    return count == 2 ? nearest_on_segment<D>(corners[0], corners[1], q) : corners[0];
  }
};

template <int D>
struct Bounds {
  Point<D> lower, upper;

  Bounds() {
    lower.fill(kFar);
    upper.fill(-kFar);
  }
  void add(const Point<D>& p) {
    for (std::size_t i = 0; i < D; ++i) {
      lower[i] = std::min(lower[i], p[i]);
      upper[i] = std::max(upper[i], p[i]);
    }
  }
  [[nodiscard]] double square_distance(const Point<D>& q) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < D; ++i) {
      const double outside = std::max({lower[i] - q[i], q[i] - upper[i], 0.0});
      sum += outside * outside;
    }
    return sum;
  }
};

template <int D>
class BoxTree {
 public:
  explicit BoxTree(std::vector<Piece<D>> pieces) : pieces_(std::move(pieces)) {
    if (!pieces_.empty()) (void)split(0, pieces_.size());
  }

  struct Found {
    Point<D> point{};
    double square_distance = kFar;
    SimplexId simplex{};
  };
  [[nodiscard]] Found nearest(const Point<D>& q) const {
    Found found;
    if (!boxes_.empty()) search(0, q, found);
    return found;
  }

 private:
  struct Box {
    Bounds<D> bounds;
    std::size_t begin, end;    // of pieces_
    std::uint32_t second = 0;  // half; the first half is the next box. 0 for a leaf
  };

  std::uint32_t split(std::size_t begin, std::size_t end) {
    const auto number = static_cast<std::uint32_t>(boxes_.size());
    Bounds<D> bounds, firsts;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < pieces_[i].count; ++k) bounds.add(pieces_[i].corners[k]);
      firsts.add(pieces_[i].corners[0]);
    }
    boxes_.push_back({bounds, begin, end});
    if (end - begin <= kLeaf) return number;
    std::size_t axis = 0;
    for (std::size_t i = 1; i < D; ++i) {
      if (firsts.upper[i] - firsts.lower[i] > firsts.upper[axis] - firsts.lower[axis]) axis = i;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return pieces_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const Piece<D>& a, const Piece<D>& b) {
      return std::tuple(a.corners[0][axis], a.simplex) < std::tuple(b.corners[0][axis], b.simplex);
    });
    (void)split(begin, middle);
    const std::uint32_t second = split(middle, end);
    boxes_[number].second = second;
    return number;
  }

  void search(std::uint32_t number, const Point<D>& q, Found& found) const {
    const Box& box = boxes_[number];
    if (box.bounds.square_distance(q) > found.square_distance) return;
    if (box.second == 0) {
      for (std::size_t i = box.begin; i < box.end; ++i) {
        const Point<D> point = pieces_[i].nearest(q);
        const double distance = square_distance<D>(point, q);
        if (std::tuple(distance, pieces_[i].simplex) <
            std::tuple(found.square_distance, found.simplex)) {
          found = {point, distance, pieces_[i].simplex};
        }
      }
      return;
    }
    std::uint32_t near = number + 1, far = box.second;
    if (boxes_[far].bounds.square_distance(q) < boxes_[near].bounds.square_distance(q)) {
      std::swap(near, far);
    }
    search(near, q, found);
    search(far, q, found);
  }

  std::vector<Piece<D>> pieces_;
  std::vector<Box> boxes_;
};

template <int D>
std::vector<Piece<D>> boundary_pieces(const AlphaComplex<D>& complex, const ScaledBalls<D>& balls) {
  const Filtration<D>& filtration = complex.filtration();
  std::vector<Piece<D>> pieces;
  for (int dimension = 0; dimension < D; ++dimension) {
    const std::uint32_t first = filtration.table().first(dimension);
    const auto end = static_cast<std::uint32_t>(first + filtration.count(dimension));
    for (std::uint32_t number = first; number < end; ++number) {
      const SimplexId simplex(number);
      const Role role = complex.role(simplex);
      if (role != Role::singular && (role != Role::regular || dimension < D - 1)) continue;
      Piece<D> piece;
      for (const VertexId vertex : filtration.vertices(simplex)) {
        piece.corners[piece.count++] = balls.spheres()[vertex.row()].x;
      }
      piece.simplex = simplex;
      pieces.push_back(piece);
    }
  }
  return pieces;
}

// Where a point is in the units of the balls, brought nearer by so many halvings that squares of
// distances are numbers: from that far all of the boundary is at one distance, twice as far being
// twice the distance.
template <int D>
std::pair<Point<D>, int> in_range(const ScaledBalls<D>& balls, const WeightedPoints& points,
                                  std::size_t row) {
  constexpr double kFarthest = 0x1p400;
  for (int halvings = 0;; halvings += 256) {
    Point<D> q;
    double size = 0.0;
    for (int axis = 0; axis < D; ++axis) {
      const double x = std::ldexp(points.coordinate(row, axis), -halvings);
      q[static_cast<std::size_t>(axis)] = balls.from_input(x, 1);
      size = std::max(size, std::abs(q[static_cast<std::size_t>(axis)]));
    }
    if (size <= kFarthest) return {q, halvings};
  }
}

}  // namespace

template <int D>
std::vector<BoundaryPoint<D>> nearest_on_boundary(const AlphaComplex<D>& complex,
                                                  const WeightedPoints& points, Threads threads) {
  require_dimension(points, D);
  constexpr double kNoRadii = -std::numeric_limits<double>::infinity();
  const ScaledBalls<D> balls(complex.filtration(), complex.index(), kNoRadii);
  const BoxTree<D> tree(boundary_pieces(complex, balls));
  const InputUnits lengths = balls.units(1);
  std::vector<BoundaryPoint<D>> result(points.size());
  const Threads used = threads.for_work(result.size(), kLeastPart);
  const auto find = [&](std::size_t i) {
    const auto [q, halvings] = in_range(balls, points, i);
    const auto found = tree.nearest(q);
    if (!found.simplex.exists()) return;
    result[i].simplex = found.simplex;
    result[i].distance = std::ldexp(lengths({std::sqrt(found.square_distance), 0.0}), halvings);
    for (std::size_t axis = 0; axis < D; ++axis) {
      result[i].point[axis] = lengths({found.point[axis], 0.0});
    }
  };
  parallel_parts(used, result.size(), used.count(),
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) find(i);
                 });
  return result;
}

template std::vector<BoundaryPoint<2>> nearest_on_boundary<2>(const AlphaComplex<2>&,
                                                              const WeightedPoints&, Threads);
template std::vector<BoundaryPoint<3>> nearest_on_boundary<3>(const AlphaComplex<3>&,
                                                              const WeightedPoints&, Threads);

}  // namespace orthoball
