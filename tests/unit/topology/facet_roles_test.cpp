// SPDX-License-Identifier: MIT
#include "orthoball/topology/facet_roles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "generators/cases.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

template <int D>
void expect_roles_by_definition(const Filtration<D>& filtration, const FacetRoles<D>& roles) {
  const std::uint32_t first_cell = filtration.table().first(D);
  const std::uint32_t first_facet = filtration.table().first(D - 1);
  const auto cells = filtration.triangulation().template cells<D>();
  ASSERT_EQ(roles.of_cells().size(), cells.size());
  for (std::uint32_t facet = 0; facet < filtration.count(D - 1); ++facet) {
    const SimplexId simplex(first_facet + facet);
    ASSERT_EQ(roles.is_singular(facet), filtration.enters(simplex) < filtration.regular(simplex));
  }
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint32_t index = filtration.enters(SimplexId(first_cell + cell));
    for (unsigned corner = 0; corner <= D; ++corner) {
      const std::uint32_t beyond = cells[cell].neighbours[corner];
      const std::uint32_t facet = filtration.table().template facet_of_cell<D>(cells, cell, corner);
      const bool enters_with = filtration.enters(SimplexId(first_facet + facet)) == index;
      const bool is_second =
          beyond != kOutside && std::pair(filtration.enters(SimplexId(first_cell + beyond / 4)),
                                          beyond / 4) < std::pair(index, cell);
      const unsigned bits = unsigned{roles.of_cells()[cell]} >> corner;
      ASSERT_EQ((bits & FacetRoles<D>::kIsSecond) != 0, is_second);
      ASSERT_EQ((bits & FacetRoles<D>::kEntersWith) != 0, enters_with);
    }
  }
}

template <int D>
void expect_roles_by_definition(const WeightedPoints& points) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  for (const unsigned threads : {1U, 2U, 7U}) {
    expect_roles_by_definition(filtration, FacetRoles<D>(filtration, Threads(threads)));
  }
}

TEST(FacetRoles, AreThoseOfTheFiltrationOnAnyNumberOfThreads) {
  for (generators::Case one : generators::cases(2, 1, 100)) {
    // Integers of tens of thousands of bits: seconds for dozens of sites.
    if (generators::is_extreme(one.family)) one.count = std::min<std::size_t>(one.count, 12);
    SCOPED_TRACE(::testing::Message() << one);
    one.dimension == 2 ? expect_roles_by_definition<2>(one.points())
                       : expect_roles_by_definition<3>(one.points());
  }
}

}  // namespace
}  // namespace orthoball
