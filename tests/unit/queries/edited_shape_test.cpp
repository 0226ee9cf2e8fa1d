// SPDX-License-Identifier: MIT
#include "orthoball/queries/edited_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/error.h"
#include "orthoball/queries/regions.h"
#include "orthoball/queries/voids.h"
#include "unit/output/shapes.h"
#include "unit/queries/filtration_of.h"

namespace orthoball {
namespace {

template <int D>
std::set<SimplexId> simplices_of(const AlphaComplex<D>& complex) {
  std::set<SimplexId> result;
  for (std::uint32_t i = 0; i < complex.filtration().size(); ++i) {
    if (complex.contains(SimplexId(i))) result.emplace(i);
  }
  return result;
}

template <int D>
void add_closed(const Filtration<D>& filtration, SimplexId simplex, std::set<SimplexId>& to) {
  if (!to.insert(simplex).second) return;
  for (const SimplexId facet : filtration.facets(simplex)) add_closed(filtration, facet, to);
}

// The simplices of a component, going from one to what shares a vertex with it.
template <int D>
std::set<SimplexId> component_of(const Filtration<D>& filtration, const std::set<SimplexId>& all,
                                 SimplexId start) {
  std::set<SimplexId> found{start};
  std::set<VertexId> reached;
  for (std::size_t size = 0; size < found.size();) {
    size = found.size();
    for (const SimplexId simplex : found) {
      for (const VertexId v : filtration.vertices(simplex)) reached.insert(v);
    }
    for (const SimplexId simplex : all) {
      for (const VertexId v : filtration.vertices(simplex)) {
        if (reached.count(v) > 0) found.insert(simplex);
      }
    }
  }
  return found;
}

template <int D>
void expect_by_definition(const WeightedPoints& points) {
  const auto filtration = filtration_of<D>(points);
  for (const std::uint32_t part : {3U, 5U, 6U, 7U}) {
    const std::uint32_t index = filtration.spectrum_size() * part / 8;
    const auto there = voids<D>(filtration, index, 0.0, VoidsOf::shape);
    const double hole_threshold = there.empty() ? 1.0 : there[there.size() / 2].volume;
    std::set<SimplexId> filled = simplices_of(AlphaComplex<D>(filtration, index));
    std::size_t holes_filled = 0;
    for (const Void<D>& hole : there) {
      if (!(hole.volume <= hole_threshold) || hole_threshold == 0.0) continue;
      ++holes_filled;
      for (const SimplexId cell : hole.cells) add_closed(filtration, cell, filled);
    }
    const auto shape = edited_shape(filtration, index, {.hole_threshold = hole_threshold});
    ASSERT_EQ(simplices_of(shape.complex), filled);
    EXPECT_EQ(shape.holes_filled, holes_filled);

    const auto parts = regions(shape.complex, JoinedBy::vertices);
    if (parts.empty()) continue;
    const double region_threshold = parts[parts.size() / 2].volume;
    std::set<SimplexId> kept;
    std::size_t dropped = 0;
    for (const Region& one : parts) {
      const bool is_kept = region_threshold == 0.0 && !one.cells.empty();
      if (one.volume <= region_threshold && !is_kept) ++dropped;
    }
    for (const SimplexId simplex : filled) {
      if (kept.count(simplex) > 0) continue;
      const auto row = filtration.rows(simplex)[0];
      for (std::size_t i = 0; i + dropped < parts.size(); ++i) {
        if (!std::binary_search(parts[i].rows.begin(), parts[i].rows.end(), row)) continue;
        const auto component = component_of(filtration, filled, simplex);
        kept.insert(component.begin(), component.end());
      }
    }
    const auto large =
        edited_shape(filtration, index,
                     {.hole_threshold = hole_threshold, .region_threshold = region_threshold});
    ASSERT_EQ(simplices_of(large.complex), kept);
    EXPECT_EQ(large.regions_dropped, dropped);
    EXPECT_EQ(large.region_count, parts.size());
  }
}

TEST(EditedShape, IsWhatFillingVoidsAndDroppingComponentsGive) {
  for (const auto family : generators::point_families()) {
    SCOPED_TRACE(generators::name(family));
    expect_by_definition<2>(generators::points_of(family, 2, 40, 3));
    expect_by_definition<3>(generators::points_of(family, 3, 20, 4));
  }
}

template <int D>
void expect_parts(const WeightedPoints& points) {
  const auto filtration = filtration_of<D>(points);
  for (const std::uint32_t part : {4U, 6U, 8U}) {
    const std::uint32_t index = filtration.spectrum_size() * part / 8;
    for (const bool is_regularized : {false, true}) {
      const auto whole = edited_shape(filtration, index, {.regularized = is_regularized});
      const auto parts = regions(whole.complex, JoinedBy::vertices);
      std::set<SimplexId> together;
      for (std::uint32_t number = 1; number <= parts.size(); ++number) {
        const auto one =
            edited_shape(filtration, index, {.regularized = is_regularized, .region = number});
        const auto of_one = regions(one.complex, JoinedBy::vertices);
        ASSERT_EQ(of_one.size(), 1U);
        EXPECT_EQ(of_one[0].rows, parts[number - 1].rows);
        EXPECT_EQ(of_one[0].volume, parts[number - 1].volume);
        EXPECT_EQ(of_one[0].area, parts[number - 1].area);
        EXPECT_EQ(of_one[0].betti, parts[number - 1].betti);
        together.merge(simplices_of(one.complex));
      }
      EXPECT_EQ(together, simplices_of(whole.complex));
    }
  }
}

TEST(EditedShape, IsTheUnionOfItsRegionsTakenOneByOne) {
  for (const auto family : generators::point_families()) {
    SCOPED_TRACE(generators::name(family));
    expect_parts<2>(generators::points_of(family, 2, 30, 9));
    expect_parts<3>(generators::points_of(family, 3, 20, 9));
  }
}

TEST(Holes, OfAlphaShapesAreItsVoids) {
  for (const auto family : generators::point_families()) {
    if (generators::is_extreme(family)) continue;
    SCOPED_TRACE(generators::name(family));
    const auto filtration = filtration_of<3>(generators::points_of(family, 3, 50, 6));
    const std::uint32_t index = filtration.spectrum_size() * 3 / 4;
    const auto found = holes(AlphaComplex<3>(filtration, index));
    const auto expected = voids<3>(filtration, index, 0.0, VoidsOf::shape);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].volume, expected[i].volume, 1e-12 * expected[i].volume);
      EXPECT_NEAR(found[i].area, expected[i].area, 1e-12 * expected[i].area);
    }
  }
}

// Squares of 9 x 9 cells: holes of 1, 2 and 4 cells, and an island of one cell in a lake of 9.
Shapes<2> pierced() {
  return checkered(9, [](int x, int y) {
    const bool one = x == 1 && y == 1, two = (x == 3 || x == 4) && y == 1;
    const bool four = (x == 6 || x == 7) && (y == 1 || y == 2);
    const bool lake = x >= 2 && x <= 6 && y >= 4 && y <= 8 - 1 && !(x >= 4 && x <= 4 && y == 6);
    return one || two || four || lake;
  });
}

TEST(EditedShape, FillsHolesUpToTheThresholdAndThenLeavesOutRegions) {
  const Shapes<2> shapes = pierced();
  const std::uint32_t index = shapes.filtration.index(0.25);
  const auto volume = [&](ShapeEdits edits) {
    edits.regularized = true;  // edges of length 1 divide the holes
    double sum = 0.0;
    const auto shape = edited_shape(shapes.filtration, index, edits);
    for (const Region& one : regions(shape.complex, JoinedBy::vertices)) sum += one.volume;
    return sum;
  };
  const double whole = 81 - 1 - 2 - 4 - 19;
  EXPECT_EQ(volume({}), whole);
  EXPECT_EQ(volume({.hole_threshold = 0.9}), whole);
  EXPECT_EQ(volume({.hole_threshold = 1}), whole + 1);
  EXPECT_EQ(volume({.hole_threshold = 3}), whole + 3);
  EXPECT_EQ(volume({.hole_threshold = 4}), whole + 7);
  EXPECT_EQ(volume({.hole_threshold = 19}), 81.0);
  EXPECT_EQ(volume({.region_threshold = 1}), whole - 1);  // the island
  EXPECT_EQ(volume({.region_threshold = 0.5}), whole);
  EXPECT_EQ(volume({.hole_threshold = 19, .region_threshold = 80}), 81.0);  // holes come first
  EXPECT_EQ(volume({.region = 1}), whole - 1);
  EXPECT_EQ(volume({.region = 2}), 1.0);
  EXPECT_EQ(volume({.region_threshold = 100}), 0.0);
}

TEST(EditedShape, KeepsCellsWhoseVolumeIsRoundedToNothing) {
  // A triangle whose area is no double, one of area 1/2, and a point that stands alone.
  const double tiny = 1e-170;
  const Shapes<2> shapes({0, 0, tiny, 0, 0, tiny, 5, 5, 6, 5, 5, 6, 90, 90});
  const std::uint32_t index = shapes.filtration.index(0.5);
  const auto all = edited_shape(shapes.filtration, index, {.region = 1});
  EXPECT_EQ(all.region_count, 3U);
  const auto kept = edited_shape(shapes.filtration, index, {.region_threshold = 0});
  EXPECT_EQ(kept.regions_dropped, 1U);
  const auto left = regions(kept.complex, JoinedBy::vertices);
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left[1].volume, 0.0);
  EXPECT_EQ(left[1].cells.size(), 1U);
  const auto dropped = edited_shape(shapes.filtration, index, {.region_threshold = tiny});
  EXPECT_EQ(dropped.regions_dropped, 2U);
}

TEST(EditedShape, MembranesDoNotDivideHolesOfARegularizedShape) {
  // A square ring of cells around one square hole that an edge divides.
  const Shapes<2> shapes = checkered(3, [](int x, int y) { return x == 1 && y == 1; });
  const auto& filtration = shapes.filtration;
  const std::uint32_t index = filtration.index(0.25);
  const auto ring = AlphaComplex<2>(filtration, index);
  std::vector<SimplexId> simplices = ring.maximal_simplices();
  const std::uint32_t first = filtration.table().first(1);
  for (std::uint32_t i = first; i < first + filtration.count(1); ++i) {
    if (!ring.contains(SimplexId(i))) simplices.emplace_back(i);
  }
  const AlphaComplex<2> divided(filtration, index, simplices);
  EXPECT_EQ(holes(divided).size(), 2U);
  EXPECT_EQ(holes(regularized(divided)).size(), 1U);
  EXPECT_EQ(holes(regularized(divided))[0].volume, 1.0);
  EXPECT_EQ(holes(divided)[0].area, 2 + std::sqrt(2.0));
}

TEST(EditedShape, RefusesWhatIsNoThresholdAndRegionsThatThereAreNot) {
  const Shapes<2> shapes = pierced();
  const std::uint32_t index = shapes.filtration.index(0.25);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ShapeEdits& edits :
       {ShapeEdits{.hole_threshold = -1}, ShapeEdits{.region_threshold = nan},
        ShapeEdits{.regularized = true, .region = 3},
        ShapeEdits{.regularized = true, .region_threshold = 1, .region = 2}}) {
    EXPECT_THROW((void)edited_shape(shapes.filtration, index, edits), InputError);
  }
  EXPECT_THROW((void)edited_shape(shapes.filtration, shapes.filtration.never(), {}), InputError);
}

}  // namespace
}  // namespace orthoball
