// SPDX-License-Identifier: MIT
#include "orthoball/queries/inscribed_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace orthoball {
namespace {

// Balls of given radii at the corners of a regular tetrahedron with edges of 2 sqrt(2).
std::array<Sphere<3>, 4> at_tetrahedron(const std::array<double, 4>& radii) {
  std::array<Sphere<3>, 4> balls{{{{1, 1, 1}}, {{1, -1, -1}}, {{-1, 1, -1}}, {{-1, -1, 1}}}};
  for (std::size_t i = 0; i < 4; ++i) {
    balls[i].radius = radii[i];
    balls[i].weight = radii[i] * radii[i];
  }
  return balls;
}

TEST(InscribedBall, BetweenEqualBallsIsAtTheCentre) {
  const auto balls = at_tetrahedron({1, 1, 1, 1});
  const auto inscribed = inscribed_ball<3>(point_of_equal_power<3>(balls), balls);
  for (const double x : inscribed.centre) EXPECT_NEAR(x, 0.0, 1e-15);
  EXPECT_NEAR(inscribed.radius, std::sqrt(3.0) - 1.0, 1e-15);
}

TEST(InscribedBall, TouchesBallsOfDifferentRadii) {
  const auto balls = at_tetrahedron({1.5, 0.5, 0.75, 1.0});
  const auto inscribed = inscribed_ball<3>(point_of_equal_power<3>(balls), balls);
  EXPECT_GT(inscribed.radius, 0.0);
  for (const Sphere<3>& ball : balls) {
    double distance2 = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      distance2 += (inscribed.centre[i] - ball.x[i]) * (inscribed.centre[i] - ball.x[i]);
    }
    EXPECT_NEAR(std::sqrt(distance2), ball.radius + inscribed.radius, 1e-14);
  }
}

TEST(InscribedBall, InThePlaneTouchesThreeDisks) {
  const std::array<Sphere<2>, 3> disks{
      {{{0, 0}, 1, 1}, {{2, 0}, 1, 1}, {{1, std::sqrt(3.0)}, 1, 1}}};
  const auto inscribed = inscribed_ball<2>(point_of_equal_power<2>(disks), disks);
  EXPECT_NEAR(inscribed.radius, 2 / std::sqrt(3.0) - 1.0, 1e-15);  // Soddy's inner circle
  EXPECT_NEAR(inscribed.centre[0], 1.0, 1e-15);
}

TEST(InscribedBall, GivesWayToABallThatIsNearerThanTheCorners) {
  // A small fifth ball near the centre of the tetrahedron: the largest ball beside it touches it.
  const auto corners = at_tetrahedron({1, 1, 1, 1});
  std::vector<Sphere<3>> balls(corners.begin(), corners.end());
  balls.push_back({{0.3, 0.2, 0.1}, 0.0001, 0.01});
  const auto inscribed = inscribed_ball<3>(point_of_equal_power<3>(corners), balls);
  int touched = 0;
  for (const Sphere<3>& ball : balls) {
    const double gap = std::hypot(inscribed.centre[0] - ball.x[0], inscribed.centre[1] - ball.x[1],
                                  inscribed.centre[2] - ball.x[2]) -
                       ball.radius;
    EXPECT_GE(gap, inscribed.radius - 1e-14);
    touched += std::abs(gap - inscribed.radius) < 1e-14 ? 1 : 0;
  }
  EXPECT_EQ(touched, 4);
  EXPECT_GT(inscribed.radius, 0.3);
}

TEST(InscribedBall, IsNoneWhereTheCornersCoverTheirOwnCentre) {
  const auto balls = at_tetrahedron({2, 2, 2, 2});
  EXPECT_LT(inscribed_ball<3>(point_of_equal_power<3>(balls), balls).radius, 0.0);
}

TEST(InscribedBall, IsNoneAroundAPointThatIsNotFinite) {
  const auto balls = at_tetrahedron({1, 1, 1, 1});
  const auto flat = point_of_equal_power<3>({{{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{3, 0, 0}}}});
  EXPECT_LT(ball_around<3>(flat, balls).radius, 0.0);
  EXPECT_LT(inscribed_ball<3>(flat, balls).radius, 0.0);
}

}  // namespace
}  // namespace orthoball
