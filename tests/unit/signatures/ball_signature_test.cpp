// SPDX-License-Identifier: MIT
#include "orthoball/signatures/ball_signature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "generators/cases.h"
#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// From the boundary what the union tells ball by ball.
template <int D>
void expect_unions(const generators::Case& of) {
  SCOPED_TRACE(testing::Message() << of);
  const Filtration<D> filtration(regular_triangulation<D>(of.points()));
  generators::Random random(of.seed);
  std::vector<BallAlpha> alphas{{0, -INFINITY}};
  if (filtration.spectrum_size() > 0) {
    for (int i = 0; i < 6; ++i) {
      const auto index = static_cast<std::uint32_t>(
          random.integer(1, static_cast<int>(filtration.spectrum_size())));
      double alpha2 = filtration.alpha2(index);
      if (i % 2 == 1 && index < filtration.spectrum_size()) {
        alpha2 = (alpha2 + filtration.alpha2(index + 1)) / 2;
      }
      alphas.push_back({index, alpha2});
    }
  }
  const auto found = ball_signatures<D>(filtration, alphas);
  ASSERT_EQ(found.size(), alphas.size());
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const UnionOfBalls expected = union_of_balls(filtration, alphas[i].index, alphas[i].alpha2, {});
    // Errors are relative to what the balls themselves measure.
    double balls = 0.0, spheres = 0.0;
    for (const double x : expected.volumes) balls += x;
    for (const double x : expected.areas) spheres += x;
    EXPECT_NEAR(found[i].volume, expected.volume, 1e-12 * balls + 1e-30);
    EXPECT_NEAR(found[i].area, expected.area, 1e-10 * spheres + 1e-13 * balls);
    EXPECT_EQ(found[i].euler, expected.euler);
    EXPECT_EQ(found[i].index, alphas[i].index);
    EXPECT_EQ(found[i].alpha2, alphas[i].alpha2);
  }
}

TEST(BallSignature, IsTheUnionAtEveryAlpha) {
  for (const generators::Case& one : generators::cases(1, 20, 80)) {
    if (is_extreme(one.family)) continue;
    one.dimension == 2 ? expect_unions<2>(one) : expect_unions<3>(one);
  }
}

TEST(BallSignature, OfTwoDisksGrowing) {
  const Filtration<2> filtration(regular_triangulation<2>({2, {0, 0, 2, 0}, WeightKind::none, {}}));
  const std::vector<BallAlpha> alphas{{filtration.index(0.25), 0.25}, {filtration.index(1.0), 1.0}};
  const auto found = ball_signatures<2>(filtration, alphas);
  EXPECT_NEAR(found[0].volume, 2 * M_PI / 4, 1e-15);
  EXPECT_EQ(found[0].betti[0], 2U);
  EXPECT_NEAR(found[1].volume, 2 * M_PI, 1e-14);  // they touch
  EXPECT_EQ(found[1].betti[0], 1U);
  EXPECT_EQ(found[1].euler, 1);
}

TEST(BallSignature, RefusesAnIndexBeyondTheSpectrum) {
  const Filtration<3> filtration(regular_triangulation<3>(WeightedPoints(3)));
  const std::vector<BallAlpha> alphas{{1, 0.0}};
  EXPECT_THROW(static_cast<void>(ball_signatures<3>(filtration, alphas)), InputError);
}

}  // namespace
}  // namespace orthoball
