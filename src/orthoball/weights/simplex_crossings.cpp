// SPDX-License-Identifier: MIT
#include "orthoball/weights/simplex_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "orthoball/vectors.h"

namespace orthoball {
namespace {

// The factors with which the directions, up to three, sum up to `to`; empty where that is farther
// away than `near`, or they are not independent.
template <int D>
std::optional<std::vector<double>> factors(const std::vector<Place<D>>& directions,
                                           const Place<D>& to, double near) {
  const std::size_t count = directions.size();
  std::vector<std::vector<double>> rows(count, std::vector<double>(count + 1));
  double size = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) rows[i][j] = inner(directions[i], directions[j]);
    rows[i][count] = inner(directions[i], to);
    size = std::max(size, rows[i][i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i; j < count; ++j) {
      if (std::abs(rows[j][i]) > std::abs(rows[pivot][i])) pivot = j;
    }
    std::swap(rows[i], rows[pivot]);
    if (std::abs(rows[i][i]) <= 1e-12 * size) return std::nullopt;
    for (std::size_t j = 0; j < count; ++j) {
      if (j == i) continue;
      const double factor = rows[j][i] / rows[i][i];
      for (std::size_t k = i; k <= count; ++k) rows[j][k] -= factor * rows[i][k];
    }
  }
  std::vector<double> result;
  Place<D> rest = to;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(rows[i][count] / rows[i][i]);
    for (std::size_t axis = 0; axis < D; ++axis) rest[axis] -= result[i] * directions[i][axis];
  }
  if (inner(rest, rest) > near * near) return std::nullopt;
  return result;
}

}  // namespace

template <int D>
Place<D> SimplexCrossings<D>::at(SiteId row) const {
  Place<D> x;
  for (std::size_t axis = 0; axis < D; ++axis) {
    x[axis] = points_.coordinates()[std::size_t{D} * row.row() + axis];
  }
  return x;
}

template <int D>
double SimplexCrossings<D>::square(SiteId a, SiteId b) const {
  const Place<D> along = difference(at(a), at(b));
  return inner(along, along);
}

template <int D>
Place<D> SimplexCrossings<D>::middle(const SimplexRows& simplex) const {
  Place<D> x{};
  for (const SiteId row : simplex) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      x[axis] += at(row)[axis] / static_cast<double>(simplex.size());
    }
  }
  return x;
}

template <int D>
SimplexRows SimplexCrossings<D>::face_around(const SimplexRows& simplex, const Place<D>& x) const {
  std::vector<Place<D>> directions;
  for (const SiteId row : simplex) {
    if (row != simplex[0]) directions.push_back(difference(at(row), at(simplex[0])));
  }
  const auto found = factors<D>(directions, difference(x, at(simplex[0])), near_);
  if (!found) return {};
  std::vector<double> shares{1.0};
  for (const double factor : *found) {
    shares.push_back(factor);
    shares[0] -= factor;
  }
  SimplexRows face;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double from_opposite = shares[i] * height(simplex, i);
    if (from_opposite < -near_) return {};
    if (from_opposite > near_) face.push_back(simplex[i]);
  }
  return face.size() < 2 ? SimplexRows() : face;
}

template <int D>
double SimplexCrossings<D>::height(const SimplexRows& simplex, std::size_t corner) const {
  std::vector<Place<D>> directions;
  std::vector<SiteId> others = simplex;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(corner));
  for (const SiteId row : others) {
    if (row != others[0]) directions.push_back(difference(at(row), at(others[0])));
  }
  Place<D> rest = difference(at(simplex[corner]), at(others[0]));
  const auto found = factors<D>(directions, rest, std::numeric_limits<double>::infinity());
  if (!found) return 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t axis = 0; axis < D; ++axis) rest[axis] -= (*found)[i] * directions[i][axis];
  }
  return std::sqrt(inner(rest, rest));
}

template <int D>
std::optional<SiteId> SimplexCrossings<D>::corner_on_another(
    const std::vector<SimplexRows>& simplices) const {
  for (const SimplexRows& one : simplices) {
    for (const SiteId corner : one) {
      for (const SimplexRows& other : simplices) {
        if (!face_around(other, at(corner)).empty()) return corner;
      }
    }
  }
  return std::nullopt;
}

template <int D>
std::optional<Place<D>> SimplexCrossings<D>::edge_through_another(
    const std::vector<SimplexRows>& simplices) const {
  std::optional<Place<D>> best;
  double longest = 0.0;
  for (const SimplexRows& one : simplices) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      for (std::size_t j = i + 1; j < one.size(); ++j) {
        const double length = square(one[i], one[j]);
        for (const SimplexRows& other : simplices) {
          if (length <= longest) break;
          if (const auto x = crossing(at(one[i]), at(one[j]), other)) {
            best = x;
            longest = length;
          }
        }
      }
    }
  }
  return best;
}

template <int D>
std::optional<Place<D>> SimplexCrossings<D>::crossing(const Place<D>& a, const Place<D>& b,
                                                      const SimplexRows& simplex) const {
  for (unsigned chosen = 1; chosen < 1U << simplex.size(); ++chosen) {
    SimplexRows face;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((chosen >> i & 1U) != 0) face.push_back(simplex[i]);
    }
    if (face.size() < 2 || face.size() > D) continue;
    std::vector<Place<D>> directions{difference(a, b)};
    for (const SiteId row : face) {
      if (row != face[0]) directions.push_back(difference(at(row), at(face[0])));
    }
    const auto found = factors<D>(directions, difference(a, at(face[0])), near_);
    if (!found) continue;
    // So far from the ends that a site near to the point is no end.
    const double end = 2.0 * near_ / std::sqrt(inner(directions[0], directions[0]));
    if ((*found)[0] < end || (*found)[0] > 1.0 - end) continue;
    Place<D> x = a;
    for (std::size_t axis = 0; axis < D; ++axis) x[axis] += (*found)[0] * (b[axis] - a[axis]);
    if (face_around(face, x).size() == face.size()) return x;
  }
  return std::nullopt;
}

template <int D>
std::vector<SimplexRows> SimplexCrossings<D>::meeting(
    const std::vector<SimplexRows>& simplices) const {
  struct Entry {
    double length;  // squared, of the longest edge; less than 0, to be sorted
    std::vector<Place<D>> corners;
    std::size_t number;
    bool operator<(const Entry& other) const {
      return std::tie(length, corners) < std::tie(other.length, other.corners);
    }
  };
  std::vector<Entry> order;
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    Entry entry{0.0, {}, i};
    for (const SiteId a : simplices[i]) {
      entry.corners.push_back(at(a));
      for (const SiteId b : simplices[i]) entry.length = std::min(entry.length, -square(a, b));
    }
    order.push_back(std::move(entry));
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (are_apart(order[i].corners, order[j].corners)) continue;
      std::vector<SimplexRows> two{simplices[order[i].number], simplices[order[j].number]};
      if (corner_on_another(two) || edge_through_another(two)) return two;
    }
  }
  return {};
}

template <int D>
bool SimplexCrossings<D>::are_apart(const std::vector<Place<D>>& one,
                                    const std::vector<Place<D>>& other) const {
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto is_less = [&](const auto& a, const auto& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(one.begin(), one.end(), is_less);
    const auto [from, to] = std::minmax_element(other.begin(), other.end(), is_less);
    if ((*high)[axis] + near_ < (*from)[axis] || (*to)[axis] + near_ < (*low)[axis]) return true;
  }
  return false;
}

template class SimplexCrossings<2>;
template class SimplexCrossings<3>;

}  // namespace orthoball
