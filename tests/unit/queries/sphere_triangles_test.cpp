// SPDX-License-Identifier: MIT
#include "orthoball/queries/sphere_triangles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orthoball {
namespace {

TEST(SphereTriangles, AreAnIcosahedronDividedUntilItIsNearEnough) {
  std::size_t count = 20;
  for (const double tolerance : {0.21, 0.07, 0.02, 0.005}) {
    const SphereTriangles found = sphere_triangles(tolerance);
    EXPECT_EQ(found.all.size(), count);
    EXPECT_EQ(found.corners.size(), count / 2 + 2);
    count *= 4;
    for (const auto& corner : found.corners) {
      EXPECT_NEAR(std::hypot(corner[0], corner[1], corner[2]), 1.0, 1e-15);
    }
    for (const auto& triangle : found.all) {
      std::array<double, 3> middle{};
      for (const std::uint32_t corner : triangle) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          middle[axis] += found.corners[corner][axis] / 3;
        }
      }
      EXPECT_GT(std::hypot(middle[0], middle[1], middle[2]), 1 - tolerance);
    }
  }
}

}  // namespace
}  // namespace orthoball
