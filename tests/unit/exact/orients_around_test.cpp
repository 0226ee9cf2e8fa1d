// SPDX-License-Identifier: MIT
#include "orthoball/exact/orients_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "orthoball/exact/processor.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;

// Whether this processor can take the glance.
template <int D>
bool can_glance() {
  return D == 2 || has_avx2();
}

GlancedOrients orients_around(const Sites<2>& sites, const Corners<2>& corners,
                              std::uint32_t query) {
  return glanced_orients_around(sites, corners, query);
}

#ifdef ORTHOBALL_WIDE_CODE
ORTHOBALL_AVX2 GlancedOrients orients_around(const Sites<3>& sites, const Corners<3>& corners,
                                             std::uint32_t query) {
  return glanced_orients_around(sites, corners, query);
}
#else
GlancedOrients orients_around(const Sites<3>&, const Corners<3>&, std::uint32_t) { return {}; }
#endif

// How many of the facets asked about are left open.
template <int D>
double open_share(const WeightedPoints& points, std::uint64_t seed, int count) {
  const Sites<D> sites = tuples::sites_of<D>(points);
  Random random(seed);
  int open = 0;
  for (int i = 0; i < count; ++i) {
    const auto rows = tuples::any_rows<D + 2>(random, points.size());
    Corners<D> corners;
    std::copy_n(rows.begin(), D + 1, corners.begin());
    const std::uint32_t query = rows[D + 1];
    const GlancedOrients orients = orients_around(sites, corners, query);
    EXPECT_EQ(orients.negative & orients.open, 0U);
    for (std::size_t facet = 0; facet <= D; ++facet) {
      if ((orients.open >> facet & 1U) != 0) {
        ++open;
        continue;
      }
      Corners<D> replaced = corners;
      replaced[facet] = query;
      const bool is_negative = orient<D, D>(sites, replaced) == Sign::negative;
      EXPECT_EQ((orients.negative >> facet & 1U) != 0, is_negative);
    }
  }
  return open / ((D + 1.0) * count);
}

// Points that lie in a line or a plane but for their rounding, so that many values have the size of
// their errors.
template <int D>
WeightedPoints nearly_dependent_points(std::uint64_t seed) {
  Random random(seed);
  std::vector<double> coordinates;
  for (int i = 0; i < 100; ++i) {
    const double s = random.uniform(), t = random.uniform();
    coordinates.insert(coordinates.end(), {s, D == 2 ? 0.1 * s + 0.3 : t});
    if (D == 3) coordinates.push_back(0.1 * s + 0.7 * t + 0.3);
  }
  return {D, std::move(coordinates), WeightKind::none, {}};
}

template <int D>
void expect_signs() {
  if (!can_glance<D>()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(::testing::Message() << name(family) << ' ' << seed);
      open_share<D>(points_of(family, D, 25, seed), seed, 200);
    }
  }
  EXPECT_GT(open_share<D>(nearly_dependent_points<D>(1), 1, 2000), 0.5);
}

TEST(OrientsAround, AreTheSignsOfOrientWhereTheyAreKnownInThePlane) { expect_signs<2>(); }

TEST(OrientsAround, AreTheSignsOfOrientWhereTheyAreKnownInSpace) { expect_signs<3>(); }

template <int D>
void expect_little_open() {
  if (!can_glance<D>()) GTEST_SKIP() << "this processor has no vectors of four doubles";
  EXPECT_LT(open_share<D>(points_of(PointFamily::uniform, D, 200, 1), 1, 2000), 0.001);
  EXPECT_EQ(open_share<D>(points_of(PointFamily::grid, D, 200, 1), 1, 2000), 0.0);
}

TEST(OrientsAround, LeaveLittleOpenInGeneralPositionAndOnGridsInThePlane) {
  expect_little_open<2>();
}

TEST(OrientsAround, LeaveLittleOpenInGeneralPositionAndOnGridsInSpace) { expect_little_open<3>(); }

}  // namespace
}  // namespace orthoball
