// SPDX-License-Identifier: MIT
#include "orthoball/topology/persistence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <ostream>
#include <set>
#include <vector>

#include "generators/cases.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/topology/betti.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {

bool operator==(const PersistencePair& a, const PersistencePair& b) {
  return a.birth == b.birth && a.death == b.death;
}
void PrintTo(const PersistencePair& pair, std::ostream* stream) {
  *stream << pair.birth.row() << " to " << static_cast<std::int64_t>(pair.death.row());
}

namespace {

using generators::Case;

// All pairs by reduction of the whole boundary matrix, column by column in filter order.
template <int D>
PersistencePairs<D> reduced(const Filtration<D>& filtration) {
  const Filter<D> filter(filtration);
  std::map<SimplexId, std::size_t> position;
  for (std::size_t i = 0; i < filter.simplices().size(); ++i) position[filter.simplices()[i]] = i;
  std::map<std::size_t, std::set<std::size_t>> column_of_last;
  std::set<std::size_t> unpaired;
  PersistencePairs<D> pairs;
  const auto add = [&](SimplexId birth, SimplexId death) {
    const int k = filtration.table().dimension(birth);
    ASSERT_LT(k, D);
    pairs[static_cast<std::size_t>(k)].push_back({birth, death});
  };
  for (std::size_t i = 0; i < filter.simplices().size(); ++i) {
    std::set<std::size_t> column;
    const auto flip = [&](std::size_t row) {
      if (!column.insert(row).second) column.erase(row);
    };
    for (const SimplexId facet : filtration.facets(filter.simplices()[i])) flip(position[facet]);
    while (!column.empty() && column_of_last.contains(*column.rbegin())) {
      for (const std::size_t row : std::set(column_of_last[*column.rbegin()])) flip(row);
    }
    if (column.empty()) {
      unpaired.insert(i);
      continue;
    }
    const std::size_t last = *column.rbegin();
    unpaired.erase(last);
    add(filter.simplices()[last], filter.simplices()[i]);
    column_of_last[last] = column;
  }
  for (const std::size_t i : unpaired) add(filter.simplices()[i], SimplexId());
  for (auto& of_dimension : pairs) {
    std::sort(of_dimension.begin(), of_dimension.end(),
              [&](const auto& a, const auto& b) { return position[a.birth] < position[b.birth]; });
  }
  return pairs;
}

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

template <class Check>
void for_each_case(std::size_t largest, const Check& check) {
  for (const Case& one : generators::cases(3, 1, largest)) {
    if (largest > 100 && is_extreme(one.family)) continue;  // whose values take long
    SCOPED_TRACE(::testing::Message() << one);
    if (one.dimension == 2) check(filtration_of<2>(one.points()));
    if (one.dimension == 3) check(filtration_of<3>(one.points()));
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Persistence, OfNothingIsEmpty) {
  const auto pairs = persistence_pairs(filtration_of<3>(WeightedPoints(3)));
  for (const auto& of_dimension : pairs) EXPECT_TRUE(of_dimension.empty());
}

TEST(Persistence, OfOnePointIsAComponentForEver) {
  const auto pairs =
      persistence_pairs(filtration_of<2>(WeightedPoints(2, {1, 2}, WeightKind::none, {})));
  EXPECT_EQ(pairs[0], (std::vector{PersistencePair{SimplexId(0), SimplexId()}}));
  EXPECT_TRUE(pairs[1].empty());
}

// A hole closes with the last side of the square and is filled at its centre.
TEST(Persistence, OfASquareHasOneHole) {
  const Filtration<2> filtration =
      filtration_of<2>(WeightedPoints(2, {1, 1, -1, 1, -1, -1, 1, -1}, WeightKind::none, {}));
  const auto pairs = persistence_pairs(filtration);
  EXPECT_EQ(pairs[0].size(), 4U);
  ASSERT_EQ(pairs[1].size(), 1U);
  EXPECT_EQ(filtration.alpha2(filtration.enters(pairs[1][0].birth)), 1.0);
  EXPECT_EQ(filtration.alpha2(filtration.enters(pairs[1][0].death)), 2.0);
}

TEST(Persistence, IsWhatReductionOfTheWholeMatrixGives) {
  for_each_case(40, []<int D>(const Filtration<D>& filtration) {
    const PersistencePairs<D> expected = reduced(filtration);
    const PersistencePairs<D> found = persistence_pairs(filtration, WantedPairs::all);
    for (std::size_t k = 0; k < D; ++k) EXPECT_EQ(found[k], expected[k]) << k;
  });
}

TEST(Persistence, LeavesOutWhatNeverLives) {
  for_each_case(60, []<int D>(const Filtration<D>& filtration) {
    const PersistencePairs<D> all = persistence_pairs(filtration, WantedPairs::all);
    const PersistencePairs<D> lasting = persistence_pairs(filtration);
    for (std::size_t k = 0; k < D; ++k) {
      std::vector<PersistencePair> expected;
      for (const PersistencePair& pair : all[k]) {
        if (!pair.death.exists() || filtration.enters(pair.birth) < filtration.enters(pair.death)) {
          expected.push_back(pair);
        }
      }
      EXPECT_EQ(lasting[k], expected) << k;
    }
  });
}

TEST(Persistence, OfALengthKeepsWhatLivesSoLongOrForEver) {
  const Filtration<2> filtration =
      filtration_of<2>(WeightedPoints(2, {0, 0, 2, 0, 2, 3, 0, 3, 1, 20}, WeightKind::none, {}));
  const auto pairs = persistence_pairs(filtration);
  const auto counts = [&](double least) {
    const auto kept = pairs_of_length(filtration, pairs, least);
    return std::array{kept[0].size(), kept[1].size()};
  };
  // Deaths of components at 1, 1, 2.25 and far away; the hole lives from 2.25 to 3.25.
  EXPECT_EQ(counts(0.0), (std::array<std::size_t, 2>{pairs[0].size(), pairs[1].size()}));
  EXPECT_EQ(counts(1.0), (std::array<std::size_t, 2>{5, 1}));
  EXPECT_EQ(counts(1.01), (std::array<std::size_t, 2>{3, 0}));
  EXPECT_EQ(counts(3.0), (std::array<std::size_t, 2>{2, 0}));
  EXPECT_EQ(counts(1e9), (std::array<std::size_t, 2>{1, 0}));
}

// As many classes live at every index as the Betti numbers say.
TEST(Persistence, HasTheBettiNumbersOfEveryIndex) {
  for_each_case(300, []<int D>(const Filtration<D>& filtration) {
    const PersistencePairs<D> pairs = persistence_pairs(filtration);
    std::vector<std::array<std::int64_t, std::size_t{D}>> change(filtration.spectrum_size() + 2);
    for (std::size_t k = 0; k < D; ++k) {
      for (const PersistencePair& pair : pairs[k]) {
        ++change[filtration.enters(pair.birth)][k];
        if (pair.death.exists()) --change[filtration.enters(pair.death)][k];
      }
    }
    std::array<std::int64_t, std::size_t{D}> living{};
    BettiScan<D> scan(filtration);
    while (scan.next()) {
      for (std::size_t k = 0; k < D; ++k) {
        living[k] += change[scan.index()][k];
        ASSERT_EQ(living[k], scan.betti()[k]) << "betti " << k << " at " << scan.index();
      }
    }
  });
}

}  // namespace
}  // namespace orthoball
