// SPDX-License-Identifier: MIT
//
// Sutherland and Hodgman's clipping of polygons, for all facets of a polyhedron at once. For every
// corner it is decided once whether it goes; a side between one that stays and one that goes gets
// one new corner, which both its facets use. So in a facet every run of corners that go gives way
// to one side between two new corners, and the new facet is made of the same sides in the other
// direction: each new corner begins one and ends one of them. They form closed loops, one unless
// rounding makes a plane that passes near many corners look bent, and the surface stays closed.
//
// New corners are found from the corner that stays, so that errors are small near the origin
// however far away the polytope began.
//
// Sutherland, Hodgman. Reentrant polygon clipping. Communications of the ACM 17 (1974).
#include "orthoball/queries/convex_polytope.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "orthoball/queries/sphere_triangles.h"
#include "orthoball/topology/union_find.h"
#include "orthoball/vectors.h"

namespace orthoball {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

// Sides are much shorter than corners are far from the origin if they are by this factor: some
// hundred rounding errors.
constexpr double kJoined = 0x1p-44;

}  // namespace

template <>
ConvexPolytope<2>::ConvexPolytope(const Point& lower, const Point& upper, std::uint32_t first_label)
    : corners_{
          {lower[0], lower[1]}, {upper[0], lower[1]}, {upper[0], upper[1]}, {lower[0], upper[1]}} {
  constexpr std::array<std::uint32_t, 4> kSides{2, 1, 3, 0};
  for (std::uint32_t i = 0; i < 4; ++i) {
    loops_.insert(loops_.end(), {i, (i + 1) % 4});
    facets_.push_back({first_label + kSides[i], 2 * i, 2 * i + 2});
  }
}

template <>
ConvexPolytope<3>::ConvexPolytope(const Point& lower, const Point& upper,
                                  std::uint32_t first_label) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point& x = corners_.emplace_back();
    for (unsigned axis = 0; axis < 3; ++axis) {
      x[axis] = (corner >> axis & 1U) != 0 ? upper[axis] : lower[axis];
    }
  }
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned here = 1U << axis, u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3;
    for (const auto& loop :
         {std::array{0U, v, u | v, u}, {here, here | u, here | u | v, here | v}}) {
      const auto begin = static_cast<std::uint32_t>(loops_.size());
      loops_.insert(loops_.end(), loop.begin(), loop.end());
      const auto number = static_cast<std::uint32_t>(facets_.size());
      facets_.push_back({first_label + number, begin, begin + 4});
    }
  }
}

template <>
ConvexPolytope<2> ConvexPolytope<2>::in_unit_sphere(double tolerance, std::uint32_t label) {
  // The middle of a side is 1 - cos(pi / count) from the circle.
  const double widest = std::acos(1.0 - tolerance);
  const auto count =
      static_cast<std::uint32_t>(std::max(3.0, std::ceil(std::numbers::pi / widest)));
  ConvexPolytope result;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    result.corners_.push_back({std::cos(angle), std::sin(angle)});
    result.loops_.insert(result.loops_.end(), {i, (i + 1) % count});
    result.facets_.push_back({label, 2 * i, 2 * i + 2});
  }
  return result;
}

template <>
ConvexPolytope<3> ConvexPolytope<3>::in_unit_sphere(double tolerance, std::uint32_t label) {
  SphereTriangles triangles = sphere_triangles(tolerance);
  ConvexPolytope result;
  result.corners_ = std::move(triangles.corners);
  for (const auto& triangle : triangles.all) {
    const auto begin = static_cast<std::uint32_t>(result.loops_.size());
    result.loops_.insert(result.loops_.end(), triangle.begin(), triangle.end());
    result.facets_.push_back({label, begin, begin + 3});
  }
  return result;
}

template <int D>
void ConvexPolytope<D>::scale(double factor) {
  for (Point& corner : corners_) {
    for (double& x : corner) x *= factor;
  }
}

template <int D>
void ConvexPolytope<D>::clear() {
  corners_.clear();
  facets_.clear();
  loops_.clear();
}

template <int D>
void ConvexPolytope<D>::cut(const HalfSpace<D>& half_space, std::uint32_t label) {
  excess_.resize(corners_.size());
  bool some_go = false, some_stay = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    excess_[i] = inner(half_space.normal, corners_[i]) - half_space.offset;
    some_go |= excess_[i] > 0.0;
    some_stay |= excess_[i] < 0.0;
  }
  if (!some_go) return;
  if (!some_stay) return clear();
  cut_corners_.clear();
  cut_facets(label);
  take_new_facets();
}

// The new corner's number.
template <int D>
std::uint32_t ConvexPolytope<D>::cut_corner(std::uint32_t stays, std::uint32_t goes) {
  const auto first = static_cast<std::uint32_t>(corners_.size() - cut_corners_.size());
  for (std::uint32_t i = 0; i < cut_corners_.size(); ++i) {
    if (cut_corners_[i].stays == stays && cut_corners_[i].goes == goes) return first + i;
  }
  cut_corners_.push_back({stays, goes, kNone});
  const double share = excess_[stays] / (excess_[stays] - excess_[goes]);
  Point point = corners_[stays];
  for (std::size_t axis = 0; axis < D; ++axis) {
    point[axis] += share * (corners_[goes][axis] - point[axis]);
  }
  corners_.push_back(point);
  return first + static_cast<std::uint32_t>(cut_corners_.size()) - 1;
}

// Ends the facet whose corners are at the end of the new loops.
template <int D>
void ConvexPolytope<D>::add_facet(std::uint32_t label) {
  const std::uint32_t begin = new_facets_.empty() ? 0 : new_facets_.back().end;
  if (new_loops_.size() - begin < std::size_t{D}) {
    new_loops_.resize(begin);  // sides to and fro: those of its neighbours meet
  } else {
    new_facets_.push_back({label, begin, static_cast<std::uint32_t>(new_loops_.size())});
  }
}

// Corners are numbered as the new facets use them first.
template <int D>
void ConvexPolytope<D>::take_new_facets() {
  numbers_.assign(corners_.size(), kNone);
  for (std::uint32_t& corner : new_loops_) {
    if (numbers_[corner] == kNone) {
      numbers_[corner] = static_cast<std::uint32_t>(new_corners_.size());
      new_corners_.push_back(corners_[corner]);
    }
    corner = numbers_[corner];
  }
  corners_.swap(new_corners_);
  facets_.swap(new_facets_);
  loops_.swap(new_loops_);
  new_corners_.clear();
  new_facets_.clear();
  new_loops_.clear();
}

// Sides are in order: where they leave the half-plane, the new one follows.
template <>
void ConvexPolytope<2>::cut_facets(std::uint32_t label) {
  const auto add = [&](std::uint32_t from, std::uint32_t to, std::uint32_t its_label) {
    new_loops_.insert(new_loops_.end(), {from, to});
    add_facet(its_label);
  };
  std::uint32_t left = kNone, first_entered = kNone;
  for (const Facet& side : facets_) {
    const std::uint32_t from = loops_[side.begin], to = loops_[side.begin + 1];
    if (!goes(from) && !goes(to)) add(from, to, side.label);
    if (!goes(from) && goes(to)) {
      left = cut_corner(from, to);
      add(from, left, side.label);
    }
    if (goes(from) && !goes(to)) {
      const std::uint32_t entered = cut_corner(to, from);
      left == kNone ? void(first_entered = entered) : add(left, entered, label);
      left = kNone;
      add(entered, to, side.label);
    }
  }
  if (left != kNone) add(left, first_entered, label);
}

template <>
void ConvexPolytope<3>::cut_facets(std::uint32_t label) {
  for (const Facet& facet : facets_) cut_polygon(facet);
  close(label);
}

template <int D>
void ConvexPolytope<D>::cut_polygon(const Facet& facet) {
  const auto number = [&](std::uint32_t cut) {  // of a new corner among these
    return cut - static_cast<std::uint32_t>(corners_.size() - cut_corners_.size());
  };
  std::uint32_t left = kNone, first_entered = kNone;
  const auto join = [&](std::uint32_t entered) { cut_corners_[number(entered)].next = left; };
  for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
    const std::uint32_t from = loops_[i];
    const std::uint32_t to = loops_[i + 1 < facet.end ? i + 1 : facet.begin];
    if (!goes(from)) new_loops_.push_back(from);
    if (goes(from) == goes(to)) continue;
    const std::uint32_t corner = goes(to) ? cut_corner(from, to) : cut_corner(to, from);
    new_loops_.push_back(corner);
    if (goes(to)) {
      left = corner;
    } else if (left == kNone) {
      first_entered = corner;
    } else {
      join(corner);
    }
  }
  if (first_entered != kNone) join(first_entered);
  add_facet(facet.label);
}

// The loops of new corners.
template <int D>
void ConvexPolytope<D>::close(std::uint32_t label) {
  const auto first = static_cast<std::uint32_t>(corners_.size() - cut_corners_.size());
  for (std::uint32_t start = 0; start < cut_corners_.size(); ++start) {
    if (cut_corners_[start].next == kNone) continue;
    for (std::uint32_t i = start; cut_corners_[i].next != kNone;) {
      new_loops_.push_back(first + i);
      i = std::exchange(cut_corners_[i].next, kNone) - first;
    }
    add_facet(label);
  }
}

template <int D>
void ConvexPolytope<D>::join_corners() {
  double furthest = 0.0;
  for (const Point& corner : corners_) {
    for (const double x : corner) furthest = std::max(furthest, std::abs(x));
  }
  const auto is_short = [&](std::uint32_t a, std::uint32_t b) {
    double longest = 0.0;
    for (const double x : difference(corners_[a], corners_[b])) {
      longest = std::max(longest, std::abs(x));
    }
    return longest <= kJoined * furthest;
  };
  const auto next_of = [&](const Facet& facet, std::uint32_t i) {
    return loops_[i + 1 < facet.end ? i + 1 : facet.begin];
  };
  UnionFind joined(corners_.size());
  for (const Facet& facet : facets_) {
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
      if (is_short(loops_[i], next_of(facet, i))) joined.unite(loops_[i], next_of(facet, i));
    }
  }
  for (const Facet& facet : facets_) {
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
      const std::uint32_t corner = joined.find(loops_[i]);
      if (D == 2 || corner != joined.find(next_of(facet, i))) new_loops_.push_back(corner);
    }
    if (D == 2 && new_loops_.back() == *(new_loops_.end() - 2)) {
      new_loops_.resize(new_loops_.size() - 2);
      continue;
    }
    add_facet(facet.label);
  }
  if (new_facets_.size() <= std::size_t{D}) {
    new_facets_.clear();
    new_loops_.clear();
  }
  take_new_facets();
}

template <>
double ConvexPolytope<2>::volume() const {
  double twice = 0.0;
  for (const Facet& side : facets_) {
    const Point a = difference(corners_[loops_[side.begin]], corners_[0]);
    const Point b = difference(corners_[loops_[side.begin + 1]], corners_[0]);
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

template <>
double ConvexPolytope<3>::volume() const {
  double six_times = 0.0;
  for (const Facet& facet : facets_) {
    const Point a = difference(corners_[loops_[facet.begin]], corners_[0]);
    for (std::uint32_t i = facet.begin + 1; i + 1 < facet.end; ++i) {
      const Point b = difference(corners_[loops_[i]], corners_[0]);
      const Point c = difference(corners_[loops_[i + 1]], corners_[0]);
      six_times += inner(a, cross_product(b, c));
    }
  }
  return six_times / 6;
}

template <>
double ConvexPolytope<2>::area(const Facet& facet) const {
  const Point side = difference(corners_[loops_[facet.begin]], corners_[loops_[facet.begin + 1]]);
  return std::hypot(side[0], side[1]);
}

template <>
double ConvexPolytope<3>::area(const Facet& facet) const {
  const Point& origin = corners_[loops_[facet.begin]];
  Point twice{};
  for (std::uint32_t i = facet.begin + 1; i + 1 < facet.end; ++i) {
    const Point normal = cross_product(difference(corners_[loops_[i]], origin),
                                       difference(corners_[loops_[i + 1]], origin));
    for (std::size_t axis = 0; axis < 3; ++axis) twice[axis] += normal[axis];
  }
  return std::hypot(twice[0], twice[1], twice[2]) / 2;
}

template class ConvexPolytope<2>;
template class ConvexPolytope<3>;

}  // namespace orthoball
