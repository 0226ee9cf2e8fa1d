// SPDX-License-Identifier: MIT
//
// A simplex is in the alpha complex if and only if there is a point x at which its corners v have
// one power p <= alpha2 and no other site u has less. The power of a site less that of another,
//
//     |u|^2 - w_u - |v|^2 + w_v - 2 x.(u - v),
//
// is linear in x and the weights w, and is to be 0 from corner to corner, and the margin or more
// from a corner to any other site. Each such condition is written for the step from the nearest
// corner and divided by the square of its length, or of the diameter where that is less: so sites
// close to a corner of a large simplex, which small ones share, have conditions of their own size.
//
// That |x - v|^2 - w_v <= alpha2 is convex: it is replaced by its tangents at points where a
// solution violated it, as many as it takes. Of the conditions on others, too, only those enter
// that a solution violated; all sites are looked at for that, so a solution that violates none is
// one of all conditions. Where these few contradict each other, all do. Sites without a condition
// keep their weights.
//
// Without an alpha2 all weights may be as large as they must: then the margins have any size, or
// none. So there the least is looked for that all margins lack; the prices of the conditions tell
// why it is not 0.
//
// Each change of a weight is the difference of two variables that are not negative, and the cost is
// their sum: the total change. Its least value is found at a corner of the polytope of solutions,
// where few weights change. Lengths are in units of the simplex's diameter, from its first corner.
#include "orthoball/weights/witness_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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
auto WitnessProgram<D>::in_frame(const Witness& witness, std::uint32_t from, std::uint32_t to) const
    -> Vector {
  Vector y;
  for (std::size_t axis = 0; axis < D; ++axis) {
    y[axis] = (sites_.x[to][axis] - sites_.x[from][axis]) / witness.diameter;
  }
  return y;
}

// From the nearest of some corners.
template <int D>
auto WitnessProgram<D>::step_to(const Witness& witness, std::uint32_t site,
                                std::span<const std::uint32_t> corners) const -> Step {
  Step best{};
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t corner : corners) {
    const Vector along = in_frame(witness, corner, site);
    const double square = inner(along, along);
    if (square >= least) continue;
    least = square;
    best = {corner, site, along, square > 0.0 ? std::min(square, 1.0) : 1.0};
  }
  return best;
}

// Values in the program are so much larger: a smaller margin is seen as well by the solver, whose
// tolerance is absolute.
template <int D>
double WitnessProgram<D>::magnification() const {
  return std::max(1.0, kSmallest / options_.margin);
}

template <int D>
auto WitnessProgram<D>::change_of(std::uint32_t site, double square) -> Change {
  const auto found = changes_.find(site);
  if (found != changes_.end()) {
    found->second.least_square = std::min(found->second.least_square, square);
    return found->second;
  }
  const bool is_free = options_.is_free != nullptr ? (*options_.is_free)[site] : !options_.alpha2;
  const double cost = is_free ? 0.0 : 1.0;
  const std::size_t plus = program_.add_variable(0.0, cost);
  const Change change{plus, program_.add_variable(0.0, cost), square};
  changes_.emplace(site, change);
  return change;
}

template <int D>
double WitnessProgram<D>::change(std::uint32_t site) const {
  const auto found = changes_.find(site);
  if (found == changes_.end()) return 0.0;
  const double unit = options_.unit * options_.unit / magnification();
  const double change =
      (program_.value(found->second.plus) - program_.value(found->second.minus)) * unit;
  const double least = kNoChange * std::min(unit, found->second.least_square);
  return std::abs(change) < least ? 0.0 : change;
}

// The change of a site's weight, in the sites' unit squared, times a factor; `square`: of the step.
template <int D>
void WitnessProgram<D>::add_change(std::vector<LinearProgram::Term>& terms, std::uint32_t site,
                                   double factor, double square) {
  if (options_.is_fixed != nullptr && (*options_.is_fixed)[site]) return;
  const Change change = change_of(site, square);
  const double unit = options_.unit * options_.unit;
  terms.push_back({change.plus, factor * unit});
  terms.push_back({change.minus, -factor * unit});
}

template <int D>
void WitnessProgram<D>::add(const SiteTuple& simplex) {
  Witness witness{simplex, 1.0, 0, {}};
  const double square = sites_.square_diameter(simplex);
  if (square > 0.0) witness.diameter = std::sqrt(square);
  witness.first_variable = program_.add_variable(-LinearProgram::kInfinity, 0.0);
  for (int i = 1; i < D; ++i) (void)program_.add_variable(-LinearProgram::kInfinity, 0.0);
  const std::size_t number = witnesses_.size();
  witnesses_.push_back(witness);
  // From each corner, beginning with the first, a step to the nearest of the rest.
  SiteTuple reached{simplex[0]}, rest(simplex.begin() + 1, simplex.end());
  while (!rest.empty()) {
    Step next = step_to(witness, rest[0], reached);
    for (const std::uint32_t corner : rest) {
      const Step other = step_to(witness, corner, reached);
      if (other.square < next.square) next = other;
    }
    add_condition(number, next, true);
    reached.push_back(next.to);
    std::erase(rest, next.to);
  }
  if (!options_.alpha2) return;
  Vector middle{};
  for (const std::uint32_t corner : simplex) {
    const Vector y = in_frame(witness, simplex[0], corner);
    for (std::size_t axis = 0; axis < D; ++axis) {
      middle[axis] += y[axis] / static_cast<double>(simplex.size());
    }
  }
  add_cut(number, middle);
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (const double step : {-1.0, 1.0}) {
      Vector beside = middle;
      beside[axis] += step;
      add_cut(number, beside);
    }
  }
}

// The condition on the site less that on the corner, in units of the step's square.
template <int D>
void WitnessProgram<D>::add_condition(std::size_t number, const Step& step, bool is_corner) {
  Witness& witness = witnesses_[number];
  const double square = witness.diameter * witness.diameter * step.square;
  std::vector<LinearProgram::Term> terms;
  add_change(terms, step.to, -1.0 / square, square);
  add_change(terms, step.from, 1.0 / square, square);
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (step.along[axis] == 0.0) continue;
    terms.push_back({witness.first_variable + axis, -2.0 * step.along[axis] / step.square});
  }
  const Vector from = in_frame(witness, witness.corners[0], step.from);
  const double least =
      ((sites_.weight[step.to] - sites_.weight[step.from]) / square -
       (inner(step.along, step.along) + 2.0 * inner(from, step.along)) / step.square) *
      magnification();
  if (is_corner) {
    program_.add_condition(least, least, terms);
  } else {
    if (lack_) terms.push_back({*lack_, 1.0});
    program_.add_condition(least + options_.margin * magnification(), LinearProgram::kInfinity,
                           terms);
    witness.others.push_back(step.to);
  }
  conditions_.emplace_back(std::pair(number, step));
}

// In units in which the larger of its numbers is about 1, for the solver's tolerance.
template <int D>
void WitnessProgram<D>::add_cut(std::size_t number, const Vector& at) {
  const Witness& witness = witnesses_[number];
  const double size = cut_size(witness, at);
  std::vector<LinearProgram::Term> terms;
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (at[axis] != 0.0) terms.push_back({witness.first_variable + axis, 2.0 * at[axis] / size});
  }
  const std::uint32_t origin = witness.corners[0];
  const double square = witness.diameter * witness.diameter;
  add_change(terms, origin, -1.0 / (square * size), square);
  const double most = *options_.alpha2 / square - options_.margin * size + inner(at, at) +
                      sites_.weight[origin] / square;
  program_.add_condition(-LinearProgram::kInfinity, most / size * magnification(), terms);
  conditions_.emplace_back();
}

// The largest of the numbers of a cut: of alpha2 in the frame, 1, and the square of its place.
template <int D>
double WitnessProgram<D>::cut_size(const Witness& witness, const Vector& at) const {
  const double square = witness.diameter * witness.diameter;
  return std::max({1.0, std::abs(*options_.alpha2) / square, inner(at, at)});
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
  const double square = witness.diameter * witness.diameter;
  const std::uint32_t origin = witness.corners[0];
  const double power = inner(x, x) - (sites_.weight[origin] + changes[origin]) / square;
  bool is_violated = false;
  if (options_.alpha2 &&
      power > *options_.alpha2 / square - options_.margin / 2 * cut_size(witness, x)) {
    add_cut(number, x);
    is_violated = true;
  }
  std::vector<std::pair<double, std::uint32_t>> violated;  // by how much
  for (std::uint32_t site = 0; site < sites_.x.size(); ++site) {
    if (options_.counted != nullptr && !(*options_.counted)[site]) continue;
    const Step step = step_to(witness, site, witness.corners);
    const Vector beyond = difference(in_frame(witness, origin, step.from), x);
    const double weight =
        sites_.weight[site] - sites_.weight[step.from] + (changes[site] - changes[step.from]);
    const double above =
        (inner(step.along, step.along) + 2.0 * inner(beyond, step.along) - weight / square) /
        step.square;
    if (above >= options_.margin / 2) continue;
    const auto is_in = [&](const auto& list) {
      return std::find(list.begin(), list.end(), site) != list.end();
    };
    if (!is_in(witness.corners) && !is_in(witness.others)) violated.emplace_back(above, site);
  }
  std::sort(violated.begin(), violated.end());
  if (violated.size() > kMostOthers) violated.resize(kMostOthers);
  for (const auto& [above, site] : violated) {
    add_condition(number, step_to(witnesses_[number], site, witnesses_[number].corners), false);
  }
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
  std::map<std::pair<std::size_t, std::uint32_t>, double> factors;  // of simplex and site
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    if (!conditions_[i] || program_.price(i) == 0.0) continue;
    const auto& [number, step] = *conditions_[i];
    const Witness& witness = witnesses_[number];
    for (const std::uint32_t corner : witness.corners) factors[{number, corner}] += 0.0;
    const double factor = program_.price(i) / (witness.diameter * witness.diameter * step.square);
    factors[{number, step.to}] += factor;
    factors[{number, step.from}] -= factor;
  }
  std::vector<WitnessCondition> named;
  for (const auto& [of, factor] : factors) named.push_back({of.first, of.second, factor});
  return named;
}

template class WitnessProgram<2>;
template class WitnessProgram<3>;

}  // namespace orthoball
