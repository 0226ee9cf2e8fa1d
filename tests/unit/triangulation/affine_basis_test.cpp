// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/affine_basis.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace orthoball {
namespace {

AffineBasis<3> basis_of(std::vector<double> coordinates) {
  const WeightedPoints points(3, std::move(coordinates), WeightKind::none, {});
  std::vector<SiteId> rows;
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  for (const std::uint32_t row : order) rows.emplace_back(row);
  return affine_basis(Sites<3>(points, rows), order);
}

TEST(AffineBasis, CountsTheDimensionsThatSitesSpan) {
  EXPECT_EQ(basis_of({}).affine_dimension(), -1);
  EXPECT_EQ(basis_of({1, 2, 3}).affine_dimension(), 0);
  EXPECT_EQ(basis_of({1, 2, 3, 1, 2, 3}).affine_dimension(), 0);
  EXPECT_EQ(basis_of({0, 0, 0, 1, 2, 3, 2, 4, 6}).affine_dimension(), 1);
  EXPECT_EQ(basis_of({0, 0, 0, 1, 2, 3, 2, 4, 7}).affine_dimension(), 2);
  EXPECT_EQ(basis_of({0, 0, 0, 1, 2, 3, 2, 4, 7, 1, 0, 0}).affine_dimension(), 3);
}

TEST(AffineBasis, TakesTheFirstIndependentSites) {
  const auto basis = basis_of({0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 5, 0, 0, 7, 0, 0, 0, 9, 0});
  EXPECT_EQ(basis.sites, (std::vector<std::uint32_t>{0, 2, 4, 6}));
}

TEST(AffineBasis, TakesAxesThatSeparateTheSpan) {
  using Axes = std::array<int, 3>;
  EXPECT_EQ(basis_of({0, 0, 0, 0, 0, 1}).axes, (Axes{2, 0, 1}));           // along z
  EXPECT_EQ(basis_of({0, 0, 0, 0, 1, 1}).axes, (Axes{1, 0, 2}));           // y before z
  EXPECT_EQ(basis_of({0, 0, 0, 1, 1, 0, 2, 2, 5}).axes, (Axes{0, 2, 1}));  // the plane x = y
  EXPECT_EQ(basis_of({4, 0, 0, 4, 1, 0, 4, 0, 1}).axes, (Axes{1, 2, 0}));  // the plane x = 4
  EXPECT_EQ(basis_of({0, 0, 0, 1, 0, 1, 0, 1, 1}).axes, (Axes{0, 1, 2}));
}

// One ulp off a line is a plane.
TEST(AffineBasis, IsExact) {
  EXPECT_EQ(basis_of({0, 0, 0, 0.1, 0.1, 0.1, 0.7, 0.7, 0.7}).affine_dimension(), 1);
  EXPECT_EQ(basis_of({0, 0, 0, 0.1, 0.1, 0.1, 0.7, 0.7, 0.70000000000000007}).affine_dimension(),
            2);
}

}  // namespace
}  // namespace orthoball
