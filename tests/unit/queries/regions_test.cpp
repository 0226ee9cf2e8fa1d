// SPDX-License-Identifier: MIT
#include "orthoball/queries/regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/error.h"
#include "orthoball/output/polygons.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/betti.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

std::vector<SiteId> rows(std::vector<std::uint32_t> numbers) {
  std::vector<SiteId> result;
  for (const std::uint32_t number : numbers) result.emplace_back(number);
  return result;
}

// Two triangles with a common corner, an edge and a point.
WeightedPoints figures() {
  return {2, {0, 0, -10, -3, -10, 3, 10, -3, 10, 3, 100, 0, 105, 0, 200, 0}, WeightKind::none, {}};
}
const double kPerimeter = 6 + 2 * std::sqrt(109.0);  // of a triangle

TEST(Regions, AreTheComponentsOfTheComplexWithTheirMeasures) {
  const auto filtration = filtration_of<2>(figures());
  const auto found = regions(AlphaComplex(filtration, filtration.index(30.0)), JoinedBy::vertices);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].volume, 60.0);
  EXPECT_DOUBLE_EQ(found[0].area, 2 * kPerimeter);
  EXPECT_EQ(found[0].rows, rows({0, 1, 2, 3, 4}));
  EXPECT_EQ(found[0].cells.size(), 2U);
  EXPECT_EQ(found[1].volume, 0.0);
  EXPECT_EQ(found[1].area, 10.0);  // both sides of the edge
  EXPECT_EQ(found[1].rows, rows({5, 6}));
  EXPECT_EQ(found[2].area, 0.0);
  EXPECT_EQ(found[2].rows, rows({7}));
}

TEST(Regions, JoinedByFacetsAreApartWhereTheyHaveACornerInCommon) {
  const auto filtration = filtration_of<2>(figures());
  const auto found = regions(AlphaComplex(filtration, filtration.index(30.0)), JoinedBy::facets);
  ASSERT_EQ(found.size(), 2U);
  for (const Region& triangle : found) {
    EXPECT_EQ(triangle.volume, 30.0);
    EXPECT_DOUBLE_EQ(triangle.area, kPerimeter);
    EXPECT_EQ(triangle.cells.size(), 1U);
    EXPECT_EQ(triangle.rows[0], SiteId(0));
  }
}

TEST(Regions, JoinedByCellsAreOneWhereTheyHaveACornerInCommon) {
  const auto filtration = filtration_of<2>(figures());
  const auto found = regions(AlphaComplex(filtration, filtration.index(30.0)), JoinedBy::cells);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].volume, 60.0);
  EXPECT_DOUBLE_EQ(found[0].area, 2 * kPerimeter);
  EXPECT_EQ(found[0].rows, rows({0, 1, 2, 3, 4}));
}

TEST(Regions, OfTheEmptyComplexAreNoneAndBeyondTheSpectrumAnError) {
  const auto filtration = filtration_of<2>(figures());
  for (const auto by : {JoinedBy::vertices, JoinedBy::cells, JoinedBy::facets}) {
    EXPECT_TRUE(regions(AlphaComplex(filtration, 0), by).empty());
    EXPECT_THROW((void)regions(AlphaComplex(filtration, filtration.never()), by), InputError);
  }
}

TEST(Regions, AFlatShapeInSpaceHasTwoSides) {
  const auto filtration =
      filtration_of<3>(WeightedPoints(3, {0, 0, 0, 2, 0, 0, 0, 2, 0}, WeightKind::none, {}));
  const auto found =
      regions(AlphaComplex(filtration, filtration.spectrum_size()), JoinedBy::vertices);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].volume, 0.0);
  EXPECT_EQ(found[0].area, 4.0);
  EXPECT_TRUE(
      regions(AlphaComplex(filtration, filtration.spectrum_size()), JoinedBy::facets).empty());
}

std::size_t polygons_count(const Filtration<2>& filtration, std::uint32_t index) {
  return polygons(AlphaComplex(filtration, index)).size();
}
std::size_t polygons_count(const Filtration<3>&, std::uint32_t) { return 0; }

template <int D>
void add_up(const WeightedPoints& points) {
  const auto filtration = filtration_of<D>(points);
  for (const std::uint32_t part : {1U, 2U, 3U, 4U}) {
    const std::uint32_t index = filtration.spectrum_size() / 4 * part;
    const auto all = regions(AlphaComplex(filtration, index), JoinedBy::vertices);
    EXPECT_EQ(all.size(), betti_numbers(filtration, index)[0]);
    const Signature<D> whole = signatures<D>(filtration, std::vector{index}).front();
    double volume = 0.0, area = 0.0, solid_volume = 0.0, solid_area = 0.0;
    std::size_t cells = 0, vertices = 0;
    for (const Region& one : all) {
      volume += one.volume;
      area += one.area;
      cells += one.cells.size();
      vertices += one.rows.size();
    }
    const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    EXPECT_TRUE(near(volume, whole.volume)) << volume << ' ' << whole.volume;
    EXPECT_TRUE(near(area, whole.area)) << area << ' ' << whole.area;
    EXPECT_EQ(cells, whole.interior[D]);
    const Region together = whole_shape(AlphaComplex(filtration, index));
    EXPECT_TRUE(near(together.volume, whole.volume));
    EXPECT_TRUE(near(together.area, whole.area));
    EXPECT_EQ(together.rows.size(), vertices);
    for (std::size_t k = 0; k < D; ++k) EXPECT_EQ(together.betti[k], whole.betti[k]);
    EXPECT_EQ(vertices, whole.singular[0] + whole.regular[0] + whole.interior[0]);
    for (const auto by : {JoinedBy::cells, JoinedBy::facets}) {
      const auto solids = regions(AlphaComplex(filtration, index), by);
      solid_volume = solid_area = 0.0;
      for (const Region& one : solids) {
        solid_volume += one.volume;
        solid_area += one.area;
      }
      EXPECT_TRUE(near(solid_volume, whole.volume));
      EXPECT_TRUE(near(solid_area, whole.area_regular));
      if (D == 2 && by == JoinedBy::facets) {
        EXPECT_EQ(solids.size(), polygons_count(filtration, index));
      }
    }
  }
  for (const NotableAlpha& notable : notable_alphas(filtration)) {
    if (notable.name != "one_region" || !notable.index) continue;
    const auto one = regions(AlphaComplex(filtration, *notable.index), JoinedBy::cells);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].rows.size(), filtration.count(0));
  }
}

TEST(Regions, AddUpToTheWholeAndAreAsManyAsItsComponents) {
  for (const auto family : generators::point_families()) {
    if (generators::is_extreme(family)) continue;
    SCOPED_TRACE(generators::name(family));
    add_up<2>(generators::points_of(family, 2, 80, 5));
    add_up<3>(generators::points_of(family, 3, 80, 5));
  }
}

}  // namespace
}  // namespace orthoball
