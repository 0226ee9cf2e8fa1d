// SPDX-License-Identifier: MIT
//
// Alternately an exact filtration, which tells the simplices that are missing, and a WitnessProgram
// of all that ever were, which tells weights. What is never missing has no part in the program, so
// it can only be a program with fewer conditions: a solution that misses nothing is the best.
//
// A witness has a margin of a millionth of its simplex, less for sites near to a corner of it, so
// that weights can be rounded to decimals. Where the simplices leave each other hardly any room it
// takes huge weights to make that much of it: then the margin is smaller. Where weights are so fine
// that rounding loses a simplex all the same, it grows.
#include "orthoball/weights/enforced_weights.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/weights/conflicting_simplices.h"
#include "orthoball/weights/reweighted_points.h"
#include "orthoball/weights/witness_program.h"

namespace orthoball {
namespace {

constexpr double kMargin = 1e-6;  // of a diameter squared
constexpr double kLeastMargin = 1e-13, kLargestMargin = 1e-2;
constexpr double kFiner = 100.0;
constexpr double kRounding = 1e-3;       // of the margin
constexpr double kNothing = 1e-4;        // of the total change
constexpr double kNothingOfSize = 1e-5;  // of a diameter squared, in the total change

[[noreturn]] void refuse(std::size_t simplex, const std::string& what) {
  throw InputError(InputError::Reason::wrong_argument, simplex,
                   "simplex " + std::to_string(simplex) + ": " + what);
}

// @throws InputError unless the corners of every simplex are rows that span it.
template <int D>
void check_simplices(const WeightedPoints& points, std::span<const SimplexRows> simplices) {
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    const SimplexRows& rows = simplices[i];
    if (rows.size() < 2 || rows.size() > D + 1) {
      refuse(i, std::to_string(rows.size()) + " rows; there must be 2 to " + std::to_string(D + 1));
    }
    std::vector<double> corners;
    for (const SiteId row : rows) {
      if (row.row() >= points.size()) {
        refuse(i, "row " + std::to_string(row.row()) + " of " + std::to_string(points.size()) +
                      "; rows are counted from 0");
      }
      const auto x = points.coordinates().subspan(std::size_t{D} * row.row(), D);
      corners.insert(corners.end(), x.begin(), x.end());
    }
    const WeightedPoints alone(D, std::move(corners), WeightKind::none, {});
    const int spanned = regular_triangulation<D>(alone, Threads(1)).affine_dimension();
    if (spanned == static_cast<int>(rows.size()) - 1) continue;
    const char* const where[] = {"at one position", "on one line", "in one plane"};
    refuse(i, std::string("its corners lie ") + where[spanned] + "; they must span it");
  }
}

// The lengths that the program is scaled by.
struct Sizes {
  double least, middle;  // of diameters: the least, the geometric mean
};

template <int D>
Sizes sizes_of(const DistinctSites<D>& sites, std::vector<SiteTuple> simplices) {
  std::sort(simplices.begin(), simplices.end());  // so that sums are rounded the same way
  double least = std::numeric_limits<double>::infinity(), logarithms = 0.0;
  for (const SiteTuple& simplex : simplices) {
    const double square = sites.square_diameter(simplex);
    least = std::min(least, square);
    logarithms += std::log(square) / static_cast<double>(simplices.size());
  }
  return {std::sqrt(least), std::exp(logarithms / 2)};
}

template <int D>
class Enforcement {
 public:
  Enforcement(const WeightedPoints& points, std::span<const SimplexRows> simplices, double alpha2,
              Threads threads, std::size_t added)
      : points_(points),
        simplices_(simplices),
        alpha2_(alpha2),
        threads_(threads),
        given_(points.size() - added),
        sites_(points),
        is_free_(sites_.x.size(), true),
        input_unit_(std::pow(10.0, points.decimals().value_or(0))) {
    for (std::size_t row = 0; row < given_; ++row) is_free_[sites_.site_of_row[row]] = false;
    for (const SimplexRows& rows : simplices) {
      SiteTuple corners;
      for (const SiteId row : rows) corners.push_back(sites_.site_of_row[row.row()]);
      std::sort(corners.begin(), corners.end());
      tuples_.push_back(std::move(corners));
    }
    sizes_ = sizes_of(sites_, tuples_);
  }

  EnforcedWeights result() {
    EnforcedWeights result{points_, {}, {}, 0.0, {}};
    if (add_missing(points_)) return result;
    const std::vector<SiteId> hidden_before = hidden_;
    for (double least_margin = 0.0; least_margin <= kLargestMargin;) {
      const Held held = least_held(least_margin);
      if (held.changes.empty()) {
        Conflict conflict = conflicting_simplices<D>(sites_, tuples_);
        if (!conflict.is_proved) break;
        return {points_, {}, {}, 0.0, std::move(conflict.simplices)};
      }
      make(held, result);
      const std::size_t before = active_.size();
      if (add_missing(result.points)) {
        std::set_difference(hidden_.begin(), hidden_.end(), hidden_before.begin(),
                            hidden_before.end(), std::back_inserter(result.hidden));
        return result;
      }
      // Else what the program holds is lost by rounding.
      if (active_.size() == before) least_margin = 10.0 * held.margin;
    }
    throw LimitError("weights that hold the simplices need more digits than doubles have");
  }

 private:
  // Whether nothing is missing; what is becomes active.
  bool add_missing(const WeightedPoints& points) {
    const Filtration<D> filtration(regular_triangulation<D>(points, threads_), threads_);
    const auto hidden = filtration.triangulation().hidden();
    hidden_.assign(hidden.begin(), hidden.end());
    const auto present = are_present<D>(filtration, filtration.index(alpha2_), simplices_);
    for (std::size_t i = 0; i < present.size(); ++i) {
      if (!present[i]) active_.insert(tuples_[i]);
    }
    return std::find(present.begin(), present.end(), false) == present.end();
  }

  struct Held {
    double margin = 0.0;
    std::vector<double> changes{};  // [site]; empty where they cannot be held
  };

  [[nodiscard]] WitnessOptions options(double margin) const {
    return {.unit = sizes_.middle,
            .margin = margin,
            .alpha2 = alpha2_ * input_unit_ * input_unit_,
            .is_free = &is_free_};
  }

  // [site]: with which the active simplices are held; empty where they cannot be.
  [[nodiscard]] std::vector<double> changes_of(const WitnessOptions& options) const {
    WitnessProgram<D> program(sites_, options);
    for (const SiteTuple& simplex : active_) program.add(simplex);
    return program.solve() == Outcome::solved ? program.changes() : std::vector<double>();
  }

  // By the margin, or by a finer one where that changes notably less; by no finer one than
  // `least_margin` if that is not 0.
  [[nodiscard]] Held least_held(double least_margin) const {
    Held best;
    double margin = std::max(kMargin, least_margin);
    do {
      Held finer{margin, changes_of(options(margin))};
      if (!finer.changes.empty()) {
        const bool is_any = !best.changes.empty();
        const double most =
            (1.0 - kNothing) * total(best.changes) - kNothingOfSize * sizes_.middle * sizes_.middle;
        if (is_any && total(finer.changes) >= most) break;
        best = std::move(finer);
      } else if (!best.changes.empty()) {
        break;
      }
      margin /= kFiner;
    } while (margin >= std::max(kLeastMargin, least_margin));
    if (!best.changes.empty()) leave_small_away(options(best.margin), best.changes);
    return best;
  }

  [[nodiscard]] double total(const std::vector<double>& changes) const {
    double sum = 0.0;
    for (std::size_t site = 0; site < changes.size(); ++site) {
      if (!is_free_[site]) sum += std::abs(changes[site]);
    }
    return sum;
  }

  // Small changes may be there only because tangents stand for a curve: leaves those away that cost
  // nothing to leave away.
  void leave_small_away(WitnessOptions options, std::vector<double>& changes) const {
    double largest = 0.0;
    for (std::size_t site = 0; site < changes.size(); ++site) {
      if (!is_free_[site]) largest = std::max(largest, std::abs(changes[site]));
    }
    for (const double share : {0.1, 0.01, 0.001}) {
      std::vector<bool> is_fixed;
      bool is_any = false;
      for (std::size_t site = 0; site < changes.size(); ++site) {
        is_fixed.push_back(!is_free_[site] && std::abs(changes[site]) < share * largest);
        is_any = is_any || (is_fixed.back() && changes[site] != 0.0);
      }
      if (!is_any) return;
      options.is_fixed = &is_fixed;
      auto fewer = changes_of(options);
      if (fewer.empty() || total(fewer) > (1.0 + kNothing) * total(changes)) continue;
      changes = std::move(fewer);
      return;
    }
  }

  // The points with the changed weights.
  void make(const Held& held, EnforcedWeights& result) const {
    const std::vector<double>& changes = held.changes;
    std::vector<NewWeight> weights;
    result.changed.clear();
    for (std::size_t row = 0; row < points_.size(); ++row) {
      const std::uint32_t site = sites_.site_of_row[row];
      if (changes[site] == 0.0) continue;
      const SiteId id(static_cast<std::uint32_t>(row));
      weights.push_back({id, sites_.weight[site] + changes[site]});
      if (row < given_) result.changed.push_back(id);
    }
    result.total_change = total(changes) / input_unit_ / input_unit_;
    const double step = kRounding * held.margin * sizes_.least * sizes_.least;
    result.points = reweighted(points_, decimals_for(points_, step), weights);
  }

  const WeightedPoints& points_;
  std::span<const SimplexRows> simplices_;
  double alpha2_;
  Threads threads_;
  std::size_t given_;  // rows that have a weight
  DistinctSites<D> sites_;
  std::vector<bool> is_free_;      // [site]: has none
  std::vector<SiteTuple> tuples_;  // [simplex]
  double input_unit_;              // in the unit of the arrays
  Sizes sizes_{};                  // of the simplices
  std::set<SiteTuple> active_;     // those that ever were missing
  std::vector<SiteId> hidden_;     // with the weights that were looked at last
};

template <int D>
EnforcedWeights enforced(const WeightedPoints& points, std::span<const SimplexRows> simplices,
                         double alpha2, Threads threads, std::size_t added) {
  check_simplices<D>(points, simplices);
  return Enforcement<D>(points, simplices, alpha2, threads, added).result();
}

}  // namespace

EnforcedWeights enforced_weights(const WeightedPoints& points,
                                 std::span<const SimplexRows> simplices, double alpha2,
                                 Threads threads, std::size_t added) {
  return points.dimension() == 2 ? enforced<2>(points, simplices, alpha2, threads, added)
                                 : enforced<3>(points, simplices, alpha2, threads, added);
}

}  // namespace orthoball
