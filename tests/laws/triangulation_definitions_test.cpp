// SPDX-License-Identifier: MIT
// Regular triangulations of a few sites are what the definitions say.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "generators/cases.h"
#include "matchers/agrees_with_brute_force.h"
#include "oracles/brute_force.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using Sentences = std::vector<std::string>;

template <int D>
Sentences triangulation_differences(const WeightedPoints& points) {
  return matchers::differences(regular_triangulation<D>(points), oracles::brute_force(points));
}

TEST(RegularTriangulationByDefinition, AgreesOnSmallSetsOfEveryFamily) {
  for (const generators::Case& one : generators::cases(36, 1, 12)) {
    const WeightedPoints points = one.points();
    EXPECT_EQ(one.dimension == 2 ? triangulation_differences<2>(points)
                                 : triangulation_differences<3>(points),
              Sentences{})
        << one;
  }
}

TEST(RegularTriangulationByDefinition, AgreesOnSetsOfTwenty) {
  for (const generators::Case& one : generators::cases(1, 18, 22)) {
    const WeightedPoints points = one.points();
    EXPECT_EQ(one.dimension == 2 ? triangulation_differences<2>(points)
                                 : triangulation_differences<3>(points),
              Sentences{})
        << one;
  }
}

}  // namespace
}  // namespace orthoball
