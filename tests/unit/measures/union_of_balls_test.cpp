// SPDX-License-Identifier: MIT
#include "orthoball/measures/union_of_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "generators/cases.h"
#include "generators/random.h"
#include "oracles/cut_ball.h"
#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using oracles::CutBall;
using std::numbers::pi;

const UnionOptions kEverything{.contacts = true, .derivatives = true, .threads = Threads(1)};

template <int D>
UnionOfBalls union_of(const WeightedPoints& points, double alpha2 = 0.0) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  return union_of_balls(filtration, filtration.index(alpha2), alpha2, kEverything);
}
template <int D>
UnionOfBalls union_of(std::vector<double> coordinates, std::vector<double> radii) {
  return union_of<D>(
      WeightedPoints(D, std::move(coordinates), WeightKind::radius, std::move(radii)));
}
// All of one radius.
UnionOfBalls union_of_equal(const std::vector<double>& coordinates, double radius) {
  return union_of<3>(coordinates, std::vector<double>(coordinates.size() / 3, radius));
}

TEST(UnionOfBalls, OfNothingIsEmpty) {
  const UnionOfBalls none = union_of<3>(WeightedPoints(3));
  EXPECT_EQ(none.volume, 0.0);
  EXPECT_EQ(none.area, 0.0);
  EXPECT_EQ(none.mean_curvature, 0.0);
  EXPECT_EQ(none.euler, 0);
  EXPECT_TRUE(none.volumes.empty());
  EXPECT_TRUE(none.contacts.empty());
  EXPECT_TRUE(none.derivatives.volume_by_centre.empty());
}

TEST(UnionOfBalls, OfOneBallIsTheBall) {
  const UnionOfBalls ball = union_of<3>({1, 2, 3}, {2});
  EXPECT_DOUBLE_EQ(ball.volume, 32 * pi / 3);
  EXPECT_DOUBLE_EQ(ball.area, 16 * pi);
  EXPECT_DOUBLE_EQ(ball.mean_curvature, 8 * pi);
  EXPECT_EQ(ball.euler, 1);
  EXPECT_EQ(ball.volumes, std::vector<double>{ball.volume});
  EXPECT_EQ(ball.areas, std::vector<double>{ball.area});
  EXPECT_DOUBLE_EQ(ball.derivatives.area_by_radius[0], 16 * pi);
  EXPECT_EQ(ball.derivatives.volume_by_centre, (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(ball.derivatives.area_by_centre, (std::vector<double>{0, 0, 0}));

  const UnionOfBalls disk = union_of<2>({1, 2}, {3});
  EXPECT_DOUBLE_EQ(disk.volume, 9 * pi);
  EXPECT_DOUBLE_EQ(disk.area, 6 * pi);
  EXPECT_EQ(disk.mean_curvature, 0.0);
  EXPECT_DOUBLE_EQ(disk.derivatives.area_by_radius[0], 2 * pi);
}

TEST(UnionOfBalls, OfPointsIsNothing) {
  const UnionOfBalls points =
      union_of<3>(WeightedPoints(3, {0, 0, 0, 1, 2, 3}, WeightKind::none, {}));
  EXPECT_EQ(points.volume, 0.0);
  EXPECT_EQ(points.euler, 2);
}

TEST(UnionOfBalls, OfTwoUnitBallsHasClosedForms) {
  const UnionOfBalls two = union_of<3>({0, 0, 0, 0, 1, 0}, {1, 1});
  EXPECT_NEAR(two.volume, 8 * pi / 3 - 5 * pi / 12, 4e-15);
  EXPECT_NEAR(two.area, 6 * pi, 1e-14);
  EXPECT_NEAR(two.mean_curvature, 6 * pi - pi * pi * std::sqrt(3.0) / 6, 1e-14);
  EXPECT_NEAR(two.mean_curvature, 16.0004465427, 5e-11);
  EXPECT_EQ(two.euler, 1);
  ASSERT_EQ(two.contacts.size(), 1U);
  EXPECT_EQ(two.contacts[0].rows, (std::array{SiteId(0), SiteId(1)}));
  EXPECT_DOUBLE_EQ(two.contacts[0].area, 0.75 * pi);
  EXPECT_DOUBLE_EQ(two.contacts[0].exposed_length, pi * std::sqrt(3.0));
  // V = 4 pi / 3 + pi (d - d^3 / 12), A = 4 pi + 2 pi d.
  EXPECT_NEAR(two.derivatives.volume_by_centre[4], 0.75 * pi, 1e-14);
  EXPECT_NEAR(two.derivatives.volume_by_centre[1], -0.75 * pi, 1e-14);
  EXPECT_NEAR(two.derivatives.area_by_centre[4], 2 * pi, 1e-14);
  EXPECT_NEAR(two.derivatives.area_by_centre[1], -2 * pi, 1e-14);
  EXPECT_NEAR(two.derivatives.volume_by_centre[0], 0.0, 1e-15);

  const UnionOfBalls disks = union_of<2>({0, 0, 1, 0}, {1, 1});
  EXPECT_NEAR(disks.volume, 2 * pi - (2 * pi / 3 - std::sqrt(3.0) / 2), 4e-15);
  EXPECT_NEAR(disks.area, 8 * pi / 3, 4e-15);
  ASSERT_EQ(disks.contacts.size(), 1U);
  EXPECT_DOUBLE_EQ(disks.contacts[0].area, std::sqrt(3.0));
  EXPECT_EQ(disks.contacts[0].exposed_length, 2.0);
}

TEST(UnionOfBalls, OfBallsApartOrInTouchIsTheirSum) {
  for (const double distance : {3.0, 4.0}) {
    const UnionOfBalls two = union_of<3>({0, 0, 0, 0, 0, distance}, {1, 2});
    EXPECT_NEAR(two.volume, 36 * pi / 3, 1e-13);
    EXPECT_NEAR(two.area, 20 * pi, 1e-13);
    EXPECT_NEAR(two.mean_curvature, 12 * pi, 1e-13);
    EXPECT_EQ(two.euler, distance == 3.0 ? 1 : 2);
    EXPECT_EQ(two.contacts.size(), distance == 3.0 ? 1U : 0U);
  }
}

// Of AlphaMol, whose mean curvature is that of the spheres and of half the arcs.
TEST(UnionOfBalls, OfThreeAndFourUnitBallsAgreesWithAlphaMol) {
  const UnionOfBalls three = union_of_equal({0, 0, 0, 1, 0, 0, 0, 1, 0}, 1);
  EXPECT_NEAR(three.area, 24.39501006, 5e-9);
  EXPECT_NEAR(three.volume, 9.83075054, 5e-9);
  EXPECT_NEAR(three.mean_curvature, 18.684827925, 5e-9);
  EXPECT_EQ(three.euler, 1);
  const UnionOfBalls four = union_of_equal({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 1);
  EXPECT_NEAR(four.area, 29.24866298, 5e-9);
  EXPECT_NEAR(four.volume, 12.47766970, 5e-9);
  EXPECT_NEAR(four.mean_curvature, 20.76934359, 5e-9);
  EXPECT_EQ(four.euler, 1);
}

// Shells around a void, about five digits of them by sampling.
TEST(UnionOfBalls, OfShellsCountsTheirVoids) {
  const auto expect = [](const UnionOfBalls& shell, double volume, double outer, double inner) {
    EXPECT_NEAR(shell.volume, volume, 2e-4 * volume);
    EXPECT_NEAR(shell.area, outer + inner, 2e-4 * outer);
    EXPECT_EQ(shell.euler, 2);
    for (const double one : shell.areas) EXPECT_NEAR(one, shell.areas[0], 1e-13);
    for (const double one : shell.volumes) EXPECT_NEAR(one, shell.volumes[0], 1e-13);
  };
  expect(union_of_equal({1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1}, 0.9), 16.0878,
         37.888, 0.2864);
  std::vector<double> cube, icosahedron;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) cube.push_back(corner >> axis & 1);
  }
  expect(union_of_equal(cube, 0.8), 12.4887, 30.2587, 0.0994);
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (std::size_t turn = 0; turn < 3; ++turn) {
    for (const double one : {-0.5, 0.5}) {
      for (const double other : {-golden / 2, golden / 2}) {
        std::array<double, 3> x{};
        x[turn] = one;
        x[(turn + 1) % 3] = other;
        icosahedron.insert(icosahedron.end(), x.begin(), x.end());
      }
    }
  }
  expect(union_of_equal(icosahedron, 0.7), 13.0644, 31.941, 1.2927);
}

// The corners of a truncated icosahedron of edge 2: even permutations and all signs.
std::vector<double> truncated_icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::vector<double> result;
  for (const std::array<double, 3>& x :
       {std::array{0.0, 1.0, 3 * golden}, std::array{1.0, 2 + golden, 2 * golden},
        std::array{golden, 2.0, 2 * golden + 1}}) {
    for (std::size_t turn = 0; turn < 3; ++turn) {
      for (unsigned signs = 0; signs < 8; signs += x[0] == 0.0 ? 2U : 1U) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t from = (axis + turn) % 3;
          result.push_back((signs >> from & 1U) != 0 ? -x[from] : x[from]);
        }
      }
    }
  }
  return result;
}

TEST(UnionOfBalls, OfABuckyballCountsItsVoid) {
  std::vector<double> coordinates = truncated_icosahedron();
  ASSERT_EQ(coordinates.size(), 180U);
  for (double& x : coordinates) x *= 1.43 / 2;
  const UnionOfBalls shell = union_of_equal(coordinates, 1.7);
  EXPECT_NEAR(shell.volume, 500.165, 2e-4 * 500);
  EXPECT_NEAR(shell.area, 349.280 + 52.535, 2e-4 * 400);
  EXPECT_EQ(shell.euler, 2);
  for (const double one : shell.areas) EXPECT_NEAR(one, shell.areas[0], 1e-11);
}

TEST(UnionOfBalls, LeavesOutEmptyAndHiddenBalls) {
  // Row 1 has no radius, row 2 is inside row 0, row 3 is row 0 again, row 4 is apart.
  const UnionOfBalls balls =
      union_of<3>({0, 0, 0, 0, 0, 1, 0.25, 0, 0, 0, 0, 0, 9, 0, 0}, {1, -0.5, 0.5, 1, 1});
  EXPECT_DOUBLE_EQ(balls.volume, 8 * pi / 3);
  EXPECT_DOUBLE_EQ(balls.area, 8 * pi);
  EXPECT_EQ(balls.volumes[1], 0.0);
  EXPECT_EQ(balls.volumes[2], 0.0);
  EXPECT_EQ(balls.volumes[3], 0.0);
  EXPECT_DOUBLE_EQ(balls.volumes[0], balls.volumes[4]);
  EXPECT_EQ(balls.areas[3], 0.0);
  EXPECT_EQ(balls.euler, 2);
  for (const Contact& contact : balls.contacts) EXPECT_EQ(contact.exposed_length, 0.0);
}

TEST(UnionOfBalls, BelowTheFirstEntryIsEmpty) {
  const WeightedPoints points(3, {0, 0, 0, 1, 0, 0, 0, 1, 0}, WeightKind::weight, {1, 2, 3});
  const UnionOfBalls none = union_of<3>(points, -3.5);
  EXPECT_EQ(none.index, 0U);
  EXPECT_EQ(none.alpha2, -3.5);
  EXPECT_EQ(none.volume, 0.0);
  EXPECT_EQ(none.area, 0.0);
  EXPECT_EQ(none.euler, 0);
  EXPECT_EQ(none.volumes, std::vector<double>(3, 0.0));
  EXPECT_EQ(none.derivatives.area_by_radius, std::vector<double>(3, 0.0));
  EXPECT_TRUE(none.contacts.empty());
}

TEST(UnionOfBalls, GivesWhatIsWantedOnly) {
  const Filtration<3> filtration(
      regular_triangulation<3>(WeightedPoints(3, {0, 0, 0, 1, 0, 0}, WeightKind::radius, {1, 1})));
  const UnionOfBalls plain = union_of_balls(filtration, filtration.index(0.0), 0.0, {});
  EXPECT_TRUE(plain.contacts.empty());
  EXPECT_TRUE(plain.derivatives.area_by_radius.empty());
  EXPECT_TRUE(plain.derivatives.volume_by_centre.empty());
  EXPECT_TRUE(plain.derivatives.area_by_centre.empty());
  EXPECT_EQ(plain.volumes.size(), 2U);
}

TEST(UnionOfBalls, RefusesAnIndexBeyondTheSpectrum) {
  const Filtration<2> filtration(
      regular_triangulation<2>(WeightedPoints(2, {0, 0, 1, 0}, WeightKind::none, {})));
  ASSERT_EQ(filtration.spectrum_size(), 2U);
  EXPECT_NO_THROW((void)union_of_balls(filtration, 2, 1.0, {}));
  try {
    (void)union_of_balls(filtration, 3, 1.0, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.reason(), InputError::Reason::wrong_argument);
    EXPECT_NE(std::string(error.what()).find("indices are 0 to 2"), std::string::npos)
        << error.what();
  }
}

TEST(UnionOfBalls, RefusesAnAlpha2ThatIsNotFinite) {
  const Filtration<2> filtration(
      regular_triangulation<2>(WeightedPoints(2, {0, 0, 1, 0}, WeightKind::none, {})));
  for (const double alpha2 :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    try {
      (void)union_of_balls(filtration, 2, alpha2, {});
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.reason(), InputError::Reason::not_finite);
    }
  }
}

// Far larger than all distances, in a unit in which their volume would overflow.
TEST(UnionOfBalls, OfBallsAroundNearlyOnePointIsABall) {
  const WeightedPoints points(3, {0, 0, 0, 1e-150, 0, 0, 0, 1e-160, 0, 0, 0, 1e-155},
                              WeightKind::none, {});
  for (const double radius : {1e-90, 1.0, 1e+50}) {
    const UnionOfBalls found = union_of<3>(points, radius * radius);
    EXPECT_NEAR(found.volume / std::pow(radius, 3), 4 * pi / 3, 1e-14);
    EXPECT_NEAR(found.area / std::pow(radius, 2), 4 * pi, 1e-13);
    EXPECT_NEAR(found.mean_curvature / radius, 4 * pi, 1e-13);
  }
  const UnionOfBalls decimals =
      union_of<2>(WeightedPoints::fixed_point(2, 400, {0, 0, 0, 100}, WeightKind::none, {}), 9.0);
  EXPECT_NEAR(decimals.volume, 9 * pi, 1e-13);
  EXPECT_NEAR(decimals.area, 6 * pi, 1e-13);
}

// Decimals are lengths in their own unit, alpha2 one in input units.
TEST(UnionOfBalls, OfDecimalsIsInInputUnits) {
  const UnionOfBalls two =
      union_of<3>(WeightedPoints::fixed_point(3, 2, {0, 0, 0, 0, 100, 0}, WeightKind::none, {}), 1);
  EXPECT_NEAR(two.volume, 8 * pi / 3 - 5 * pi / 12, 4e-15);
  EXPECT_NEAR(two.area, 6 * pi, 1e-14);
  EXPECT_NEAR(two.mean_curvature, 16.0004465427, 5e-11);
  EXPECT_NEAR(two.contacts[0].area, 0.75 * pi, 1e-15);
  EXPECT_NEAR(two.contacts[0].exposed_length, pi * std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(two.derivatives.area_by_centre[4], 2 * pi, 1e-14);
}

// Parts, surfaces and contacts of all balls by slices of each ball's power cell. Only balls that
// are not empty count, of equal ones the first.
template <int D>
void expect_slices(const WeightedPoints& points, double alpha2) {
  std::vector<CutBall> balls;
  std::vector<std::uint32_t> rows;
  double largest = 0.0;
  for (std::uint32_t row = 0; row < points.size(); ++row) {
    const double weight = points.weight(row) + alpha2;
    if (weight <= 0.0) continue;
    CutBall ball;
    for (int axis = 0; axis < D; ++axis) ball.centre.push_back(points.coordinate(row, axis));
    ball.radius = std::sqrt(weight);
    const auto is_the_same = [&](const CutBall& other) {
      return other.centre == ball.centre && other.radius == ball.radius;
    };
    if (std::any_of(balls.begin(), balls.end(), is_the_same)) continue;
    largest = std::max(largest, ball.radius);
    balls.push_back(ball);
    rows.push_back(row);
  }
  for (CutBall& ball : balls) {
    for (const CutBall& other : balls) {
      if (&ball != &other) ball.cuts.push_back(where_power_is_less(ball, other));
    }
  }

  const UnionOfBalls found = union_of<D>(points, alpha2);
  std::map<std::array<SiteId, 2>, Contact> contacts;
  for (const Contact& contact : found.contacts) {
    EXPECT_LT(contact.rows[0], contact.rows[1]);
    EXPECT_TRUE(contacts.emplace(contact.rows, contact).second) << "twice";
  }
  std::vector<double> volumes(points.size()), areas(points.size());
  bool has_flat_parts = false;  // between those that touch there: only one pair has the contact
  for (std::size_t i = 0; i < balls.size(); ++i) {
    volumes[rows[i]] = volume(balls[i]);
    areas[rows[i]] = area(balls[i]);
    if (volumes[rows[i]] < 1e-12 * std::pow(largest, D)) has_flat_parts = true;
  }
  for (std::size_t i = 0; i < balls.size() && !has_flat_parts; ++i) {
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      const CutBall shared = facet(balls[i], j - 1);
      const auto at = contacts.find({SiteId(rows[i]), SiteId(rows[j])});
      const Contact contact = at == contacts.end() ? Contact{} : at->second;
      EXPECT_NEAR(contact.area, volume(shared), 1e-10 * std::pow(largest, D - 1))
          << rows[i] << ' ' << rows[j];
      // An end just at a corner is in or out as rounding has it.
      if (contact.area < 1e-9 * std::pow(largest, D - 1)) continue;
      CutBall smaller = shared, larger = shared;
      smaller.radius *= 1 - 1e-9;
      larger.radius *= 1 + 1e-9;
      const auto [least, most] = std::minmax({area(smaller), area(shared), area(larger)});
      const double rounding = 1e-9 * std::pow(largest, D - 2);
      EXPECT_GE(contact.exposed_length, least - rounding) << rows[i] << ' ' << rows[j];
      EXPECT_LE(contact.exposed_length, most + rounding) << rows[i] << ' ' << rows[j];
    }
  }
  double volume = 0.0, area = 0.0;
  for (std::uint32_t row = 0; row < points.size(); ++row) {
    EXPECT_NEAR(found.volumes[row], volumes[row], 1e-10 * std::pow(largest, D)) << row;
    EXPECT_NEAR(found.areas[row], areas[row], 1e-9 * std::pow(largest, D - 1)) << row;
    volume += volumes[row];
    area += areas[row];
  }
  EXPECT_NEAR(found.volume, volume, 1e-9 * std::pow(largest, D));
  EXPECT_NEAR(found.area, area, 1e-8 * std::pow(largest, D - 1));
}

TEST(UnionOfBalls, HasThePartsAndContactsThatPowerCellsCut) {
  const auto expect = []<int D>() {
    for (const PointFamily family : generators::point_families()) {
      if (generators::is_extreme(family) || family == PointFamily::one_ulp) continue;
      for (std::uint64_t seed = 0; seed < 2; ++seed) {
        SCOPED_TRACE(::testing::Message() << name(family) << ' ' << D << "D " << seed);
        const WeightedPoints points = generators::points_of(family, D, D == 2 ? 14 : 8, seed);
        const Filtration<D> filtration(regular_triangulation<D>(points));
        // Between entries, a third and two thirds up the spectrum.
        for (const std::uint32_t third : {1U, 2U}) {
          const std::uint32_t index = std::max(1U, filtration.spectrum_size() * third / 3);
          const double next = index < filtration.spectrum_size() ? filtration.alpha2(index + 1)
                                                                 : filtration.alpha2(index) + 1;
          expect_slices<D>(points, (filtration.alpha2(index) + next) / 2);
          if (::testing::Test::HasFailure()) return;
        }
      }
    }
  };
  expect.template operator()<2>();
  expect.template operator()<3>();
}

// Balls in groups, each within a small distance: turned in space, which rounds them anew, they keep
// the area that they expose. Contacts among three groups and more are not as good: they lie where
// nearly parallel lines cross.
TEST(UnionOfBalls, OfGroupsOfCloseBallsKeepsItsAreaWhereTurned) {
  for (const double size : {1e-2, 1e-6, 1e-10}) {
    Random random(11);
    std::vector<double> coordinates, turned, radii;
    for (int group = 0; group < 12; ++group) {
      const std::array<double, 3> centre{random.uniform(), random.uniform(), random.uniform()};
      const double radius = random.uniform(0.2, 0.3);
      for (int i = 0; i < 4; ++i) {
        std::array<double, 3> x{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          x[axis] = centre[axis] + size * random.uniform(-1.0, 1.0);
        }
        coordinates.insert(coordinates.end(), x.begin(), x.end());
        x = {0.6 * x[0] - 0.8 * x[1], 0.8 * x[0] + 0.6 * x[1], x[2]};
        x = {x[0], (5 * x[1] - 12 * x[2]) / 13, (12 * x[1] + 5 * x[2]) / 13};
        turned.insert(turned.end(), x.begin(), x.end());
        radii.push_back(radius);
      }
    }
    const UnionOfBalls a = union_of<3>(coordinates, radii), b = union_of<3>(turned, radii);
    EXPECT_NEAR(a.area, b.area, 1e-12);
    EXPECT_NEAR(a.volume, b.volume, 1e-14 + 1e-17 / size);
    EXPECT_EQ(a.euler, b.euler);
  }
}

TEST(UnionOfBalls, OfASiteInTheMiddleOfALatticeIsItsCell) {
  std::vector<double> coordinates;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (const int z : {0, 1, 2}) {
        coordinates.insert(coordinates.end(), {double(x), double(y), double(z)});
      }
    }
  }
  const UnionOfBalls lattice = union_of_equal(coordinates, 0.9);
  EXPECT_NEAR(lattice.volumes[13], 1.0, 1e-14);
  EXPECT_EQ(lattice.areas[13], 0.0);
  int sides = 0;
  for (const Contact& contact : lattice.contacts) {
    if (contact.rows[0] != SiteId(13) && contact.rows[1] != SiteId(13)) continue;
    EXPECT_EQ(contact.exposed_length, 0.0);
    if (contact.area < 0.5) continue;
    EXPECT_NEAR(contact.area, 1.0, 1e-14);
    ++sides;
  }
  EXPECT_EQ(sides, 6);
}

TEST(UnionOfBalls, OfCollinearAndCoplanarBallsIsInSpace) {
  const UnionOfBalls line =
      union_of_equal({0, 0, 0, 1, 1, 0, 2, 2, 0}, std::sqrt(2.0));  // lenses at distance 1 radius
  const double r3 = std::pow(2.0, 1.5);
  EXPECT_NEAR(line.volume, r3 * (4 * pi - 2 * 5 * pi / 12), 1e-13);
  EXPECT_NEAR(line.area, 2 * (12 * pi - 2 * 2 * pi), 1e-13);
  EXPECT_EQ(line.euler, 1);
  // Four balls at the corners of a square, of which all share a lens: by inclusion and exclusion
  // of two columns over the square's centre.
  const UnionOfBalls square = union_of_equal({0, 0, 5, 1, 0, 5, 0, 1, 5, 1, 1, 5}, 0.6);
  const double lens = pi * (4 * 0.6 + 1) * std::pow(2 * 0.6 - 1, 2) / 12;
  EXPECT_NEAR(square.volume, 4 * 4 * pi / 3 * 0.216 - 4 * lens, 1e-14);
  EXPECT_EQ(square.euler, 0);
}

// Numbers at the ends of the double range: whatever comes out, it is a number or too large.
TEST(UnionOfBalls, OfExtremeNumbersIsNeverNaN) {
  const auto expect = []<int D>(PointFamily family) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Filtration<D> filtration(
          regular_triangulation<D>(generators::points_of(family, D, 14, seed)));
      const std::uint32_t last = filtration.spectrum_size();
      for (std::uint32_t index = 0; index <= last; index += std::max(1U, last / 6)) {
        const double alpha2 = index == 0 ? -1.0 : filtration.alpha2(index);
        if (std::isinf(alpha2)) continue;
        const UnionOfBalls found = union_of_balls(filtration, index, alpha2, kEverything);
        SCOPED_TRACE(::testing::Message()
                     << name(family) << ' ' << D << "D seed " << seed << " index " << index);
        EXPECT_GE(found.volume, 0.0);
        EXPECT_GE(found.area, 0.0);
        EXPECT_FALSE(std::isnan(found.mean_curvature));
        for (const double one : found.volumes) EXPECT_GE(one, 0.0);
        for (const double one : found.areas) EXPECT_GE(one, 0.0);
        for (const Contact& contact : found.contacts) {
          EXPECT_GE(contact.area, 0.0);
          EXPECT_GE(contact.exposed_length, 0.0);
        }
        for (const auto* list :
             {&found.derivatives.area_by_radius, &found.derivatives.volume_by_centre,
              &found.derivatives.area_by_centre}) {
          for (const double one : *list) EXPECT_FALSE(std::isnan(one));
        }
      }
    }
  };
  for (const PointFamily family :
       {PointFamily::huge, PointFamily::tiny, PointFamily::mixed_scales}) {
    expect.template operator()<2>(family);
    expect.template operator()<3>(family);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(UnionOfBalls, OfANearlyFlatTetrahedron) {
  // Four balls on one circle, as in a hexagon of carbon atoms, flat but for the last bits: where
  // in its plane the orthocentre lies is all rounding. The same with five decimals has no such
  // cell.
  const std::vector<double> x{-0.6461538461538461, 3.2033406561085972, -1.4033201447963801,
                              0.6461538461538461,  2.9499469909502262, -1.8784332669683257,
                              -1.5599015384615384, 1.4265406153846154, -2.8600538461538461,
                              -0.2168246153846154, 1.1631921990950226, -3.3538321266968326};
  const UnionOfBalls balls = union_of_equal(x, 1.7);
  EXPECT_NEAR(balls.volume, 61.6963612419, 1e-9);  // by slices
  EXPECT_NEAR(balls.area, 86.2215341214, 1e-9);
}

TEST(UnionOfBalls, OfCentresWhoseDistancesHaveNoSquares) {
  const double none = 1e-170;
  const UnionOfBalls line =
      union_of_equal({0, 0, 0, 1, 0, 0, 0.5, none, 0, 0.5, 0, none, 0.5, -none, -none}, 1.0);
  const UnionOfBalls three = union_of_equal({0, 0, 0, 1, 0, 0, 0.5, 0, 0}, 1.0);
  EXPECT_NEAR(line.volume, three.volume, 1e-12);
  EXPECT_NEAR(line.area, three.area, 1e-12);
  for (const double close : {1e-160, 1e-170, 1e-200}) {
    const UnionOfBalls corner =
        union_of_equal({0, 0, 0, close, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 1.0);
    EXPECT_NEAR(corner.volume, 12.4776696972, 1e-9) << close;
    EXPECT_NEAR(corner.area, 29.2486629787, 1e-9) << close;
  }
}

}  // namespace
}  // namespace orthoball
