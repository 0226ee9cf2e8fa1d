// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/cell_store.h"

#include <gtest/gtest.h>

#include <array>

namespace orthoball {
namespace {

TEST(CellStore, KnowsTheVertexAtInfinity) {
  CellStore<3> cells(10);
  EXPECT_GE(cells.infinity(), 10U);
  const std::uint32_t finite = cells.acquire();
  cells[finite].corners = {3, 1, 9, 0};
  EXPECT_TRUE(cells.is_finite(cells[finite]));
  EXPECT_EQ(cells.corner_at_infinity(cells[finite]), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t cell = cells.acquire();
    cells[cell].corners = {3, 1, 9, 0};
    cells[cell].corners[i] = cells.infinity();
    EXPECT_FALSE(cells.is_finite(cells[cell]));
    EXPECT_EQ(cells.corner_at_infinity(cells[cell]), i);
  }
  EXPECT_EQ(cells.size(), 5U);
}

TEST(CellStore, RefusesMoreVerticesThanItCanNumber) {
  const std::size_t most = std::size_t{1} << 30U;
  EXPECT_EQ(CellStore<3>(most).infinity(), most);
  EXPECT_THROW(CellStore<3>(most + 1), LimitError);
  EXPECT_THROW(CellStore<2>((std::size_t{1} << 32U) - 3), LimitError);
}

TEST(CellStore, GivesReleasedCellsAgain) {
  CellStore<2> cells(4);
  const std::uint32_t a = cells.acquire();
  (void)cells.acquire();
  cells.release(std::array{a});
  EXPECT_EQ(cells.acquire(), a);
  EXPECT_EQ(cells.acquire(), 2U);
  EXPECT_EQ(cells.size(), 3U);
}

TEST(CellStore, KnowsDeadCellsAndStillReadsThem) {
  CellStore<2> cells(4);
  const std::uint32_t cell = cells.acquire();
  EXPECT_FALSE(cells.is_dead(cell));
  cells[cell].corners = {3, 0, 2};
  cells.set_dead(cell, true);
  EXPECT_TRUE(cells.is_dead(cell));
  EXPECT_EQ(cells[cell].corners, (std::array{3U, 0U, 2U}));
  cells.set_dead(cell, false);
  EXPECT_FALSE(cells.is_dead(cell));
}

TEST(CellStore, JoinsFacetsBothWays) {
  CellStore<3> cells(8);
  const std::uint32_t a = cells.acquire(), b = cells.acquire();
  cells.join(4 * a + 2, 4 * b + 3);
  EXPECT_EQ(cells[a].neighbours[2], 4 * b + 3);
  EXPECT_EQ(cells[b].neighbours[3], 4 * a + 2);
}

}  // namespace
}  // namespace orthoball
