// SPDX-License-Identifier: MIT
//
// A simplex is in the alpha complex if and only if there is a point x at which its corners v have
// one power p <= alpha2 and no other site u has less. With q = |x|^2 - p in the place of p
//
//     |v|^2 - w_v - 2 x.v + q  = 0        for its corners,
//     |u|^2 - w_u - 2 x.u + q >= margin   for the others,
//     |x|^2 - q <= alpha2 - margin,
//
// all linear in x, q and the weights w but the last, which is convex: it is replaced by its
// tangents at points where a solution violated it, as many as it takes. Of the conditions on
// others, too, only those enter that a solution violated; all sites are looked at for that, so a
// solution that violates none is one of all conditions. Where these few contradict each other, all
// do. Sites without a condition keep their weights.
//
// Without an alpha2 all weights may be as large as they must: then the margins have any size, or
// none. So there the least is looked for that all margins lack; the prices of the conditions tell
// why it is not 0.
//
// Each change of a weight is the difference of two variables that are not negative, and the cost is
// their sum: the total change. Its least value is found at a corner of the polytope of solutions,
// where few weights change. Lengths are in units of the simplex's diameter, from one of its
// corners.
#include "orthoball/weights/witness_program.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "orthoball/vectors.h"

namespace orthoball {
namespace {

constexpr int kMostRounds = 500;        // of adding what is violated
constexpr std::size_t kMostOthers = 6;  // conditions added for a simplex in one round
constexpr double kNoChange = 1e-9;      // a value of the program that stands for no change
constexpr double kSmallest = 1e-6;      // value of a margin in the program

}  // namespace

template <int D>
WitnessProgram<D>::WitnessProgram(const DistinctSites<D>& sites, const WitnessOptions& options)
    : sites_(sites), options_(options) {
  if (!options.alpha2) lack_ = program_.add_variable(0.0, 1.0);
}

template <int D>
auto WitnessProgram<D>::in_frame(const Witness& witness, std::uint32_t site) const -> Vector {
  Vector y;
  for (std::size_t axis = 0; axis < D; ++axis) {
    y[axis] = (sites_.x[site][axis] - witness.origin[axis]) / witness.diameter;
  }
  return y;
}

// Values in the program are so much larger: a smaller margin is seen as well by the solver, whose
// tolerance is absolute.
template <int D>
double WitnessProgram<D>::magnification() const {
  return std::max(1.0, kSmallest / options_.margin);
}

template <int D>
auto WitnessProgram<D>::change_of(std::uint32_t site) -> Change {
  const auto found = changes_.find(site);
  if (found != changes_.end()) return found->second;
  const bool is_free = options_.is_free != nullptr ? (*options_.is_free)[site] : !options_.alpha2;
  const double cost = is_free ? 0.0 : 1.0;
  const std::size_t plus = program_.add_variable(0.0, cost);
  const Change change{plus, program_.add_variable(0.0, cost)};
  changes_.emplace(site, change);
  return change;
}

template <int D>
double WitnessProgram<D>::change(std::uint32_t site) const {
  const auto found = changes_.find(site);
  if (found == changes_.end()) return 0.0;
  const double change = program_.value(found->second.plus) - program_.value(found->second.minus);
  const double unit = options_.unit * options_.unit / magnification();
  return std::abs(change) < kNoChange ? 0.0 : change * unit;
}

template <int D>
void WitnessProgram<D>::add(const SiteTuple& simplex) {
  Witness witness{simplex, sites_.x[simplex[0]], 1.0, 0, {}};
  const double square = sites_.square_diameter(simplex);
  if (square > 0.0) witness.diameter = std::sqrt(square);
  witness.first_variable = program_.add_variable(-LinearProgram::kInfinity, 0.0);
  for (int i = 0; i < D; ++i) (void)program_.add_variable(-LinearProgram::kInfinity, 0.0);
  const std::size_t number = witnesses_.size();
  witnesses_.push_back(std::move(witness));
  Vector middle{};
  for (const std::uint32_t corner : simplex) {
    add_condition(number, corner, true);
    const Vector y = in_frame(witnesses_[number], corner);
    for (std::size_t axis = 0; axis < D; ++axis) {
      middle[axis] += y[axis] / static_cast<double>(simplex.size());
    }
  }
  if (!options_.alpha2) return;
  add_cut(number, middle);
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (const double step : {-1.0, 1.0}) {
      Vector beside = middle;
      beside[axis] += step;
      add_cut(number, beside);
    }
  }
}

// w_u unit^2 / diameter^2 and so on: in the frame of the witness.
template <int D>
void WitnessProgram<D>::add_condition(std::size_t number, std::uint32_t site, bool is_corner) {
  const bool is_fixed = options_.is_fixed != nullptr && (*options_.is_fixed)[site];
  Witness& witness = witnesses_[number];
  const Vector y = in_frame(witness, site);
  const double square = witness.diameter * witness.diameter;
  const double unit = options_.unit * options_.unit / square;
  std::vector<LinearProgram::Term> terms;
  if (!is_fixed) {
    const Change change = change_of(site);
    terms = {{change.plus, -unit}, {change.minus, unit}};
  }
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (y[axis] != 0.0) terms.push_back({witness.first_variable + axis, -2.0 * y[axis]});
  }
  terms.push_back({witness.first_variable + D, 1.0});
  const double least = (sites_.weight[site] / square - inner(y, y)) * magnification();
  if (is_corner) {
    program_.add_condition(least, least, terms);
  } else {
    if (lack_) terms.push_back({*lack_, 1.0});
    program_.add_condition(least + options_.margin * magnification(), LinearProgram::kInfinity,
                           terms);
    witness.others.push_back(site);
  }
  conditions_.emplace_back(WitnessCondition{number, site, 1.0 / square});
}

// In units in which the larger of its numbers is about 1, for the solver's tolerance.
template <int D>
void WitnessProgram<D>::add_cut(std::size_t number, const Vector& at) {
  const Witness& witness = witnesses_[number];
  const double size = std::max(cut_size(witness), inner(at, at));
  std::vector<LinearProgram::Term> terms;
  for (std::size_t axis = 0; axis < D; ++axis) {
    terms.push_back({witness.first_variable + axis, 2.0 * at[axis] / size});
  }
  terms.push_back({witness.first_variable + D, -1.0 / size});
  const double most = most_power(witness) + inner(at, at);
  program_.add_condition(-LinearProgram::kInfinity, most / size * magnification(), terms);
  conditions_.emplace_back();
}

// alpha2 in the frame of the witness, or 1 where that is more.
template <int D>
double WitnessProgram<D>::cut_size(const Witness& witness) const {
  return std::max(1.0, std::abs(*options_.alpha2) / (witness.diameter * witness.diameter));
}

// Of the corners at the witness: alpha2 less the margin.
template <int D>
double WitnessProgram<D>::most_power(const Witness& witness) const {
  return *options_.alpha2 / (witness.diameter * witness.diameter) -
         options_.margin * cut_size(witness);
}

template <int D>
auto WitnessProgram<D>::place(const Witness& witness) const -> Vector {
  Vector x;
  for (std::size_t axis = 0; axis < D; ++axis)
    x[axis] = program_.value(witness.first_variable + axis) / magnification();
  return x;
}

// Adds what the last solution violates of one simplex; whether there was anything.
template <int D>
bool WitnessProgram<D>::add_violated(std::size_t number, const std::vector<double>& changes) {
  const Witness& witness = witnesses_[number];
  const Vector x = place(witness);
  const double q = program_.value(witness.first_variable + D) / magnification();
  const double square = witness.diameter * witness.diameter;
  bool is_violated = false;
  if (options_.alpha2 &&
      inner(x, x) - q > most_power(witness) + options_.margin / 2 * cut_size(witness)) {
    add_cut(number, x);
    is_violated = true;
  }
  std::vector<std::pair<double, std::uint32_t>> violated;  // by how much
  for (std::uint32_t site = 0; site < sites_.x.size(); ++site) {
    if (options_.counted != nullptr && !(*options_.counted)[site]) continue;
    const Vector y = in_frame(witness, site);
    const double above =
        inner(y, y) - (sites_.weight[site] + changes[site]) / square - 2.0 * inner(x, y) + q;
    if (above >= options_.margin / 2) continue;
    const auto is_in = [&](const auto& list) {
      return std::find(list.begin(), list.end(), site) != list.end();
    };
    if (!is_in(witness.corners) && !is_in(witness.others)) violated.emplace_back(above, site);
  }
  std::sort(violated.begin(), violated.end());
  if (violated.size() > kMostOthers) violated.resize(kMostOthers);
  for (const auto& [above, site] : violated) add_condition(number, site, false);
  return is_violated || !violated.empty();
}

template <int D>
Outcome WitnessProgram<D>::solve() {
  for (int round = 0; round < kMostRounds; ++round) {
    const Outcome outcome = program_.solve();
    if (outcome != Outcome::solved) return outcome;
    if (lack_ && program_.value(*lack_) > options_.margin / 2 * magnification()) {
      return Outcome::infeasible;
    }
    bool is_violated = false;
    const std::vector<double> of_sites = changes();
    for (std::size_t number = 0; number < witnesses_.size(); ++number) {
      if (add_violated(number, of_sites)) is_violated = true;
    }
    if (!is_violated) return Outcome::solved;
  }
  return Outcome::unknown;
}

template <int D>
std::vector<double> WitnessProgram<D>::changes() const {
  std::vector<double> changes(sites_.x.size());
  for (std::uint32_t site = 0; site < changes.size(); ++site) changes[site] = change(site);
  return changes;
}

template <int D>
std::vector<WitnessCondition> WitnessProgram<D>::contradiction() const {
  std::vector<WitnessCondition> named;
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    if (!conditions_[i] || program_.price(i) == 0.0) continue;
    named.push_back(*conditions_[i]);
    named.back().factor *= program_.price(i);
  }
  return named;
}

template class WitnessProgram<2>;
template class WitnessProgram<3>;

}  // namespace orthoball
