// SPDX-License-Identifier: MIT
#include "orthoball/output/filter_lines.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
void check(const WeightedPoints& points, const std::string& name) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  const std::vector<SimplexId> simplices = Filter<D>(filtration).by_rows();
  std::size_t at = 0;
  for_filter_lines(filtration, simplices, [&](std::span<const FilterLine<D>> lines) {
    for (const FilterLine<D>& line : lines) {
      ASSERT_LT(at, simplices.size()) << name;
      const SimplexId simplex = simplices[at++];
      ASSERT_EQ(static_cast<int>(line.dimension), filtration.dimension(simplex)) << name;
      std::size_t i = 0;
      for (const SiteId row : filtration.rows(simplex))
        ASSERT_EQ(line.rows[i++], row.row()) << name;
      ASSERT_EQ(line.enters, filtration.enters(simplex)) << name;
      ASSERT_EQ(line.regular, filtration.regular(simplex)) << name;
      ASSERT_EQ(line.interior, filtration.interior(simplex)) << name;
    }
  });
  EXPECT_EQ(at, simplices.size()) << name;
}

TEST(FilterLines, SayWhatTheFiltrationSaysOfEachSimplex) {
  for (const generators::PointFamily family : generators::point_families()) {
    for (const std::size_t count : {0U, 1U, 3U, 4U, 100U}) {
      const std::string name = generators::name(family) + (" " + std::to_string(count));
      check<2>(generators::points_of(family, 2, count, 7), name);
      check<3>(generators::points_of(family, 3, count, 7), name);
    }
  }
}

TEST(FilterLines, ComeInPiecesOfManySimplices) {
  const auto points = generators::points_of(generators::PointFamily::uniform_balls, 3, 2000, 1);
  check<3>(points, "balls");
}

}  // namespace
}  // namespace orthoball
