// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filter_steps.h"

#include <gtest/gtest.h>

#include "generators/cases.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

TEST(FilterSteps, CutTheFilterWhereTheIndexChanges) {
  for (const generators::Case& one : generators::cases(1, 1, 30)) {
    if (one.dimension != 3) continue;
    const Filtration<3> filtration(regular_triangulation<3>(one.points()));
    FilterSteps<3> steps(filtration);
    std::size_t position = 0;
    while (steps.next()) {
      ByDimension<3> counted{};
      for (; position < steps.end(); ++position) {
        const SimplexId simplex = filtration.filter()[position];
        EXPECT_EQ(filtration.enters(simplex), steps.index()) << one;
        ++counted[static_cast<std::size_t>(filtration.dimension(simplex))];
      }
      EXPECT_EQ(steps.entering(), counted) << one;
      EXPECT_EQ(steps.end(), filtration.complex_size(steps.index())) << one;
    }
    EXPECT_EQ(steps.index(), filtration.spectrum_size()) << one;
    EXPECT_EQ(position, filtration.size()) << one;
  }
}

TEST(FilterSteps, HaveNoneWithoutSites) {
  const Filtration<2> filtration;
  FilterSteps<2> steps(filtration);
  EXPECT_FALSE(steps.next());
  EXPECT_EQ(steps.index(), 0U);
}

}  // namespace
}  // namespace orthoball
