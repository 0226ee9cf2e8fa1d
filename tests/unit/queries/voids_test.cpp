// SPDX-License-Identifier: MIT
#include "orthoball/queries/voids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/topology/betti.h"
#include "unit/queries/filtration_of.h"

namespace orthoball {
namespace {

// [index]: from 0 on.
template <int D>
std::vector<BettiNumbers<D>> betti_at_all(const Filtration<D>& filtration) {
  std::vector<BettiNumbers<D>> betti;
  for (std::uint32_t index = 0; index <= filtration.spectrum_size(); ++index) {
    betti.push_back(betti_numbers(filtration, index));
  }
  return betti;
}

// The corners of an octahedron as balls of one radius: with 0.9 they close a void.
WeightedPoints octahedron(double radius) {
  return {3,
          {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
          WeightKind::radius,
          std::vector<double>(6, radius)};
}

TEST(Voids, OfAnOctahedronOfBalls) {
  const auto filtration = filtration_of<3>(octahedron(0.9));
  const auto found = voids(filtration, filtration.index(0.0), 0.0, VoidsOf::balls);
  ASSERT_EQ(found.size(), 1U);
  const Void<3>& one = found[0];
  EXPECT_NEAR(one.area, 0.2864, 5e-5);  // sampled, like the next
  EXPECT_NEAR(one.volume, 0.00907, 5e-6);
  ASSERT_EQ(one.lining.size(), 6U);
  double area = 0.0;
  for (std::uint32_t i = 0; i < 6; ++i) {
    EXPECT_EQ(one.lining[i].row, SiteId(i));
    EXPECT_NEAR(one.lining[i].area, one.area / 6, 1e-14);
    area += one.lining[i].area;
  }
  EXPECT_NEAR(area, one.area, 1e-15);
  EXPECT_EQ(one.cells.size(), 4U);
  EXPECT_NEAR(one.born_alpha2, 2.0 / 3 - 0.81, 1e-15);
  EXPECT_NEAR(one.dies_alpha2, 1.0 - 0.81, 1e-15);
  EXPECT_NEAR(one.largest_ball_radius, 0.1, 1e-15);
  for (const double x : one.largest_ball_centre) EXPECT_NEAR(x, 0.0, 1e-15);
}

TEST(Voids, OfTheShapeIsThePolyhedronInside) {
  const auto filtration = filtration_of<3>(octahedron(0.9));
  const auto found = voids(filtration, filtration.index(0.0), 0.0, VoidsOf::shape);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].volume, 4.0 / 3, 1e-14);
  EXPECT_NEAR(found[0].area, 4 * std::sqrt(3.0), 1e-14);
  EXPECT_EQ(found[0].largest_ball_radius, 0.0);  // that of the corners would reach out
}

TEST(Voids, AreNoneBeforeTheirBirthAndAfterTheirDeath) {
  const auto filtration = filtration_of<3>(octahedron(0.9));
  const auto one = voids(filtration, filtration.index(0.0), 0.0, VoidsOf::balls);
  for (std::uint32_t index = 0; index <= filtration.spectrum_size(); ++index) {
    const double alpha2 = index == 0 ? -1.0 : filtration.alpha2(index);
    const bool lives = one[0].born <= index && index < one[0].dies;
    EXPECT_EQ(voids(filtration, index, alpha2, VoidsOf::balls).size(), lives ? 1U : 0U);
  }
}

TEST(Voids, OfTheLatticeAroundAnEmptySite) {
  std::vector<double> x;
  for (int i = 0; i < 27; ++i) {
    if (i == 13) continue;
    for (const int c : {i / 9, i / 3 % 3, i % 3}) x.push_back(c);
  }
  const auto filtration =
      filtration_of<3>({3, x, WeightKind::radius, std::vector<double>(26, 0.8125)});
  const auto found = voids(filtration, filtration.index(0.0), 0.0, VoidsOf::balls);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].volume, 0.0829, 3 * 0.0019);  // sampled
  EXPECT_EQ(found[0].lining.size(), 26U);
  EXPECT_NEAR(found[0].largest_ball_radius, 1 - 0.8125, 1e-15);
}

TEST(Voids, InThePlaneAreHoles) {
  // Four disks around a hole: a square less four quarters of what disks and lenses cover.
  const double r = 0.6;
  const auto filtration = filtration_of<2>(
      {2, {0, 0, 1, 0, 0, 1, 1, 1}, WeightKind::radius, std::vector<double>(4, r)});
  const auto found = voids(filtration, filtration.index(0.0), 0.0, VoidsOf::balls);
  ASSERT_EQ(found.size(), 1U);
  const double opening = std::acos(0.5 / r);
  const double angle = std::numbers::pi / 2 - 2 * opening;
  EXPECT_NEAR(found[0].area, 4 * r * angle, 1e-15);
  EXPECT_NEAR(found[0].volume, 1 - 4 * (0.25 * std::tan(opening) + r * r * angle / 2), 1e-15);
  EXPECT_NEAR(found[0].largest_ball_radius, std::sqrt(0.5) - r, 1e-15);
  EXPECT_EQ(found[0].lining.size(), 4U);
}

TEST(Voids, HaveNoBallLargerThanThemselves) {
  // Corners of a large cube but for the last bits: where the orthocentres of its flat cells lie is
  // rounding.
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    generators::Random random(seed);
    constexpr double kSide = 4e15;
    std::vector<double> x;
    for (int i = 0; i < 8; ++i) {
      for (const int bit : {i & 1, i >> 1 & 1, i >> 2 & 1}) {
        x.push_back((bit != 0 ? kSide : -kSide) + random.integer(-1, 1));
      }
    }
    const auto filtration = filtration_of<3>({3, x, WeightKind::none, {}});
    const double alpha2 = 2.2 * kSide * kSide;
    for (const auto& one : voids(filtration, filtration.index(alpha2), alpha2, VoidsOf::balls)) {
      EXPECT_LT(one.largest_ball_radius, kSide) << seed;
    }
  }
}

TEST(Voids, RefuseAnAlphaThatIsNoNumber) {
  const auto filtration = filtration_of<3>(octahedron(0.9));
  for (const double alpha2 : {std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(static_cast<void>(voids(filtration, 1, alpha2, VoidsOf::balls)), InputError);
    EXPECT_THROW(static_cast<void>(union_of_balls(filtration, 1, alpha2, {})), InputError);
  }
}

TEST(Voids, AreNoneOfFlatSitesAndOfNone) {
  EXPECT_TRUE(voids(filtration_of<3>(WeightedPoints(3)), 0, 0.0, VoidsOf::balls).empty());
  const auto flat = filtration_of<3>(
      {3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, WeightKind::radius, {0.6, 0.6, 0.6, 0.6}});
  EXPECT_TRUE(voids(flat, flat.index(0.0), 0.0, VoidsOf::balls).empty());
  EXPECT_THROW(static_cast<void>(voids(flat, 99, 0.0, VoidsOf::balls)), InputError);
}

// Void by void: their number is the last Betti number, they live exactly from born to dies, their
// surfaces and the outer one are the union's, and volume shrinks by the surface as balls grow.
template <int D>
void expect_laws(const WeightedPoints& points, std::uint64_t seed) {
  const auto filtration = filtration_of<D>(points);
  const auto betti = betti_at_all(filtration);
  generators::Random random(seed);
  for (int round = 0; round < 12 && filtration.spectrum_size() > 1; ++round) {
    const auto index = static_cast<std::uint32_t>(
        random.integer(1, static_cast<int>(filtration.spectrum_size()) - 1));
    const double low = filtration.alpha2(index), high = filtration.alpha2(index + 1);
    const double alpha2 = (low + high) / 2;
    const auto found = voids(filtration, index, alpha2, VoidsOf::balls);
    ASSERT_EQ(found.size(), betti[index][D - 1]);
    const UnionOfBalls balls = union_of_balls(filtration, index, alpha2, {});
    double area = 0.0;
    for (const Void<D>& one : found) {
      EXPECT_LE(one.born, index);
      EXPECT_GT(one.dies, index);
      area += one.area;
      // A step to both sides, where nothing happens and the void hardly changes.
      const double step = std::min((high - low) / 8, 1e-3 * (one.dies_alpha2 - alpha2));
      const auto later = voids(filtration, index, alpha2 + step, VoidsOf::balls);
      const auto before = voids(filtration, index, alpha2 - step, VoidsOf::balls);
      double shrinks = 0.0;
      for (const LiningBall& ball : one.lining) {
        const double weight = points.weight(ball.row.row()) + alpha2;
        if (weight > 0.0) shrinks += ball.area / (2 * std::sqrt(weight));
        EXPECT_LE(ball.area, balls.areas[ball.row.row()] * (1 + 1e-9) + 1e-12);
      }
      const auto same = [&](const std::vector<Void<D>>& all) {
        for (const Void<D>& other : all) {
          if (other.cells == one.cells) return other.volume;
        }
        return std::nan("");
      };
      const double slope = (same(before) - same(later)) / (2 * step);
      EXPECT_NEAR(slope, shrinks, 1e-3 * shrinks + 1e-14 / step);
    }
    EXPECT_LE(area, balls.area * (1 + 1e-12));
  }
}

TEST(Voids, KeepTheirLaws) {
  using generators::PointFamily;
  for (const PointFamily family : {PointFamily::uniform, PointFamily::uniform_balls,
                                   PointFamily::gaussian, PointFamily::protein_like}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      expect_laws<3>(points_of(family, 3, 200, seed), seed);
      expect_laws<2>(points_of(family, 2, 100, seed), seed);
    }
  }
}

TEST(Voids, AreBornWhereOneIsDivided) {
  // All voids at all indices of a small set: one that dies at `dies` is there from `born` on, and
  // at no index before, whatever it is divided from.
  const auto filtration = filtration_of<3>(points_of(generators::PointFamily::uniform, 3, 60, 5));
  const auto betti = betti_at_all(filtration);
  std::vector<std::uint32_t> births(filtration.spectrum_size() + 2, 0), deaths = births;
  std::vector<std::vector<std::uint32_t>> born_of_dying(filtration.spectrum_size() + 2);
  for (std::uint32_t index = 1; index <= filtration.spectrum_size(); ++index) {
    for (const auto& one : voids(filtration, index, filtration.alpha2(index), VoidsOf::balls)) {
      EXPECT_LE(one.born, index);
      born_of_dying[one.dies].push_back(one.born);
      if (one.born == index) ++births[index];
      if (one.dies == index + 1) ++deaths[index + 1];
    }
  }
  // Each void that dies at one index has one birth, whenever it is asked.
  for (std::uint32_t index = 1; index <= filtration.spectrum_size(); ++index) {
    auto& born = born_of_dying[index];
    std::sort(born.begin(), born.end());
    born.erase(std::unique(born.begin(), born.end()), born.end());
    EXPECT_LE(born.size(), std::max(1U, deaths[index]));
    EXPECT_EQ(static_cast<int>(betti[index][2]) - static_cast<int>(betti[index - 1][2]),
              static_cast<int>(births[index]) - static_cast<int>(deaths[index]));
  }
}

TEST(Voids, DoNotDependOnThreads) {
  const auto filtration = filtration_of<3>(points_of(generators::PointFamily::uniform, 3, 3000, 1));
  const double alpha2 = filtration.alpha2(filtration.spectrum_size() / 3);
  const std::uint32_t index = filtration.index(alpha2);
  const auto one = voids(filtration, index, alpha2, VoidsOf::balls, Threads(1));
  const auto four = voids(filtration, index, alpha2, VoidsOf::balls, Threads(4));
  ASSERT_GT(one.size(), 5U);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].volume, four[i].volume);
    EXPECT_EQ(one[i].cells, four[i].cells);
    EXPECT_EQ(one[i].largest_ball_radius, four[i].largest_ball_radius);
  }
}

}  // namespace
}  // namespace orthoball
