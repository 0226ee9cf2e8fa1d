// SPDX-License-Identifier: MIT
#include "orthoball/exact/corner_block.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "generators/point_families.h"

namespace orthoball {
namespace {

template <int D, std::size_t Corners>
void expect_loaded(std::size_t simplices) {
  const auto points = generators::points_of(generators::PointFamily::uniform_balls, D, 50, 1);
  std::vector<SiteId> rows;
  for (std::uint32_t row = 0; row < points.size(); ++row) rows.emplace_back(row);
  const Sites<D> sites(points, rows);
  std::vector<CornerSites<Corners>> corners(simplices);
  for (std::size_t i = 0; i < simplices; ++i) {
    for (std::size_t c = 0; c < Corners; ++c) {
      corners[i][c] = static_cast<std::uint32_t>((7 * i + 11 * c) % points.size());
    }
  }
  using Block = CornerBlock<D, Corners>;
  const auto block = std::make_unique<Block>();
  load_corners<D, Corners>(sites, corners, *block);
  for (std::size_t i = 0; i < Block::kSize; ++i) {
    for (std::size_t c = 0; c < Corners; ++c) {
      const Site<D> site = i < simplices ? sites[corners[i][c]] : Site<D>{};
      for (std::size_t axis = 0; axis < D; ++axis) {
        ASSERT_EQ(block->x[c][axis][i], site.x[axis]) << i << " of " << simplices;
      }
      ASSERT_EQ(block->weight[c][i], site.weight) << i << " of " << simplices;
    }
  }
}

TEST(CornerBlock, HasTheSitesOfAnyNumberOfSimplices) {
  for (const std::size_t simplices : {0U, 1U, 3U, 4U, 5U, 63U, 64U}) {
    expect_loaded<2, 2>(simplices);
    expect_loaded<2, 3>(simplices);
    expect_loaded<3, 2>(simplices);
    expect_loaded<3, 3>(simplices);
    expect_loaded<3, 4>(simplices);
  }
}

}  // namespace
}  // namespace orthoball
