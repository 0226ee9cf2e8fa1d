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

namespace orthoball {
namespace {

// Of the same order as the squared heights of the simplices: weights may be of any size, so only
// whether others are above counts.
constexpr double kMargin = 1e-2;

// The simplices among `numbers` that contradict each other, none if these can be held together.
template <int D>
std::vector<std::size_t> contradiction(const DistinctSites<D>& sites,
                                       std::span<const SiteTuple> simplices,
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
  if (program.solve()) return {};
  std::vector<std::size_t> named;
  for (const std::size_t i : program.contradiction()) named.push_back(numbers[i]);
  return named;
}

}  // namespace

template <int D>
std::vector<std::size_t> conflicting_simplices(const DistinctSites<D>& sites,
                                               std::span<const SiteTuple> simplices) {
  std::vector<std::size_t> all(simplices.size());
  std::iota(all.begin(), all.end(), 0);
  std::stable_sort(all.begin(), all.end(),
                   [&](std::size_t a, std::size_t b) { return simplices[a] < simplices[b]; });
  all.erase(std::unique(all.begin(), all.end(),
                        [&](std::size_t a, std::size_t b) { return simplices[a] == simplices[b]; }),
            all.end());
  std::vector<std::size_t> kept = contradiction(sites, simplices, all);
  for (std::size_t needed = 0; needed < kept.size();) {
    std::vector<std::size_t> others = kept;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(needed));
    auto smaller = contradiction(sites, simplices, others);
    if (smaller.empty()) {
      ++needed;
    } else {
      kept = std::move(smaller);  // has all that were found needed, in their order
    }
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

template std::vector<std::size_t> conflicting_simplices<2>(const DistinctSites<2>&,
                                                           std::span<const SiteTuple>);
template std::vector<std::size_t> conflicting_simplices<3>(const DistinctSites<3>&,
                                                           std::span<const SiteTuple>);

}  // namespace orthoball
