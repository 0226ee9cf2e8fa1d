// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "generators/cases.h"
#include "generators/point_families.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;
using generators::PointFamily;

template <int D>
void expect_sorted(const Filtration<D>& filtration) {
  std::vector<SimplexId> expected;
  for (std::uint32_t row = 0; row < filtration.size(); ++row) expected.emplace_back(row);
  std::sort(expected.begin(), expected.end(), [&](SimplexId a, SimplexId b) {
    return std::tuple(filtration.enters(a), filtration.dimension(a), a) <
           std::tuple(filtration.enters(b), filtration.dimension(b), b);
  });
  for (const unsigned threads : {1U, 2U, 5U}) {
    const Filter<D> filter(filtration, Threads(threads));
    ASSERT_EQ(&filter.filtration(), &filtration);
    ASSERT_TRUE(std::equal(filter.simplices().begin(), filter.simplices().end(), expected.begin(),
                           expected.end()))
        << "on " << threads;
  }
}

template <int D>
void expect_cut_at_indices(const Filtration<D>& filtration) {
  const Filter<D> filter(filtration);
  std::size_t position = 0;
  for (std::uint32_t index = 0; index < filtration.never(); ++index) {
    while (position < filter.simplices().size() &&
           filtration.enters(filter.simplices()[position]) <= index) {
      ++position;
    }
    ASSERT_EQ(filter.complex_size(index), position) << index;
    ASSERT_TRUE(filter.starts_index(position)) << index;
  }
  ASSERT_EQ(position, filtration.size());
  std::size_t starts = 0;
  for (std::size_t i = 0; i <= position; ++i) starts += filter.starts_index(i) ? 1U : 0U;
  ASSERT_EQ(starts, filtration.spectrum_size() + 1);
}

template <int D>
void expect_ties_by_rows(const Filtration<D>& filtration) {
  std::vector<SimplexId> expected;
  for (std::uint32_t row = 0; row < filtration.size(); ++row) expected.emplace_back(row);
  const auto key = [&](SimplexId simplex) {
    const auto rows = filtration.rows(simplex);
    return std::tuple(filtration.enters(simplex), filtration.dimension(simplex),
                      std::vector<SiteId>(rows.begin(), rows.end()));
  };
  std::sort(expected.begin(), expected.end(),
            [&](SimplexId a, SimplexId b) { return key(a) < key(b); });
  ASSERT_EQ(Filter<D>(filtration).by_rows(), expected);
}

template <int D>
void expect_filter(const Case& one) {
  const Filtration<D> filtration(regular_triangulation<D>(one.points()));
  expect_sorted(filtration);
  expect_cut_at_indices(filtration);
  expect_ties_by_rows(filtration);
}

TEST(Filter, IsByIndexDimensionAndNumberOnEveryFamily) {
  for (const Case& one : generators::cases(3, 1, 60)) {
    SCOPED_TRACE(testing::Message() << one);
    one.dimension == 2 ? expect_filter<2>(one) : expect_filter<3>(one);
    if (HasFatalFailure()) return;
  }
}

// Large enough for several parts, and where there are many values for several stretches of indices.
TEST(Filter, IsTheSameOnAnyNumberOfThreads) {
  const auto filtration_of = [&]<int D>(PointFamily family, std::size_t count) {
    return Filtration<D>(regular_triangulation<D>(generators::points_of(family, D, count, 3)));
  };
  const Filtration<3> space = filtration_of.operator()<3>(PointFamily::uniform, 20000);
  ASSERT_GT(space.spectrum_size(), 300'000U);
  expect_sorted(space);
  expect_sorted(filtration_of.operator()<2>(PointFamily::uniform_balls, 100000));
  for (const PointFamily family :
       {PointFamily::grid, PointFamily::lattice, PointFamily::duplicated}) {
    SCOPED_TRACE(name(family));
    expect_sorted(filtration_of.operator()<3>(family, 30000));
    expect_sorted(filtration_of.operator()<2>(family, 100000));
  }
}

TEST(Filter, OfNothingIsEmpty) {
  const Filtration<3> nothing;
  const Filter<3> filter(nothing, Threads(4));
  EXPECT_TRUE(filter.simplices().empty());
  EXPECT_TRUE(filter.starts_index(0));
  EXPECT_EQ(filter.complex_size(0), 0U);
  EXPECT_TRUE(filter.by_rows().empty());
}

}  // namespace
}  // namespace orthoball
