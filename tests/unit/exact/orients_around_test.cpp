// SPDX-License-Identifier: MIT
#include "orthoball/exact/orients_around.h"

#include <gtest/gtest.h>

#include "orthoball/exact/processor.h"
#include "tuples.h"

namespace orthoball {
namespace {

#ifdef ORTHOBALL_WIDE_CODE

using generators::PointFamily;
using generators::Random;

ORTHOBALL_AVX2 GlancedOrients orients_around(const Sites<3>& sites, const Corners<3>& corners,
                                             std::uint32_t query) {
  return glanced_orients_around(sites, corners, query);
}

// How many of the facets asked about are left open.
double open_share(const WeightedPoints& points, std::uint64_t seed, int count) {
  const Sites<3> sites = tuples::sites_of<3>(points);
  Random random(seed);
  int open = 0;
  for (int i = 0; i < count; ++i) {
    const auto rows = tuples::any_rows<5>(random, points.size());
    const Corners<3> corners{rows[0], rows[1], rows[2], rows[3]};
    const GlancedOrients orients = orients_around(sites, corners, rows[4]);
    EXPECT_EQ(orients.negative & orients.open, 0U);
    for (std::size_t facet = 0; facet < 4; ++facet) {
      if ((orients.open >> facet & 1U) != 0) {
        ++open;
        continue;
      }
      Corners<3> replaced = corners;
      replaced[facet] = rows[4];
      const bool is_negative = orient<3, 3>(sites, replaced) == Sign::negative;
      EXPECT_EQ((orients.negative >> facet & 1U) != 0, is_negative);
    }
  }
  return open / (4.0 * count);
}

TEST(OrientsAround, AreTheSignsOfOrientWhereTheyAreKnown) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      open_share(points_of(family, 3, 25, seed), seed, 200);
    }
  }
}

TEST(OrientsAround, LeaveLittleOpenInGeneralPositionAndOnGrids) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  EXPECT_LT(open_share(points_of(PointFamily::uniform, 3, 200, 1), 1, 2000), 0.001);
  EXPECT_EQ(open_share(points_of(PointFamily::grid, 3, 200, 1), 1, 2000), 0.0);
}

#endif

}  // namespace
}  // namespace orthoball
