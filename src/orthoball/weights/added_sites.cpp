// SPDX-License-Identifier: MIT
//
// One step: of simplices that exclude each other (conflicting_simplices) take a point that two of
// them share and that is a corner of at most one of them: a corner of one on another, otherwise the
// point where an edge of one passes through a face of another. Every simplex on which it lies, of
// all that are wanted, is cut there: if it lies inside the face F, each corner of F in turn gives
// its place to it. In general position, simplices whose edges and faces meet in common faces only
// can still exclude each other in a ring; then one is cut in the middle of an edge, the longest
// that breaks the ring.
//
// Triangles of the plane that overlap would be cut into parts that overlap, on and on. There only
// the edges are cut, and then any regular triangulation that has these fills the triangles.
//
// Cheng, Dey, Shewchuk. Delaunay mesh generation. CRC Press (2012): protecting balls.
#include "orthoball/weights/added_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/vectors.h"
#include "orthoball/weights/conflicting_simplices.h"
#include "orthoball/weights/enforced_weights.h"
#include "orthoball/weights/reweighted_points.h"

namespace orthoball {
namespace {

constexpr double kFine = 1e-8;      // of the shortest edge: where sites are put
constexpr double kOn = 10 * kFine;  // of the shortest edge: so near is on
constexpr std::size_t kMost = 12;   // sites a simplex
constexpr std::size_t kOutline = std::numeric_limits<std::size_t>::max();  // no given simplex

template <int D>
using Vector = std::array<double, std::size_t{D}>;

// The factors with which the directions, up to three, sum up to `to`; empty where that is farther
// away than `near`, or they are not independent.
template <int D>
std::optional<std::vector<double>> factors(const std::vector<Vector<D>>& directions,
                                           const Vector<D>& to, double near) {
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
  Vector<D> rest = to;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(rows[i][count] / rows[i][i]);
    for (std::size_t axis = 0; axis < D; ++axis) rest[axis] -= result[i] * directions[i][axis];
  }
  if (inner(rest, rest) > near * near) return std::nullopt;
  return result;
}

// Points, simplices of them, and how they are cut.
template <int D>
class Cutting {
 public:
  Cutting(const WeightedPoints& points, std::span<const SimplexRows> simplices)
      : points_(points), given_(points.size()) {
    const std::vector<SiteId> rows = heaviest_rows();
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      SimplexRows part;
      for (const SiteId row : simplices[i]) part.push_back(rows[row.row()]);
      parts_.push_back(sorted(std::move(part)));
      part_of_.push_back(i);
    }
    for (const SimplexRows& part : parts_) {
      for (const SiteId a : part) {
        for (const SiteId b : part) {
          if (a != b) least_ = std::min(least_, square(a, b));
        }
      }
    }
    if (!simplices.empty()) {
      points_ = with_more_rows(points, decimals_for(points, kFine * kFine * least_), {});
      const double finer =
          std::pow(10.0, points_.decimals().value_or(0) - points.decimals().value_or(0));
      least_ *= finer * finer;
    }
  }

  AddedSites result() {
    const std::size_t most = kMost * parts_.size();
    while (true) {
      std::vector<SimplexRows> conflict = meeting();
      if (conflict.empty() && !are_held()) conflict = conflicting();
      if (conflict.empty()) break;
      if (outline(conflict)) continue;
      if (const auto corner = corner_on_another(conflict)) {
        cut_at(*corner);
        continue;
      }
      if (points_.size() - given_ == most) {
        throw LimitError(std::to_string(most) +
                         " added sites do not yet let weights hold the simplices; triangles in one "
                         "plane of space that overlap, or tetrahedra, may take any number");
      }
      const auto crossing = edge_through_another(conflict);
      add(crossing ? *crossing : middle_of_an_edge(conflict));
    }
    fill_outlines();
    for (SimplexRows& part : parts_) std::sort(part.begin(), part.end());
    return {points_, points_.size() - given_, parts_, part_of_};
  }

 private:
  [[nodiscard]] Vector<D> at(SiteId row) const {
    Vector<D> x;
    for (std::size_t axis = 0; axis < D; ++axis) {
      x[axis] = points_.coordinates()[std::size_t{D} * row.row() + axis];
    }
    return x;
  }
  // By position, so that nothing depends on the order of rows.
  [[nodiscard]] SimplexRows sorted(SimplexRows part) const {
    std::sort(part.begin(), part.end(), [&](SiteId a, SiteId b) { return at(a) < at(b); });
    return part;
  }
  // [row]: the first row with the largest weight at its position. Of others at one position all but
  // one would have to be hidden.
  [[nodiscard]] std::vector<SiteId> heaviest_rows() const {
    const DistinctSites<D> sites(points_);
    std::vector<SiteId> row_of_site(sites.x.size());
    for (std::size_t row = points_.size(); row-- > 0;) {
      row_of_site[sites.site_of_row[row]] = SiteId(static_cast<std::uint32_t>(row));
    }
    std::vector<SiteId> rows;
    for (std::size_t site : sites.site_of_row) {
      while (site + 1 < sites.x.size() && sites.x[site + 1] == sites.x[site]) ++site;
      rows.push_back(row_of_site[site]);
    }
    return rows;
  }
  [[nodiscard]] double square(SiteId a, SiteId b) const {
    const Vector<D> along = difference(at(a), at(b));
    return inner(along, along);
  }

  // Two parts that meet in more than a face that both have, and so exclude each other, which takes
  // no linear program to see: those with the longest edges, for these cut most. None where no two
  // do.
  [[nodiscard]] std::vector<SimplexRows> meeting() const {
    struct Entry {
      double length;  // squared, of the longest edge; less than 0, to be sorted
      std::vector<Vector<D>> corners;
      std::size_t part;
      bool operator<(const Entry& other) const {
        return std::tie(length, corners) < std::tie(other.length, other.corners);
      }
    };
    std::vector<Entry> order;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      Entry entry{0.0, {}, i};
      for (const SiteId a : parts_[i]) {
        entry.corners.push_back(at(a));
        for (const SiteId b : parts_[i]) entry.length = std::min(entry.length, -square(a, b));
      }
      order.push_back(std::move(entry));
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (are_apart(order[i].corners, order[j].corners)) continue;
        std::vector<SimplexRows> two{parts_[order[i].part], parts_[order[j].part]};
        if (corner_on_another(two) || edge_through_another(two)) return two;
      }
    }
    return {};
  }

  // Along some axis.
  [[nodiscard]] bool are_apart(const std::vector<Vector<D>>& one,
                               const std::vector<Vector<D>>& other) const {
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto is_less = [&](const auto& a, const auto& b) { return a[axis] < b[axis]; };
      const auto [low, high] = std::minmax_element(one.begin(), one.end(), is_less);
      const auto [from, to] = std::minmax_element(other.begin(), other.end(), is_less);
      if ((*high)[axis] + near() < (*from)[axis] || (*to)[axis] + near() < (*low)[axis]) return true;
    }
    return false;
  }

  // Weights for all parts at an alpha2 that leaves them room.
  [[nodiscard]] EnforcedWeights weights() const {
    const double unit = std::pow(10.0, points_.decimals().value_or(0));
    const DistinctSites<D> sites(points_);
    std::vector<std::uint32_t> all(sites.x.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<SimplexRows> parts = parts_;
    for (SimplexRows& part : parts) std::sort(part.begin(), part.end());
    return enforced_weights(points_, parts, sites.square_diameter(all) / unit / unit, Threads(1),
                            points_.size() - given_);
  }

  // Finding weights is much faster than showing why there are none.
  [[nodiscard]] bool are_held() const {
    try {
      return weights().conflict.empty();
    } catch (const LimitError&) {  // they leave each other hardly any room
      return false;
    }
  }

  // Some parts that exclude each other, in an order that does not depend on that of rows.
  [[nodiscard]] std::vector<SimplexRows> conflicting() const {
    const DistinctSites<D> sites(points_);
    std::vector<SiteTuple> tuples;
    for (const SimplexRows& part : parts_) {
      SiteTuple corners;
      for (const SiteId row : part) corners.push_back(sites.site_of_row[row.row()]);
      std::sort(corners.begin(), corners.end());
      tuples.push_back(std::move(corners));
    }
    // Also those that leave each other hardly any room: weights for that would be huge.
    std::vector<std::size_t> numbers = conflicting_simplices<D>(sites, tuples).simplices;
    std::sort(numbers.begin(), numbers.end(),
              [&](std::size_t a, std::size_t b) { return tuples[a] < tuples[b]; });
    std::vector<SimplexRows> conflict;
    for (const std::size_t number : numbers) conflict.push_back(parts_[number]);
    return conflict;
  }

  // In the plane: has the edges of triangles among these in their place; whether there were any.
  bool outline(const std::vector<SimplexRows>& conflict) {
    if (D != 2) return false;
    const auto is_meant = [&](const SimplexRows& part) {
      return part.size() == 3 &&
             std::find(conflict.begin(), conflict.end(), part) != conflict.end();
    };
    const std::size_t before = outlined_.size();
    for (std::size_t i = 0; i < parts_.size();) {
      if (!is_meant(parts_[i])) {
        ++i;
        continue;
      }
      const SimplexRows triangle = parts_[i];
      outlined_.emplace_back(triangle, part_of_[i]);
      parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
      part_of_.erase(part_of_.begin() + static_cast<std::ptrdiff_t>(i));
      for (std::size_t left_out = 0; left_out < 3; ++left_out) {
        SimplexRows edge = triangle;
        edge.erase(edge.begin() + static_cast<std::ptrdiff_t>(left_out));
        parts_.push_back(std::move(edge));
        part_of_.push_back(kOutline);
      }
    }
    return outlined_.size() > before;
  }

  // The triangles of one regular triangulation that fill outlined ones, in the place of outlines.
  void fill_outlines() {
    if (outlined_.empty()) return;
    const EnforcedWeights weights = this->weights();
    if (!weights.conflict.empty()) {
      throw LimitError(
          "triangles that share area are cut along their edges, but weights that hold "
          "the pieces need more digits than doubles have");
    }
    for (std::size_t i = parts_.size(); i-- > 0;) {
      if (part_of_[i] != kOutline) continue;
      parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
      part_of_.erase(part_of_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const Filtration<D> filtration(regular_triangulation<D>(weights.points));
    for (std::uint32_t number = 0; number < filtration.size(); ++number) {
      const SimplexId simplex(number);
      if (filtration.dimension(simplex) != 2) continue;
      const auto rows = filtration.rows(simplex);
      const SimplexRows cell(rows.begin(), rows.end());
      for (const auto& [triangle, of] : outlined_) {
        if (face_around(triangle, middle(cell)).size() < 3) continue;
        parts_.push_back(cell);
        part_of_.push_back(of);
      }
    }
  }

  [[nodiscard]] Vector<D> middle(const SimplexRows& simplex) const {
    Vector<D> x{};
    for (const SiteId row : simplex) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        x[axis] += at(row)[axis] / static_cast<double>(simplex.size());
      }
    }
    return x;
  }

  // The corners of the face of a simplex inside which a point lies; empty where it is not on it, or
  // at a corner.
  [[nodiscard]] SimplexRows face_around(const SimplexRows& simplex, const Vector<D>& x) const {
    std::vector<Vector<D>> directions;
    for (const SiteId row : simplex) {
      if (row != simplex[0]) directions.push_back(difference(at(row), at(simplex[0])));
    }
    const auto found = factors<D>(directions, difference(x, at(simplex[0])), near());
    if (!found) return {};
    std::vector<double> shares{1.0};
    for (const double factor : *found) {
      shares.push_back(factor);
      shares[0] -= factor;
    }
    SimplexRows face;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double from_opposite = shares[i] * height(simplex, i);
      if (from_opposite < -near()) return {};
      if (from_opposite > near()) face.push_back(simplex[i]);
    }
    return face.size() < 2 ? SimplexRows() : face;
  }

  // The distance of a corner from the span of the others.
  [[nodiscard]] double height(const SimplexRows& simplex, std::size_t corner) const {
    std::vector<Vector<D>> directions;
    std::vector<SiteId> others = simplex;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(corner));
    for (const SiteId row : others) {
      if (row != others[0]) directions.push_back(difference(at(row), at(others[0])));
    }
    Vector<D> rest = difference(at(simplex[corner]), at(others[0]));
    const auto found = factors<D>(directions, rest, std::numeric_limits<double>::infinity());
    if (!found) return 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      for (std::size_t axis = 0; axis < D; ++axis) rest[axis] -= (*found)[i] * directions[i][axis];
    }
    return std::sqrt(inner(rest, rest));
  }

  // What is so near to a simplex is on it: more than what rounding moves sites.
  [[nodiscard]] double near() const { return kOn * std::sqrt(least_); }

  [[nodiscard]] std::optional<SiteId> corner_on_another(
      const std::vector<SimplexRows>& conflict) const {
    for (const SimplexRows& one : conflict) {
      for (const SiteId corner : one) {
        for (const SimplexRows& other : conflict) {
          if (!face_around(other, at(corner)).empty()) return corner;
        }
      }
    }
    return std::nullopt;
  }

  // Where an edge of one meets an edge or triangle of another, inside of both: the longest edge,
  // for those of given simplices are longer than those that cut them.
  [[nodiscard]] std::optional<Vector<D>> edge_through_another(
      const std::vector<SimplexRows>& conflict) const {
    std::optional<Vector<D>> best;
    double longest = 0.0;
    for (const SimplexRows& one : conflict) {
      for (std::size_t i = 0; i < one.size(); ++i) {
        for (std::size_t j = i + 1; j < one.size(); ++j) {
          const double length = square(one[i], one[j]);
          for (const SimplexRows& other : conflict) {
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

  // Where the edge from a to b passes through a face of at most D corners.
  [[nodiscard]] std::optional<Vector<D>> crossing(const Vector<D>& a, const Vector<D>& b,
                                                  const SimplexRows& simplex) const {
    for (unsigned chosen = 1; chosen < 1U << simplex.size(); ++chosen) {
      SimplexRows face;
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        if ((chosen >> i & 1U) != 0) face.push_back(simplex[i]);
      }
      if (face.size() < 2 || face.size() > D) continue;
      std::vector<Vector<D>> directions{difference(a, b)};
      for (const SiteId row : face) {
        if (row != face[0]) directions.push_back(difference(at(row), at(face[0])));
      }
      const auto found = factors<D>(directions, difference(a, at(face[0])), near());
      if (!found) continue;
      // So far from the ends that a site near to the point is no end.
      const double end = 2.0 * near() / std::sqrt(inner(directions[0], directions[0]));
      if ((*found)[0] < end || (*found)[0] > 1.0 - end) continue;
      Vector<D> x = a;
      for (std::size_t axis = 0; axis < D; ++axis) x[axis] += (*found)[0] * (b[axis] - a[axis]);
      if (face_around(face, x).size() == face.size()) return x;
    }
    return std::nullopt;
  }

  // The middle of the longest edge that, cut there, frees these simplices from each other; of the
  // longest of all where none does.
  [[nodiscard]] Vector<D> middle_of_an_edge(const std::vector<SimplexRows>& conflict) const {
    std::vector<std::pair<double, Vector<D>>> middles;  // with the length squared
    for (const SimplexRows& simplex : conflict) {
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        for (std::size_t j = i + 1; j < simplex.size(); ++j) {
          middles.emplace_back(square(simplex[i], simplex[j]), middle({simplex[i], simplex[j]}));
        }
      }
    }
    std::sort(middles.rbegin(), middles.rend());
    for (const auto& [length, x] : middles) {
      Cutting trial = *this;
      trial.parts_ = conflict;
      trial.part_of_.assign(conflict.size(), 0);
      trial.add(x);
      if (trial.conflicting().empty()) return x;
    }
    return middles[0].second;
  }

  // Adds a site and cuts what it lies on; takes one that is there already instead.
  void add(const Vector<D>& x) {
    for (std::uint32_t row = 0; row < points_.size(); ++row) {
      const Vector<D> away = difference(at(SiteId(row)), x);
      if (inner(away, away) <= near() * near() / 4) return cut_at(SiteId(row));
    }
    std::array<double, 3> position{};
    std::copy(x.begin(), x.end(), position.begin());
    points_ = with_more_rows(points_, 0, {&position, 1});
    cut_at(SiteId(static_cast<std::uint32_t>(points_.size() - 1)));
  }

  // Cuts all parts on which a row lies.
  void cut_at(SiteId row) {
    std::vector<SimplexRows> parts;
    std::vector<std::size_t> part_of;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const SimplexRows face = face_around(parts_[i], at(row));
      if (face.empty()) {
        parts.push_back(parts_[i]);
        part_of.push_back(part_of_[i]);
      }
      for (const SiteId corner : face) {
        SimplexRows part = parts_[i];
        std::replace(part.begin(), part.end(), corner, row);
        parts.push_back(sorted(std::move(part)));
        part_of.push_back(part_of_[i]);
      }
    }
    if (parts.size() == parts_.size()) {
      throw LimitError(
          "simplices that exclude each other meet too near to a site to be cut there: nearer than "
          "sites can be put");
    }
    parts_ = std::move(parts);
    part_of_ = std::move(part_of);
  }

  WeightedPoints points_;
  std::size_t given_;
  double least_ = std::numeric_limits<double>::infinity();  // squared length of an edge
  std::vector<SimplexRows> parts_;                          // corners by position
  std::vector<std::size_t> part_of_;
  std::vector<std::pair<SimplexRows, std::size_t>> outlined_;  // triangles, of which given ones
};

}  // namespace

AddedSites with_added_sites(const WeightedPoints& points, std::span<const SimplexRows> simplices) {
  return points.dimension() == 2 ? Cutting<2>(points, simplices).result()
                                 : Cutting<3>(points, simplices).result();
}

}  // namespace orthoball
