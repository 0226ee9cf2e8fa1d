// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filter_columns.h"

#include <gtest/gtest.h>

#include "generators/point_families.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
void expect_columns(const WeightedPoints& points) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  const Filter<D> filter(filtration);
  const auto order = filter.by_rows();
  for (const std::uint32_t part : {0U, 1U, 2U}) {
    const std::uint32_t index = filtration.spectrum_size() / 2 * part;
    for (const unsigned threads : {1U, 3U}) {
      const FilterColumns<D> columns(filtration, index, Threads(threads));
      ASSERT_EQ(columns.size(), filter.complex_size(index));
      const auto alpha2 = columns.alpha2(Threads(threads));
      const auto regular = columns.regular(), interior = columns.interior();
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const SimplexId simplex = order[i];
        ASSERT_EQ(columns.simplices()[i], simplex);
        ASSERT_EQ(columns.dimensions()[i], filtration.dimension(simplex));
        ASSERT_EQ(columns.enters()[i], filtration.enters(simplex));
        ASSERT_EQ(alpha2[i], filtration.alpha2(filtration.enters(simplex)));
        ASSERT_EQ(regular[i], filtration.regular(simplex));
        ASSERT_EQ(interior[i], filtration.interior(simplex));
        const auto rows = filtration.rows(simplex);
        for (std::size_t k = 0; k <= D; ++k) {
          ASSERT_EQ(columns.rows()[(D + 1) * i + k], k < rows.size() ? rows[k] : SiteId());
        }
      }
    }
  }
}

TEST(FilterColumns, AreThoseOfTheFilterByRows) {
  for (const auto family : generators::point_families()) {
    SCOPED_TRACE(generators::name(family));
    for (const std::size_t count : {0U, 1U, 3U, 30U}) {
      expect_columns<2>(generators::points_of(family, 2, count, 1));
      expect_columns<3>(generators::points_of(family, 3, count, 2));
    }
  }
}

TEST(FilterColumns, AreTheSameOnSeveralThreadsWhereTiesAreLong) {
  // A grid: most simplices of a dimension enter at one index, in parts of several threads.
  const auto points = generators::points_of(generators::PointFamily::grid, 3, 4000, 1);
  expect_columns<3>(points);
}

}  // namespace
}  // namespace orthoball
