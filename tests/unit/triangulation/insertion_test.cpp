// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/triangulation/territory.h"
#include "orthoball/triangulation/verify.h"

namespace orthoball {
namespace {

using generators::PointFamily;

template <int A, int D>
bool have_same_cells(const RegularTriangulation<D>& a, const RegularTriangulation<D>& b) {
  return std::equal(a.template cells<A>().begin(), a.template cells<A>().end(),
                    b.template cells<A>().begin(), b.template cells<A>().end(),
                    [](const CellRecord<A>& x, const CellRecord<A>& y) {
                      return x.corners == y.corners && x.neighbours == y.neighbours;
                    });
}

template <int D>
void expect_the_same(const RegularTriangulation<D>& a, const RegularTriangulation<D>& b) {
  EXPECT_EQ(a.affine_dimension(), b.affine_dimension());
  EXPECT_TRUE(std::ranges::equal(a.hidden(), b.hidden()));
  EXPECT_TRUE(std::ranges::equal(a.sites().rows(), b.sites().rows()));
  EXPECT_EQ(a.cell_count(), b.cell_count());
  const auto same = have_same_cells<1>(a, b) && have_same_cells<2>(a, b);
  EXPECT_TRUE(same);
  if constexpr (D == 3) {
    EXPECT_TRUE((have_same_cells<3>(a, b)));
  }
}

template <int D>
void check_threads(PointFamily family, std::size_t count, std::initializer_list<unsigned> threads) {
  SCOPED_TRACE(::testing::Message() << name(family) << ' ' << D << "D");
  const WeightedPoints points = points_of(family, D, count, 1);
  const auto alone = regular_triangulation<D>(points, Threads(1));
  for (const unsigned many : threads) {
    SCOPED_TRACE(::testing::Message() << many << " threads");
    expect_the_same<D>(alone, regular_triangulation<D>(points, Threads(many)));
  }
}

TEST(Insertion, GivesTheSameCellsOnAnyNumberOfThreads) {
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::uniform_balls, PointFamily::protein_like,
        PointFamily::scan_like, PointFamily::grid, PointFamily::hidden_heavy, PointFamily::coplanar,
        PointFamily::duplicated, PointFamily::collinear}) {
    check_threads<3>(family, 20000, {2, 4});
    check_threads<2>(family, 30000, {2, 3});
  }
  check_threads<3>(PointFamily::uniform, 80000, {16});
  check_threads<2>(PointFamily::grid, 90000, {16});
}

// Sites on a parabola in a plane of space: all on the hull.
TEST(Insertion, SharesNoCellsAtInfinityInAPlaneOfSpace) {
  std::vector<double> x;
  for (int i = 0; i < 70000; ++i) {
    const double t = i;
    x.insert(x.end(), {t, t * t, t + t * t});
  }
  const WeightedPoints points(3, x, WeightKind::none, {});
  const auto alone = regular_triangulation<3>(points, Threads(1));
  EXPECT_EQ(alone.affine_dimension(), 2);
  EXPECT_EQ(alone.cell_count(), 69998U);
  expect_the_same<3>(alone, regular_triangulation<3>(points, Threads(8)));
}

TEST(Insertion, TakesMoreThreadsThanThereAreSites) {
  for (std::size_t count = 0; count <= 5; ++count) {
    const WeightedPoints points = points_of(PointFamily::uniform, 3, count, 1);
    expect_the_same<3>(regular_triangulation<3>(points, Threads(1)),
                       regular_triangulation<3>(points, Threads(16)));
  }
}

TEST(Insertion, HidesOnManyThreadsWhatOneBallHides) {
  const WeightedPoints small = points_of(PointFamily::uniform, 3, 30000, 1);
  std::vector<double> x(small.coordinates().begin(), small.coordinates().end());
  std::vector<double> radii(small.size(), 0.0);
  radii[17] = 10.0;  // much larger than the box of the others
  const WeightedPoints points(3, x, WeightKind::radius, radii);
  const auto alone = regular_triangulation<3>(points, Threads(1));
  EXPECT_GT(alone.hidden().size(), 29000U);
  expect_the_same<3>(alone, regular_triangulation<3>(points, Threads(4)));
}

TEST(Insertion, OnManyThreadsGivesRegularTriangulations) {
  const WeightedPoints points = points_of(PointFamily::uniform_balls, 3, 20000, 2);
  EXPECT_EQ(verify(regular_triangulation<3>(points, Threads(3)), points),
            std::vector<std::string>());
}

TEST(Territory, OfManyTheVertexAtInfinityIsInAllOfTetrahedraAndInNoneOfTriangles) {
  const Sites<3> sites(points_of(PointFamily::uniform, 3, 2, 1), {SiteId(0), SiteId(1)});
  const Sites<2> flat(points_of(PointFamily::uniform, 2, 2, 1), {SiteId(0), SiteId(1)});
  EXPECT_TRUE((Territory<3, 3>::of_numbers(0, 1, 2).has(2)));
  EXPECT_FALSE((Territory<2, 2>::of_numbers(0, 2, 2).has(2)));
  EXPECT_TRUE((Territory<3, 3>::of_box(sites, Box<3>{}, 2).has(2)));
  EXPECT_FALSE((Territory<2, 2>::of_box(flat, Box<2>::whole(), 2).has(2)));
  EXPECT_FALSE((Territory<2, 3>::of_numbers(0, 2, 2).has(2)));
  EXPECT_FALSE((Territory<2, 3>::of_box(sites, Box<3>::whole(), 2).has(2)));
  EXPECT_TRUE((Territory<2, 2>::whole().has(2)));
}

TEST(Territory, HasWhatIsBetweenItsBorders) {
  const WeightedPoints points(3, {0, 5, 0, 1, 6, 0, 2, 7, 0}, WeightKind::none, {});
  const Sites<3> sites(points, {SiteId(0), SiteId(1), SiteId(2)});
  const auto part = Territory<3, 3>::of_numbers(1, 2, 3);
  Box<3> between = Box<3>::whole();
  between.low[1] = 5.5;
  between.high[1] = 7.0;
  const auto box = Territory<3, 3>::of_box(sites, between, 3);
  for (const auto& territory : {part, box}) {
    EXPECT_FALSE(territory.has(0));
    EXPECT_TRUE(territory.has(1));
    EXPECT_FALSE(territory.has(2));
    EXPECT_FALSE(territory.is_whole());
  }
  EXPECT_TRUE(part.has_at_once(1));
  for (std::uint32_t vertex = 0; vertex <= 3; ++vertex) {
    EXPECT_TRUE((Territory<3, 3>::whole().has_at_once(vertex)));
    EXPECT_FALSE(box.has_at_once(vertex));
    EXPECT_FALSE((Territory<3, 3>::of_numbers(2, 2, 3).has_at_once(vertex)));  // none
    EXPECT_LE(part.has_at_once(vertex), part.has(vertex));
    EXPECT_LE((Territory<2, 2>::of_numbers(1, 3, 3).has_at_once(vertex)),
              (Territory<2, 2>::of_numbers(1, 3, 3).has(vertex)));
  }
}

}  // namespace
}  // namespace orthoball
