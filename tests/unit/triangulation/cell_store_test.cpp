// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/cell_store.h"

#include <gtest/gtest.h>

#include <array>

namespace orthoball {
namespace {

TEST(CellStore, KnowsTheVertexAtInfinity) {
  CellStore<3> cells(10, 5);
  EXPECT_EQ(cells.infinity(), 10U);
  const std::uint32_t finite = cells.add(5);
  cells[finite].corners = {3, 1, 9, 0};
  EXPECT_TRUE(cells.is_finite(cells[finite]));
  EXPECT_EQ(cells.corner_at_infinity(cells[finite]), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t cell = finite + 1 + i;
    cells[cell].corners = {3, 1, 9, 0};
    cells[cell].corners[i] = cells.infinity();
    EXPECT_FALSE(cells.is_finite(cells[cell]));
    EXPECT_EQ(cells.corner_at_infinity(cells[cell]), i);
  }
  EXPECT_EQ(cells.size(), 5U);
}

TEST(CellStore, RefusesMoreVerticesThanItCanNumber) {
  const std::size_t most = std::size_t{1} << 29U;
  EXPECT_EQ(CellStore<3>(most, 0).infinity(), most);
  EXPECT_THROW(CellStore<3>(most + 1, 0), LimitError);
  EXPECT_THROW(CellStore<2>((std::size_t{1} << 32U) - 3, 0), LimitError);
}

TEST(CellStore, KeepsItsCellsWhereItGrows) {
  CellStore<2> cells(100, 2);
  for (std::uint32_t i = 0; i < 50; ++i) {
    const std::uint32_t cell = cells.add(1);
    cells[cell] = {{i, i + 1, i + 2}, {4 * i, 4 * i + 1, 4 * i + 2}};
  }
  ASSERT_EQ(cells.size(), 50U);
  for (std::uint32_t i = 0; i < 50; ++i) {
    EXPECT_EQ(cells[i].corners, (std::array{i, i + 1, i + 2}));
    EXPECT_EQ(cells[i].neighbours, (std::array{4 * i, 4 * i + 1, 4 * i + 2}));
  }
}

TEST(CellStore, KnowsDeadCellsAndStillReadsThem) {
  CellStore<2> cells(4, 4);
  const std::uint32_t cell = cells.add(1);
  cells[cell] = {{3, 0, 2}, {12, 5, 6}};
  EXPECT_FALSE(cells.is_dead(cells[cell]));
  cells.kill(cell);
  EXPECT_TRUE(cells.is_dead(cells[cell]));
  EXPECT_EQ(cells[cell].corners, (std::array{3U, 0U, 2U}));
  cells.revive(cell);
  EXPECT_FALSE(cells.is_dead(cells[cell]));
  EXPECT_EQ(cells[cell].neighbours, (std::array{12U, 5U, 6U}));
}

TEST(CellSupply, GivesReleasedCellsFirst) {
  CellStore<2> cells(4, 4);
  CellSupply<2> supply(cells);
  EXPECT_EQ(supply.size(), 0U);
  supply.add(3);
  EXPECT_EQ(supply.size(), 3U);
  EXPECT_EQ(supply.acquire(), 0U);
  EXPECT_EQ(supply.acquire(), 1U);
  supply.release(0);
  EXPECT_TRUE(cells.is_dead(cells[0]));
  EXPECT_EQ(supply.size(), 2U);
  EXPECT_EQ(supply.acquire(), 0U);
  supply.close();
  EXPECT_TRUE(cells.is_dead(cells[2]));
}

TEST(CellStore, JoinsFacetsBothWays) {
  CellStore<3> cells(8, 2);
  const std::uint32_t a = cells.add(1), b = cells.add(1);
  cells.join(4 * a + 2, 4 * b + 3);
  EXPECT_EQ(cells[a].neighbours[2], 4 * b + 3);
  EXPECT_EQ(cells[b].neighbours[3], 4 * a + 2);
}

}  // namespace
}  // namespace orthoball
