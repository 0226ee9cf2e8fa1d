// SPDX-License-Identifier: MIT
//
// One step: of two simplices that are seen to meet (SimplexCrossings), or of some that exclude each
// other otherwise (conflicting_simplices), take a point that two of them share and that is a corner
// of at most one of them: a corner of one on another, otherwise the point where an edge of one
// passes through a face of another. Every simplex on which it lies, of
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
#include <utility>

#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/vectors.h"
#include "orthoball/weights/conflicting_simplices.h"
#include "orthoball/weights/enforced_weights.h"
#include "orthoball/weights/reweighted_points.h"
#include "orthoball/weights/simplex_crossings.h"

namespace orthoball {
namespace {

constexpr double kFine = 1e-8;      // of the shortest edge: where sites are put
constexpr double kOn = 10 * kFine;  // of the shortest edge: so near is on
constexpr std::size_t kMost = 12;   // sites a simplex
constexpr std::size_t kOutline = std::numeric_limits<std::size_t>::max();  // no given simplex

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
          if (a != b) least_ = std::min(least_, places().square(a, b));
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
    std::optional<EnforcedWeights> held;
    while (true) {
      std::vector<SimplexRows> conflict = places().meeting(parts_);
      // Finding weights is much faster than showing why there are none.
      if (conflict.empty()) {
        held = weights();
        if (!held) conflict = conflicting();
      }
      if (conflict.empty()) break;
      if (outline(conflict)) continue;
      if (const auto corner = places().corner_on_another(conflict)) {
        cut_at(*corner);
        continue;
      }
      if (points_.size() - given_ == most) {
        throw LimitError(std::to_string(most) +
                         " added sites do not yet let weights hold the simplices; triangles in one "
                         "plane of space that overlap, or tetrahedra, may take any number");
      }
      const auto crossing = places().edge_through_another(conflict);
      add(crossing ? *crossing : middle_of_an_edge(conflict));
    }
    if (!outlined_.empty()) fill_outlines(held);
    for (SimplexRows& part : parts_) std::sort(part.begin(), part.end());
    return {points_, points_.size() - given_, parts_, part_of_};
  }

 private:
  // What is so near to a simplex is on it: more than what rounding moves sites.
  [[nodiscard]] SimplexCrossings<D> places() const {
    return SimplexCrossings<D>(points_, kOn * std::sqrt(least_));
  }

  // By position, so that nothing depends on the order of rows.
  [[nodiscard]] SimplexRows sorted(SimplexRows part) const {
    const SimplexCrossings<D> places = this->places();
    std::sort(part.begin(), part.end(),
              [&](SiteId a, SiteId b) { return places.at(a) < places.at(b); });
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

  // With which all parts are held, at an alpha2 that leaves them room; none where there are none.
  [[nodiscard]] std::optional<EnforcedWeights> weights() const {
    const double unit = std::pow(10.0, points_.decimals().value_or(0));
    const DistinctSites<D> sites(points_);
    std::vector<std::uint32_t> all(sites.x.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<SimplexRows> parts = parts_;
    for (SimplexRows& part : parts) std::sort(part.begin(), part.end());
    try {
      EnforcedWeights found =
          enforced_weights(points_, parts, sites.square_diameter(all) / unit / unit, Threads(1),
                           points_.size() - given_);
      if (found.conflict.empty()) return found;
    } catch (const LimitError&) {  // the parts leave each other hardly any room
    }
    return std::nullopt;
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
  void fill_outlines(const std::optional<EnforcedWeights>& held) {
    if (!held) {
      throw LimitError(
          "triangles that share area are cut along their edges, but weights that hold "
          "the pieces need more digits than doubles have");
    }
    for (std::size_t i = parts_.size(); i-- > 0;) {
      if (part_of_[i] != kOutline) continue;
      parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
      part_of_.erase(part_of_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const Filtration<D> filtration(regular_triangulation<D>(held->points));
    for (std::uint32_t number = 0; number < filtration.size(); ++number) {
      const SimplexId simplex(number);
      if (filtration.dimension(simplex) != 2) continue;
      const auto rows = filtration.rows(simplex);
      const SimplexRows cell(rows.begin(), rows.end());
      for (const auto& [triangle, of] : outlined_) {
        if (places().face_around(triangle, places().middle(cell)).size() < 3) continue;
        parts_.push_back(cell);
        part_of_.push_back(of);
      }
    }
  }

  // The middle of the longest edge that, cut there, frees these simplices from each other; of the
  // longest of all where none does.
  [[nodiscard]] Place<D> middle_of_an_edge(const std::vector<SimplexRows>& conflict) const {
    std::vector<std::pair<double, Place<D>>> middles;  // with the length squared
    for (const SimplexRows& simplex : conflict) {
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        for (std::size_t j = i + 1; j < simplex.size(); ++j) {
          middles.emplace_back(places().square(simplex[i], simplex[j]),
                               places().middle({simplex[i], simplex[j]}));
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
  void add(const Place<D>& x) {
    for (std::uint32_t row = 0; row < points_.size(); ++row) {
      const Place<D> away = difference(places().at(SiteId(row)), x);
      if (inner(away, away) <= places().near() * places().near() / 4) return cut_at(SiteId(row));
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
      const SimplexRows face = places().face_around(parts_[i], places().at(row));
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
