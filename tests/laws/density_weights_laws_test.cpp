// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "generators/cases.h"
#include "generators/point_families.h"
#include "orthoball/error.h"
#include "orthoball/points/density_weights.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
std::size_t hidden_count(const WeightedPoints& points) {
  return regular_triangulation<D>(points).hidden().size();
}

TEST(DensityWeights, HideNoSite) {
  std::size_t weighted_inputs = 0;
  for (const auto& one : generators::cases(3, 30, 300)) {
    if (generators::is_extreme(one.family)) continue;
    if (one.family == generators::PointFamily::one_ulp) continue;  // nearer than rounding allows
    SCOPED_TRACE(testing::Message() << one);
    for (const std::size_t neighbours : {1U, 2U, 5U, 20U}) {
      WeightedPoints weighted(one.dimension);
      try {
        weighted = with_density_weights(one.points(), neighbours);
      } catch (const InputError&) {
        continue;  // of few positions
      }
      ++weighted_inputs;
      EXPECT_EQ(one.dimension == 2 ? hidden_count<2>(weighted) : hidden_count<3>(weighted), 0U)
          << neighbours;
    }
  }
  EXPECT_GT(weighted_inputs, 200U);
}

// The same sites with the mean replaced by d_K^2 would hide some: two that are near each other
// between two that are far, where the distance to the fourth grows away from the middle.
TEST(DensityWeights, HideNoneOfThreeNearSitesBetweenTwo) {
  const WeightedPoints points(2, {0, 0, 0.01, 0, -0.01, 0, 1, 0, -1, 0}, WeightKind::none, {});
  EXPECT_EQ(hidden_count<2>(with_density_weights(points, 4)), 0U);
}

}  // namespace
}  // namespace orthoball
