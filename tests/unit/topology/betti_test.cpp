// SPDX-License-Identifier: MIT
#include "orthoball/topology/betti.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "generators/cases.h"
#include "orthoball/error.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
Filtration<D> filtration_of(std::vector<double> coordinates) {
  return Filtration<D>(
      regular_triangulation<D>(WeightedPoints(D, std::move(coordinates), WeightKind::none, {})));
}

TEST(CycleMarks, OfASquareCloseOneLoop) {
  const Filtration<2> square = filtration_of<2>({0, 0, 1, 0, 0, 1, 1, 1});
  const CycleMarks<2> marks(square);
  const Filter<2> filter(square);
  // Four vertices; four sides, the last of which closes the loop; the diagonal cuts it in two.
  const std::vector<bool> expected{true,  true, true, true,  false, false,
                                   false, true, true, false, false};
  ASSERT_EQ(square.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(marks.closes(filter.simplices()[i]), expected[i]) << i;
  }
}

TEST(CycleMarks, LeaveOneComponentOfEveryTriangulation) {
  for (const generators::Case& one : generators::cases(1, 1, 40)) {
    if (one.dimension != 3) continue;
    const Filtration<3> filtration(regular_triangulation<3>(one.points()));
    EXPECT_EQ(betti_numbers(filtration, filtration.spectrum_size()), (BettiNumbers<3>{1, 0, 0}))
        << one;
  }
}

template <int D>
void expect_scan(const generators::Case& one) {
  const Filtration<D> filtration(regular_triangulation<D>(one.points()));
  std::vector<ByDimension<D>> entering(filtration.never(), ByDimension<D>{});  // [index]
  for (std::uint32_t row = 0; row < filtration.size(); ++row) {
    const SimplexId simplex(row);
    ++entering[filtration.enters(simplex)][static_cast<std::size_t>(filtration.dimension(simplex))];
  }
  BettiScan<D> scan(filtration), parallel(filtration, Threads(3));
  for (std::uint32_t index = 0; index < filtration.never(); ++index) {
    ASSERT_EQ(scan.index(), index) << one;
    ASSERT_EQ(scan.entering(), entering[index]) << one << " at " << index;
    ASSERT_EQ(scan.betti(), betti_numbers(filtration, index)) << one << " at " << index;
    ASSERT_EQ(parallel.betti(), scan.betti()) << one << " at " << index;
    EXPECT_EQ(scan.next(), index < filtration.spectrum_size()) << one;
    EXPECT_EQ(parallel.next(), index < filtration.spectrum_size()) << one;
  }
  EXPECT_EQ(scan.index(), filtration.spectrum_size()) << one;
}

TEST(BettiScan, TellsWhatJoinsAtEachIndex) {
  for (const generators::Case& one : generators::cases(1, 1, 30)) {
    one.dimension == 2 ? expect_scan<2>(one) : expect_scan<3>(one);
    if (HasFatalFailure()) return;
  }
}

TEST(BettiScan, EndsWhereItBeginsWithoutSites) {
  BettiScan<2> scan{Filtration<2>()};
  EXPECT_FALSE(scan.next());
  EXPECT_EQ(scan.index(), 0U);
  EXPECT_EQ(scan.betti(), (BettiNumbers<2>{0, 0}));
}

TEST(BettiNumbers, OfAHollowOctahedronAreThoseOfASphere) {
  const Filtration<3> filtration =
      filtration_of<3>({1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1});
  EXPECT_EQ(betti_numbers(filtration, 0), (BettiNumbers<3>{0, 0, 0}));
  EXPECT_EQ(betti_numbers(filtration, 1), (BettiNumbers<3>{6, 0, 0}));
  EXPECT_EQ(betti_numbers(filtration, 2), (BettiNumbers<3>{1, 7, 0}));
  EXPECT_EQ(betti_numbers(filtration, 3), (BettiNumbers<3>{1, 0, 1}));
  EXPECT_EQ(betti_numbers(filtration, 4), (BettiNumbers<3>{1, 0, 0}));
  EXPECT_THROW(static_cast<void>(betti_numbers(filtration, 5)), InputError);
}

TEST(BettiNumbers, OfAnAnnulusOfPointsHaveOneHole) {
  std::vector<double> ring;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      if (std::max(std::abs(x), std::abs(y)) < 2) continue;
      ring.insert(ring.end(), {static_cast<double>(x), static_cast<double>(y)});
    }
  }
  const Filtration<2> filtration = filtration_of<2>(ring);
  EXPECT_EQ(betti_numbers(filtration, filtration.index(0.5)), (BettiNumbers<2>{1, 1}));
}

TEST(BettiNumbers, OfCoplanarSitesInSpaceNeverHaveAVoid) {
  const Filtration<3> filtration = filtration_of<3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  for (std::uint32_t i = 0; i <= filtration.spectrum_size(); ++i) {
    EXPECT_EQ(betti_numbers(filtration, i)[2], 0U) << i;
  }
  EXPECT_EQ(betti_numbers(filtration, 2), (BettiNumbers<3>{1, 1, 0}));
  EXPECT_EQ(betti_numbers(filtration, 3), (BettiNumbers<3>{1, 0, 0}));
}

}  // namespace
}  // namespace orthoball
