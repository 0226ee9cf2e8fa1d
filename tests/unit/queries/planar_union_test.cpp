// SPDX-License-Identifier: MIT
#include "orthoball/queries/planar_union.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "generators/cases.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/topology/betti.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using std::numbers::pi;

PlanarUnion union_of(std::vector<double> centres, std::vector<double> radii) {
  const Filtration<2> filtration(regular_triangulation<2>(
      WeightedPoints(2, std::move(centres), WeightKind::radius, std::move(radii))));
  return planar_union(filtration, filtration.index(0.0), 0.0);
}

// Twice the area that a curve takes around a point: of segments and arcs of one centre.
double area_about(const DiskPart& part) {
  double twice = 0.0;
  for (const DiskPiece& piece : part.boundary) {
    const double x0 = piece.from[0] - part.centre[0], y0 = piece.from[1] - part.centre[1];
    const double x1 = piece.to[0] - part.centre[0], y1 = piece.to[1] - part.centre[1];
    twice += piece.is_arc() ? part.radius * part.radius * piece.turn : x0 * y1 - x1 * y0;
  }
  return twice / 2;
}

TEST(PlanarUnion, OfOneDiskIsACircle) {
  const PlanarUnion one = union_of({3, 4}, {2});
  ASSERT_EQ(one.parts.size(), 1U);
  EXPECT_EQ(one.parts[0].row, SiteId(0));
  EXPECT_EQ(one.parts[0].centre, (std::array{3.0, 4.0}));
  EXPECT_EQ(one.parts[0].radius, 2.0);
  ASSERT_EQ(one.parts[0].boundary.size(), 1U);
  EXPECT_TRUE(one.parts[0].boundary[0].is_arc());
  EXPECT_EQ(one.parts[0].boundary[0].turn, 2 * pi);
  ASSERT_EQ(one.outline.size(), 1U);
  EXPECT_EQ(one.outline[0].size(), 1U);
}

TEST(PlanarUnion, OfTwoDisksHasACommonSegment) {
  const PlanarUnion two = union_of({0, 0, 1, 0}, {1, 1});
  ASSERT_EQ(two.parts.size(), 2U);
  for (const DiskPart& part : two.parts) {
    ASSERT_EQ(part.boundary.size(), 2U);
    EXPECT_NEAR(part.boundary[1].turn, 4 * pi / 3, 1e-15);
  }
  const DiskPiece& segment = two.parts[0].boundary[0];
  EXPECT_EQ(segment.neighbour, SiteId(1));
  EXPECT_NEAR(segment.from[0], 0.5, 1e-15);
  EXPECT_NEAR(segment.from[1], -std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(segment.to[1], std::sqrt(0.75), 1e-15);
  ASSERT_EQ(two.outline.size(), 1U);
  EXPECT_EQ(two.outline[0].size(), 2U);
}

// Four disks on a square around a hole: an outer curve of four arcs and an inner one.
TEST(PlanarUnion, HasACurveAroundEachHole) {
  const PlanarUnion ring = union_of({0, 0, 2, 0, 2, 2, 0, 2}, {1.2, 1.2, 1.2, 1.2});
  ASSERT_EQ(ring.outline.size(), 2U);
  EXPECT_EQ(ring.outline[0].size(), 4U);
  EXPECT_EQ(ring.outline[1].size(), 4U);
}

TEST(PlanarUnion, OfNothingIsEmpty) {
  EXPECT_TRUE(union_of({}, {}).parts.empty());
  EXPECT_TRUE(union_of({}, {}).outline.empty());
}

// Parts have the areas, and arcs the lengths, that the measures tell; pieces follow one another;
// every arc is on one curve.
TEST(PlanarUnion, HasTheMeasuresOfTheUnion) {
  for (const generators::Case& one : generators::cases(4, 1, 80)) {
    if (one.dimension != 2 || is_extreme(one.family)) continue;
    if (one.family == generators::PointFamily::one_ulp) continue;  // angles are all rounding
    SCOPED_TRACE(::testing::Message() << one);
    const Filtration<2> filtration(regular_triangulation<2>(one.points()));
    const std::uint32_t last = filtration.spectrum_size();
    for (std::uint32_t share = 0; share <= 4; ++share) {
      const std::uint32_t index = last * share / 4;
      if (index == 0) continue;
      const double alpha2 = filtration.alpha2(index);
      SCOPED_TRACE(alpha2);
      const PlanarUnion drawn = planar_union(filtration, index, alpha2);
      const UnionOfBalls measured = union_of_balls(filtration, index, alpha2, {});
      std::size_t arcs = 0, on_curves = 0;
      for (const DiskPart& part : drawn.parts) {
        const double r = part.radius;
        double length = 0.0;
        for (std::size_t i = 0; i < part.boundary.size(); ++i) {
          const DiskPiece& piece = part.boundary[i];
          EXPECT_EQ(piece.to, part.boundary[(i + 1) % part.boundary.size()].from);
          if (!piece.is_arc()) continue;
          ++arcs;
          length += r * piece.turn;
        }
        EXPECT_NEAR(length, measured.areas[part.row.row()], 1e-6 * r);
        EXPECT_NEAR(area_about(part), measured.volumes[part.row.row()], 1e-6 * r * r);
      }
      for (const auto& curve : drawn.outline) {
        on_curves += curve.size();
        for (std::size_t i = 0; i < curve.size(); ++i) {
          const auto piece = [&](std::size_t at) {
            const OutlineArc& arc = curve[at % curve.size()];
            return drawn.parts[arc.part].boundary[arc.piece];
          };
          EXPECT_EQ(piece(i).to, piece(i + 1).from);
        }
      }
      EXPECT_EQ(on_curves, arcs);
      const auto betti = betti_numbers(filtration, index);
      EXPECT_GE(drawn.outline.size(), betti[0] + betti[1]);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace orthoball
