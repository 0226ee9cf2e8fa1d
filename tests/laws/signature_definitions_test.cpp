// SPDX-License-Identifier: MIT
// Signatures of a few sites, at every index, are what the definitions say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "generators/cases.h"
#include "matchers/describe.h"
#include "oracles/brute_force.h"
#include "oracles/measures.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using Sentences = std::vector<std::string>;

// What thin_cell.h and a thin triangle in the plane may cost.
constexpr double kRelativeError = 4e-12;

// Terms are rounded, and the library takes sums of all that came before and subtracts again (in
// pairs of doubles), where the oracle adds what there is. `power` is 3 for a volume, 2 for an area,
// 1 for a length.
void compare_measure(const std::string& what, double actual, const oracles::Measure& expected,
                     int exponent, int power, Sentences& found) {
  const double value = std::ldexp(expected.value, power * exponent);
  if (std::isinf(value) && actual == value) return;
  // Lengths are 1 in the oracle's unit or less, and there are fewer than 1000 terms, each of which
  // may be rounded to a subnormal number.
  const double tolerance =
      std::ldexp(kRelativeError * expected.magnitude + 1e-27, power * exponent) + 0x1p-1066;
  if (std::abs(actual - value) <= tolerance) return;
  found.push_back(what + ": " + matchers::described(actual) + " instead of " +
                  matchers::described(value));
}

template <int D>
void compare_signature(const Signature<D>& actual, const oracles::ExactPoints& points,
                       const oracles::BruteForce& expected, Sentences& found) {
  matchers::Comparison compare(found);
  const std::uint32_t index = actual.index;
  const std::string at = " at index " + std::to_string(index);
  const auto& betti = expected.betti[index];
  compare("betti" + at, std::vector(actual.betti.begin(), actual.betti.end()),
          std::vector(betti.begin(), betti.begin() + D));
  if (D == 2) compare("voids" + at, betti[2], 0U);

  Signature<D> counts;
  for (const oracles::BruteSimplex& simplex : expected.simplices) {
    const auto dimension = static_cast<std::size_t>(simplex.dimension());
    auto& role = index < simplex.enters     ? counts.exterior
                 : index < simplex.regular  ? counts.singular
                 : index < simplex.interior ? counts.regular
                                            : counts.interior;
    ++role[dimension];
    if (index >= simplex.enters) counts.euler += dimension % 2 == 0 ? 1 : -1;
  }
  const auto listed = [](const auto& array) { return std::vector(array.begin(), array.end()); };
  compare("euler" + at, actual.euler, counts.euler);
  compare("exterior" + at, listed(actual.exterior), listed(counts.exterior));
  compare("singular" + at, listed(actual.singular), listed(counts.singular));
  compare("regular" + at, listed(actual.regular), listed(counts.regular));
  compare("interior" + at, listed(actual.interior), listed(counts.interior));

  const oracles::Measures measures = oracles::measures(points, expected, index);
  const int exponent = measures.exponent;
  compare_measure("volume" + at, actual.volume, measures.volume, exponent, D, found);
  compare_measure("area of singular facets" + at, actual.area_singular, measures.area_singular,
                  exponent, D - 1, found);
  compare_measure("area of regular facets" + at, actual.area_regular, measures.area_regular,
                  exponent, D - 1, found);
  compare_measure("area" + at, actual.area, measures.area, exponent, D - 1, found);
  compare_measure("length" + at, actual.length, measures.length, exponent, 1, found);
}

template <int D>
Sentences signature_differences(const WeightedPoints& points) {
  Sentences found;
  const oracles::ExactPoints exact = oracles::exact_points(points);
  const oracles::BruteForce expected = oracles::brute_force(points);
  const Filtration<D> filtration(regular_triangulation<D>(points));
  matchers::Comparison compare(found);

  std::uint32_t visited = 0;
  scan_signatures<D>(filtration, [&](const Signature<D>& signature) {
    compare("index visited", signature.index, ++visited);
    compare("alpha2", signature.alpha2, filtration.alpha2(visited));
    compare_signature(signature, exact, expected, found);
  });
  compare("last index visited", visited, filtration.spectrum_size());

  // The same at single indices, out of order, index 0 among them.
  std::vector<std::uint32_t> indices{filtration.spectrum_size(), 0, filtration.spectrum_size() / 2,
                                     filtration.spectrum_size()};
  const auto chosen = signatures<D>(filtration, indices);
  compare("number of signatures", chosen.size(), indices.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    compare("index", chosen[i].index, indices[i]);
    compare_signature(chosen[i], exact, expected, found);
  }
  return found;
}

TEST(SignatureByDefinition, AgreesOnSmallSetsOfEveryFamily) {
  for (const generators::Case& one : generators::cases(20, 1, 11)) {
    const WeightedPoints points = one.points();
    EXPECT_EQ(
        one.dimension == 2 ? signature_differences<2>(points) : signature_differences<3>(points),
        Sentences{})
        << one;
  }
}

TEST(SignatureByDefinition, AgreesOnNoSites) {
  EXPECT_EQ(signature_differences<2>(WeightedPoints(2)), Sentences{});
  EXPECT_EQ(signature_differences<3>(WeightedPoints(3)), Sentences{});
}

}  // namespace
}  // namespace orthoball
