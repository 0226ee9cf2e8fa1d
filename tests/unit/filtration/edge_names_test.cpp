// SPDX-License-Identifier: MIT
#include "orthoball/filtration/edge_names.h"

#include <gtest/gtest.h>

#include <vector>

#include "generators/cases.h"
#include "orthoball/exact/processor.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using Names = std::vector<std::array<std::uint32_t, 6>>;

// Two edges of cells are one exactly if their names have one root.
TEST(EdgeNames, AreUnitedInLanesAsOneByOne) {
  if (!has_avx2()) GTEST_SKIP() << "no lanes on this processor";
  for (const generators::Case& one : generators::cases(3, 2, 300)) {
    if (one.dimension != 3) continue;
    const auto triangulation = regular_triangulation<3>(one.points());
    const auto cells = triangulation.cells<3>();
    const auto size = static_cast<std::uint32_t>(cells.size());
    for (const CellRange range : {CellRange{0, size, 0}, CellRange{size / 3, size, 5}}) {
      Names plain(size), wide(size);
      EdgeNames plain_names(size, 1), wide_names(size, 1);
      const std::uint32_t end =
          edge_names_stages::name_edges_one_by_one(cells, range, plain.data(), plain_names);
      ASSERT_EQ(edge_names_stages::name_edges_in_lanes(cells, range, wide.data(), wide_names), end)
          << one;
      ASSERT_EQ(wide, plain) << one;
      for (std::uint32_t name = range.first_name; name < end; ++name) {
        ASSERT_EQ(wide_names.root_now(name), plain_names.root_now(name)) << one;
      }
    }
  }
}

TEST(EdgeNames, AreUnitedToTheirLeast) {
  EdgeNames names(2, 1);
  for (std::uint32_t name = 0; name < 12; ++name) names[name] = name;
  names.unite(7, 3);
  names.unite(5, 7);
  names.unite(5, 1);
  for (const std::uint32_t name : {1U, 3U, 5U, 7U}) EXPECT_EQ(names.root_now(name), 1U);
  EXPECT_EQ(names.root_now(2), 2U);
}

}  // namespace
}  // namespace orthoball
