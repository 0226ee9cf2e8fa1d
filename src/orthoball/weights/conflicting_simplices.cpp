// SPDX-License-Identifier: MIT
//
// The simplices of a contradiction that the solver names are enough for one. From them each is left
// out in turn: if the others contradict each other without it, it is gone for good, and so is what
// their contradiction does not need. What stays is needed, each for itself (a deletion filter).
//
// Chinneck, Dravnieks. Locating minimal infeasible constraint sets in linear programs. ORSA Journal
// on Computing 3 (1991).
#include "orthoball/weights/conflicting_simplices.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/weights/exact_contradiction.h"

namespace orthoball {
namespace {

// Of the same order as the squared heights of the simplices: weights may be of any size, so only
// whether others are above counts.
constexpr double kMargin = 1e-2;
constexpr double kRounding = 1e-9;  // of the largest factor

// Numbers of simplices in a contradiction, each once, but for what is only rounding.
std::vector<std::size_t> with_a_part_in(const std::vector<WitnessCondition>& conditions) {
  double largest = 0.0;
  for (const WitnessCondition& one : conditions) largest = std::max(largest, std::abs(one.factor));
  std::vector<std::size_t> numbers;
  for (const WitnessCondition& one : conditions) {
    if (std::abs(one.factor) > kRounding * largest) numbers.push_back(one.simplex);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

// Simplices among `numbers` that contradict each other, none if all can be held together.
template <int D>
Conflict contradiction(const DistinctSites<D>& sites, std::span<const SiteTuple> simplices,
                       const std::vector<std::size_t>& numbers) {
  std::vector<bool> is_corner(sites.x.size());
  double logarithms = 0.0;
  for (const std::size_t number : numbers) {
    for (const std::uint32_t corner : simplices[number]) is_corner[corner] = true;
    logarithms +=
        std::log(sites.square_diameter(simplices[number])) / static_cast<double>(numbers.size());
  }
  WitnessProgram<D> program(
      sites, {.unit = std::exp(logarithms / 2), .margin = kMargin, .counted = &is_corner});
  for (const std::size_t number : numbers) program.add(simplices[number]);
  const Outcome outcome = program.solve();
  if (outcome == Outcome::solved) return {};
  if (outcome == Outcome::unknown) {
    throw LimitError("the linear program for the simplices that exclude each other is not solved");
  }
  auto conditions = program.contradiction();
  for (WitnessCondition& one : conditions) one.simplex = numbers[one.simplex];
  Conflict conflict{exact_contradiction<D>(sites, simplices, conditions), true};
  if (conflict.simplices.empty()) conflict = {with_a_part_in(conditions), false};
  std::sort(conflict.simplices.begin(), conflict.simplices.end(),
            [&](std::size_t a, std::size_t b) { return simplices[a] < simplices[b]; });
  return conflict;
}

}  // namespace

template <int D>
Conflict conflicting_simplices(const DistinctSites<D>& sites,
                               std::span<const SiteTuple> simplices) {
  std::vector<std::size_t> all(simplices.size());
  std::iota(all.begin(), all.end(), 0);
  std::stable_sort(all.begin(), all.end(),
                   [&](std::size_t a, std::size_t b) { return simplices[a] < simplices[b]; });
  all.erase(std::unique(all.begin(), all.end(),
                        [&](std::size_t a, std::size_t b) { return simplices[a] == simplices[b]; }),
            all.end());
  Conflict kept = contradiction(sites, simplices, all);
  for (const std::size_t one : std::vector<std::size_t>(kept.simplices)) {
    std::vector<std::size_t> others = kept.simplices;
    if (std::erase(others, one) == 0) continue;
    Conflict smaller = contradiction(sites, simplices, others);
    // What is proved is not given up for what is not.
    if (smaller.simplices.empty() || (kept.is_proved && !smaller.is_proved)) continue;
    kept = std::move(smaller);
  }
  std::sort(kept.simplices.begin(), kept.simplices.end());
  return kept;
}

template Conflict conflicting_simplices<2>(const DistinctSites<2>&, std::span<const SiteTuple>);
template Conflict conflicting_simplices<3>(const DistinctSites<3>&, std::span<const SiteTuple>);

}  // namespace orthoball
