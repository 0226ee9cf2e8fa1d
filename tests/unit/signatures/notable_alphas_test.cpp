// SPDX-License-Identifier: MIT
#include "orthoball/signatures/notable_alphas.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generators/cases.h"
#include "orthoball/measures/complex_measures.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/union_find.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(std::vector<double> coordinates, std::vector<double> radii = {}) {
  const WeightKind kind = radii.empty() ? WeightKind::none : WeightKind::radius;
  return Filtration<D>(
      regular_triangulation<D>(WeightedPoints(D, std::move(coordinates), kind, std::move(radii))));
}

template <int D>
std::map<std::string, NotableAlpha> by_name(const Filtration<D>& filtration) {
  std::map<std::string, NotableAlpha> result;
  for (const NotableAlpha& alpha : notable_alphas(filtration)) result.emplace(alpha.name, alpha);
  return result;
}

// The 15 points of MATLAB's documentation of alphaShape.
const std::vector<double> kFifteen{-1.5, 3.2,  1.8,  3.3,  -3.7, 1.5,  -1.5, 1.3,  0.8, 1.2,
                                   3.3,  1.5,  -4.0, -1.0, -2.3, -0.7, 0.0,  -0.5, 2.0, -1.5,
                                   3.7,  -0.8, -3.5, -2.9, -0.9, -3.9, 2.0,  -3.5, 3.5, -2.25};

TEST(NotableAlphas, OfMatlabsFifteenPoints) {
  const Filtration<2> filtration = filtration_of<2>(kFifteen);
  EXPECT_EQ(filtration.count(2), 18U);
  const auto notable = by_name(filtration);
  ASSERT_EQ(notable.size(), 8U);
  EXPECT_EQ(notable.at("all_vertices").index, 1U);
  EXPECT_EQ(notable.at("all_vertices").alpha2, 0.0);
  EXPECT_NEAR(notable.at("all_vertices_in_cells").alpha2, 3.10390925, 1e-8);
  EXPECT_NEAR(notable.at("all_vertices_in_cells").alpha, 1.76179149, 1e-8);
  EXPECT_EQ(notable.at("one_region").index, notable.at("all_vertices_in_cells").index);
  EXPECT_NEAR(notable.at("connected").alpha2, 1.94, 5e-3);
  EXPECT_NEAR(notable.at("solid").alpha2, 3.60989596, 1e-8);
  const std::vector<std::uint32_t> there{*notable.at("one_region").index};
  EXPECT_NEAR(signatures<2>(filtration, there)[0].volume, 34.3025, 1e-10);
  EXPECT_NEAR(hull_measures(filtration).volume, 44.8725, 1e-10);
}

// The components of all vertices and the cells of one complex.
template <int D>
std::size_t region_count(const Filtration<D>& filtration, std::uint32_t index) {
  UnionFind regions(filtration.count(0));
  for (std::uint32_t cell = filtration.table().first(D); cell < filtration.size(); ++cell) {
    if (filtration.enters(SimplexId(cell)) > index) continue;
    const auto vertices = filtration.vertices(SimplexId(cell));
    for (const VertexId vertex : vertices) regions.unite(vertices[0].row(), vertex.row());
  }
  return regions.set_count();
}

template <int D>
void expect_first_of_one_region(const WeightedPoints& points) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  std::optional<std::uint32_t> expected;
  if (filtration.count(D) > 0) {
    expected = 1;
    while (region_count(filtration, *expected) > 1) ++*expected;
  }
  ASSERT_EQ(by_name(filtration).at("one_region").index, expected);
}

TEST(NotableAlphas, FindTheFirstComplexOfOneRegion) {
  for (const generators::Case& one : generators::cases(2, 1, 40)) {
    SCOPED_TRACE(testing::Message() << one);
    one.dimension == 2 ? expect_first_of_one_region<2>(one.points())
                       : expect_first_of_one_region<3>(one.points());
    if (HasFatalFailure()) return;
  }
}

TEST(NotableAlphas, FindTheFirstComplexThatJoinsClusters) {
  const auto check = [&]<int D>(std::uint64_t seed) {
    const auto points = generators::points_of(generators::PointFamily::uniform, D, 60, seed);
    std::vector<double> clusters(points.coordinates().begin(), points.coordinates().end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      clusters[D * i + i % D] += 7.0 * static_cast<double>(i % 5);
    }
    const WeightedPoints all(D, std::move(clusters), WeightKind::none, {});
    expect_first_of_one_region<D>(all);
    const auto notable = by_name(Filtration<D>(regular_triangulation<D>(all)));
    EXPECT_GT(notable.at("one_region").index, notable.at("all_vertices_in_cells").index);
  };
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    check.operator()<2>(seed);
    check.operator()<3>(seed);
    if (HasFatalFailure()) return;
  }
}

TEST(NotableAlphas, AreInOneOrderWithReasons) {
  std::vector<std::string> names;
  for (const NotableAlpha& alpha : notable_alphas(filtration_of<3>({}))) {
    names.push_back(alpha.name);
    EXPECT_FALSE(alpha.reason.empty());
    EXPECT_FALSE(alpha.index);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"all_vertices", "all_vertices_in_cells", "connected",
                                             "one_region", "solid", "solid_from", "gap_0", "gap_1",
                                             "gap_2"}));
}

TEST(NotableAlphas, OfPointsOnALineHaveNoCells) {
  const auto notable = by_name(filtration_of<3>({0, 0, 0, 1, 1, 1, 3, 3, 3}));
  EXPECT_EQ(notable.at("connected").index, 3U);
  EXPECT_FALSE(notable.at("all_vertices_in_cells").index);
  EXPECT_FALSE(notable.at("one_region").index);
  EXPECT_FALSE(notable.at("solid").index);
  EXPECT_FALSE(notable.at("gap_1").index);
  // Two components from 3/4 to 3; three from 0 to 3/4.
  EXPECT_EQ(notable.at("gap_0").index, 1U);
}

TEST(NotableAlphas, OfAHollowCubeFindItsVoid) {
  const auto notable = by_name(
      filtration_of<3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1}));
  EXPECT_EQ(notable.at("gap_2").alpha2, 0.5);
  EXPECT_EQ(notable.at("gap_1").alpha2, 0.25);
  EXPECT_EQ(notable.at("gap_0").alpha2, 0.0);
  EXPECT_EQ(notable.at("solid").alpha2, 0.75);
  EXPECT_EQ(notable.at("solid_from").alpha2, 0.75);
}

TEST(AutomaticAlpha, IsSolidConnectedOrTheMolecule) {
  const Filtration<2> plain = filtration_of<2>(kFifteen);
  const std::vector<NotableAlpha> notable = notable_alphas(plain);
  EXPECT_EQ(automatic_alpha<2>(plain, notable, WeightMeaning::none).name, "solid");
  EXPECT_EQ(automatic_alpha<2>(plain, notable, WeightMeaning::given).name, "connected");
  const NotableAlpha molecule = automatic_alpha<2>(plain, notable, WeightMeaning::molecule_radii);
  EXPECT_EQ(molecule.name, "dual_complex");
  EXPECT_EQ(molecule.alpha2, 0.0);
  EXPECT_EQ(molecule.index, plain.index(0.0));
}

TEST(AutomaticAlpha, IsConnectedWhereNothingIsSolid) {
  const Filtration<2> line = filtration_of<2>({0, 0, 1, 1});
  EXPECT_EQ(automatic_alpha<2>(line, notable_alphas(line), WeightMeaning::none).name, "connected");
  const Filtration<2> empty;
  const NotableAlpha nothing =
      automatic_alpha<2>(empty, notable_alphas(empty), WeightMeaning::none);
  EXPECT_EQ(nothing.index, 0U);
}

}  // namespace
}  // namespace orthoball
