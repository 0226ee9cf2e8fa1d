// SPDX-License-Identifier: MIT
// Filtrations of a few sites are what the definitions say: triangulation, attached simplices, the
// exact spectrum, three indices of every simplex and its place in the filter.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "generators/cases.h"
#include "matchers/agrees_with_brute_force.h"
#include "oracles/brute_force.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using Sentences = std::vector<std::string>;

Sentences filtration_differences(const WeightedPoints& points) {
  const oracles::BruteForce expected = oracles::brute_force(points);
  return points.dimension() == 2
             ? matchers::differences(Filtration<2>(regular_triangulation<2>(points)), expected)
             : matchers::differences(Filtration<3>(regular_triangulation<3>(points)), expected);
}

TEST(FiltrationByDefinition, AgreesOnSmallSetsOfEveryFamily) {
  for (const generators::Case& one : generators::cases(36, 1, 12)) {
    EXPECT_EQ(filtration_differences(one.points()), Sentences{}) << one;
  }
}

TEST(FiltrationByDefinition, AgreesOnSetsOfTwenty) {
  for (const generators::Case& one : generators::cases(1, 18, 22)) {
    EXPECT_EQ(filtration_differences(one.points()), Sentences{}) << one;
  }
}

TEST(FiltrationByDefinition, AgreesOnNoSites) {
  EXPECT_EQ(filtration_differences(WeightedPoints(2)), Sentences{});
  EXPECT_EQ(filtration_differences(WeightedPoints(3)), Sentences{});
}

}  // namespace
}  // namespace orthoball
