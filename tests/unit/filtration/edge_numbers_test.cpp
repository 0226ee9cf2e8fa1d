// SPDX-License-Identifier: MIT
#include "orthoball/filtration/edge_numbers.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "generators/cases.h"
#include "orthoball/filtration/edge_ring.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// By their definition: edges are pairs of vertices, numbered as cells and slots first meet them.
TEST(EdgeNumbers, CountEdgesAsCellsMeetThem) {
  for (const generators::Case& one : generators::cases(1, 2, 300)) {
    if (one.dimension != 3) continue;
    const auto triangulation = regular_triangulation<3>(one.points());
    const auto cells = triangulation.cells<3>();
    const EdgeNumbers edges = edge_numbers(cells, Threads(1));
    ASSERT_EQ(edges.of_cells.size(), cells.size()) << one;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
      for (std::uint32_t slot = 0; slot < 6; ++slot) {
        const auto [i, j] = kEdgeCorners[slot];
        const auto ends = std::minmax(cells[cell].corners[i], cells[cell].corners[j]);
        const auto number = static_cast<std::uint32_t>(numbers.size());
        const auto [found, is_new] = numbers.emplace(std::pair(ends), number);
        ASSERT_EQ(edges.of_cells[cell][slot], found->second) << one;
        if (!is_new) continue;
        ASSERT_EQ(edges.owners.at(number), 6 * cell + slot) << one;
      }
    }
    ASSERT_EQ(edges.owners.size(), numbers.size()) << one;
  }
}

// Also where ranges are so small that every edge has names of several, and one has no cells.
TEST(EdgeNumbers, DoNotDependOnRangesOrThreads) {
  for (const generators::Case& one : generators::cases(2, 2, 200)) {
    if (one.dimension != 3) continue;
    const auto triangulation = regular_triangulation<3>(one.points());
    const auto cells = triangulation.cells<3>();
    const EdgeNumbers expected = edge_numbers(cells, Threads(1));
    for (const std::size_t ranges : {std::size_t{2}, std::size_t{3}, std::size_t{16},
                                     cells.size() / 2 + 1, cells.size() + 1}) {
      const EdgeNumbers edges = edge_numbers_in_ranges(cells, ranges, Threads(4));
      ASSERT_EQ(edges.of_cells, expected.of_cells) << one << ", " << ranges << " ranges";
      ASSERT_EQ(edges.owners, expected.owners) << one << ", " << ranges << " ranges";
    }
  }
}

}  // namespace
}  // namespace orthoball
