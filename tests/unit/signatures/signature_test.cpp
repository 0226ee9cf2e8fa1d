// SPDX-License-Identifier: MIT
#include "orthoball/signatures/signature.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/measures/complex_measures.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using Coordinates = std::vector<double>;

template <int D>
Filtration<D> filtration_of(Coordinates coordinates, std::vector<double> weights = {}) {
  const WeightKind kind = weights.empty() ? WeightKind::none : WeightKind::weight;
  return Filtration<D>(regular_triangulation<D>(
      WeightedPoints(D, std::move(coordinates), kind, std::move(weights))));
}

template <int D>
Signature<D> at(const Filtration<D>& filtration, std::uint32_t index) {
  return signatures<D>(filtration, std::array{index}).front();
}
template <int D>
Signature<D> at_alpha2(const Filtration<D>& filtration, double alpha2) {
  return at(filtration, filtration.index(alpha2));
}
template <int D>
Signature<D> last(const Filtration<D>& filtration) {
  return at(filtration, filtration.spectrum_size());
}

Coordinates box(int nx, int ny, int nz) {
  Coordinates corners;
  for (int x = 0; x <= nx; ++x) {
    for (int y = 0; y <= ny; ++y) {
      for (int z = 0; z <= nz; ++z) {
        for (const int c : {x, y, z}) corners.push_back(c);
      }
    }
  }
  return corners;
}

// All even permutations of (a, b, c), or all of them, with all signs, once each.
void add_permutations(Coordinates& points, double a, double b, double c) {
  for (int signs = 0; signs < 8; ++signs) {
    if ((a == 0 && (signs & 1)) || (b == 0 && (signs & 2)) || (c == 0 && (signs & 4))) continue;
    const std::array<double, 3> v{signs & 1 ? -a : a, signs & 2 ? -b : b, signs & 4 ? -c : c};
    for (std::size_t shift = 0; shift < 3; ++shift) {
      for (std::size_t axis = 0; axis < 3; ++axis) points.push_back(v[(axis + shift) % 3]);
      if (a == b && b == c) break;
    }
  }
}

constexpr double kGolden = std::numbers::phi;

Coordinates icosahedron() {
  Coordinates points;
  add_permutations(points, 0, 0.5, kGolden / 2);
  return points;
}
Coordinates dodecahedron() {  // edge 1
  Coordinates points;
  add_permutations(points, kGolden / 2, kGolden / 2, kGolden / 2);
  add_permutations(points, 0, 0.5, kGolden * kGolden / 2);
  return points;
}
Coordinates truncated_icosahedron() {  // edge 1
  Coordinates points;
  add_permutations(points, 0, 0.5, 1.5 * kGolden);
  add_permutations(points, 0.5, (2 + kGolden) / 2, kGolden);
  add_permutations(points, 1, (1 + 2 * kGolden) / 2, kGolden / 2);
  return points;
}

struct Polyhedron {
  const char* name;
  Coordinates points;
  double unit;                         // length of an edge
  std::vector<double> thresholds;      // alpha2 of edges, faces, solid, in edges squared
  std::vector<BettiNumbers<3>> betti;  // after each
  double volume, area, length;         // in powers of an edge
};

std::vector<Polyhedron> polyhedra() {
  const double pi = std::numbers::pi, root5 = std::sqrt(5.0);
  return {
      {"tetrahedron",
       {0, 0, 0, 1, 1, 0, 1, 0, 1, 0, 1, 1},
       std::sqrt(2.0),
       {1. / 4, 1. / 3, 3. / 8},
       {{1, 3, 0}, {1, 0, 1}, {1, 0, 0}},
       0.1178511302,
       1.7320508076,
       11.4637994175},
      {"cube",
       box(1, 1, 1),
       1,
       {1. / 4, 1. / 2, 3. / 4},
       {{1, 5, 0}, {1, 0, 1}, {1, 0, 0}},
       1,
       6,
       6 * pi},
      {"octahedron",
       {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
       std::sqrt(2.0),
       {1. / 4, 1. / 3, 1. / 2},
       {{1, 7, 0}, {1, 0, 1}, {1, 0, 0}},
       0.4714045208,
       3.4641016151,
       14.7715130081},
      {"icosahedron",
       icosahedron(),
       1,
       {1. / 4, 1. / 3, (5 + root5) / 8},
       {{1, 19, 0}, {1, 0, 1}, {1, 0, 0}},
       2.1816949906,
       8.6602540378,
       21.8918296868},
      {"dodecahedron",
       dodecahedron(),
       1,
       {1. / 4, 0.7236067977, 1.9635254916},
       {{1, 11, 0}, {1, 0, 1}, {1, 0, 0}},
       7.6631189606,
       20.6457288071,
       33.2144615338},
      {"C60",
       truncated_icosahedron(),
       1,
       {1. / 4, 0.7236067977, 1, (58 + 18 * root5) / 16},
       {{1, 31, 0}, {1, 19, 0}, {1, 0, 1}, {1, 0, 0}},
       55.2877307581,
       72.6072530340,
       61.0333180739},
  };
}

TEST(Signature, OfPolyhedraHasItsClosedForms) {
  for (const Polyhedron& solid : polyhedra()) {
    SCOPED_TRACE(solid.name);
    const Filtration<3> filtration = filtration_of<3>(solid.points);
    const double unit = solid.unit;
    for (std::size_t i = 0; i < solid.thresholds.size(); ++i) {
      const double alpha2 = solid.thresholds[i] * unit * unit;
      EXPECT_EQ(at_alpha2(filtration, alpha2 * (1 + 1e-9)).betti, solid.betti[i]) << i;
      const BettiNumbers<3> before =
          i == 0 ? BettiNumbers<3>{static_cast<std::uint32_t>(solid.points.size() / 3), 0, 0}
                 : solid.betti[i - 1];
      EXPECT_EQ(at_alpha2(filtration, alpha2 * (1 - 1e-9)).betti, before) << i;
    }
    const Signature<3> whole = last(filtration);
    EXPECT_NEAR(whole.volume / (unit * unit * unit), solid.volume, 1e-9);
    EXPECT_NEAR(whole.area / (unit * unit), solid.area, 1e-9);
    EXPECT_NEAR(whole.length / unit, solid.length, 1e-9);
    EXPECT_EQ(whole.euler, 1);
    EXPECT_EQ(whole.area_singular, 0.0);
    EXPECT_EQ(whole.area_regular, whole.area);
  }
}

TEST(Signature, OfIntegerPolyhedraHasFourIndices) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(filtration_of<3>(polyhedra()[i].points).spectrum_size(), 4U) << polyhedra()[i].name;
  }
}

TEST(Signature, OfABlockOfCubesIsThatOfTheBox) {
  const Signature<3> block = last(filtration_of<3>(box(4, 3, 2)));
  EXPECT_EQ(block.volume, 24.0);
  EXPECT_EQ(block.area, 52.0);
  EXPECT_NEAR(block.length, 2 * std::numbers::pi * 9, 1e-12);
  EXPECT_EQ(block.betti, (BettiNumbers<3>{1, 0, 0}));
}

TEST(Signature, OfTheGridCountsItsEdgesSquaresAndCubes) {
  const int n = 3;
  const Filtration<3> filtration = filtration_of<3>(box(n, n, n));
  ASSERT_EQ(filtration.spectrum_size(), 4U);
  const std::uint32_t vertices = 64, edges = 3 * 3 * 16, squares = 3 * 9 * 4, cubes = 27;
  EXPECT_EQ(at(filtration, 1).betti, (BettiNumbers<3>{vertices, 0, 0}));
  EXPECT_EQ(at(filtration, 2).betti, (BettiNumbers<3>{1, edges - vertices + 1, 0}));
  EXPECT_EQ(at(filtration, 3).betti, (BettiNumbers<3>{1, 0, cubes}));
  EXPECT_EQ(at(filtration, 3).area_singular, squares);
  EXPECT_EQ(at(filtration, 4).betti, (BettiNumbers<3>{1, 0, 0}));
}

TEST(Signature, OfOneSegmentAndOneTriangleInSpace) {
  const Signature<3> segment = last(filtration_of<3>({0, 0, 0, 3, 4, 0}));
  EXPECT_NEAR(segment.length, 2 * std::numbers::pi * 5, 1e-14);
  EXPECT_EQ(segment.area, 0.0);
  EXPECT_EQ(segment.singular, (ByDimension<3>{0, 1, 0, 0}));
  const Signature<3> triangle = last(filtration_of<3>({0, 0, 0, 3, 0, 0, 0, 4, 0}));
  EXPECT_EQ(triangle.volume, 0.0);
  EXPECT_EQ(triangle.area, 12.0);
  EXPECT_EQ(triangle.area_singular, 6.0);
  EXPECT_NEAR(triangle.length, std::numbers::pi * 12, 1e-14);
  EXPECT_EQ(triangle.betti, (BettiNumbers<3>{1, 0, 0}));
}

TEST(Signature, OfPointsOnALineInThePlaneEndsSingular) {
  const Signature<2> line = last(filtration_of<2>({0, 0, 3, 4, 6, 8, 9, 12}));
  EXPECT_EQ(line.area, 30.0);  // both sides
  EXPECT_EQ(line.area_singular, 15.0);
  EXPECT_EQ(line.volume, 0.0);
  EXPECT_EQ(line.betti, (BettiNumbers<2>{1, 0}));
}

TEST(Signature, OfNothingAndOfOnePoint) {
  EXPECT_EQ(at(Filtration<3>(), 0).betti, (BettiNumbers<3>{0, 0, 0}));
  int visits = 0;
  scan_signatures<3>(Filtration<3>(), [&](const Signature<3>&) { ++visits; });
  EXPECT_EQ(visits, 0);
  const Filtration<2> one = filtration_of<2>({5, 7});
  EXPECT_EQ(last(one).betti, (BettiNumbers<2>{1, 0}));
  EXPECT_EQ(last(one).singular, (ByDimension<2>{1, 0, 0}));
}

TEST(Signature, AtIndexZeroIsTheEmptyComplex) {
  const Signature<3> empty = at(filtration_of<3>(box(1, 1, 1)), 0);
  EXPECT_EQ(empty.index, 0U);
  EXPECT_EQ(empty.alpha2, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(empty.exterior[0], 8U);
  EXPECT_EQ(empty.betti, (BettiNumbers<3>{0, 0, 0}));
  EXPECT_EQ(empty.volume + empty.area + empty.length, 0.0);
}

TEST(Signature, AnswersInTheOrderOfTheIndices) {
  const Filtration<3> filtration = filtration_of<3>(box(1, 1, 1));
  const std::vector<std::uint32_t> indices{4, 0, 2, 4, 1};
  const std::vector<Signature<3>> answers = signatures<3>(filtration, indices);
  ASSERT_EQ(answers.size(), indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) EXPECT_EQ(answers[i].index, indices[i]);
  EXPECT_EQ(answers[0].volume, 1.0);
  EXPECT_EQ(answers[3].volume, 1.0);
  EXPECT_THROW(static_cast<void>(at(filtration, 5)), InputError);
}

TEST(Signature, OfTwoDiscsIsMatlabsExample) {
  Coordinates discs;
  for (const double shift : {0.0, 15.0}) {
    discs.insert(discs.end(), {shift, 0.0});
    for (int ring = 1; ring <= 5; ++ring) {
      for (int i = 0; i < 24; ++i) {
        const double turn = i * std::numbers::pi / 12;
        discs.insert(discs.end(), {shift + ring * std::cos(turn), ring * std::sin(turn)});
      }
    }
  }
  const Filtration<2> filtration = filtration_of<2>(discs);
  // At alpha = 2.5 the edge of length 5 between the discs enters: closed, and singular.
  const Signature<2> apart = at_alpha2(filtration, 2.5 * 2.5 * (1 - 1e-12));
  EXPECT_EQ(apart.betti, (BettiNumbers<2>{2, 0}));
  const double perimeter = 240 * std::sin(std::numbers::pi / 24) * 2;
  EXPECT_NEAR(apart.area, perimeter, 1e-10);
  const Signature<2> touching = at_alpha2(filtration, 2.5 * 2.5);
  EXPECT_EQ(touching.betti, (BettiNumbers<2>{1, 0}));
  EXPECT_EQ(touching.area_singular, 5.0);
  EXPECT_NEAR(touching.area_regular, perimeter, 1e-10);
  EXPECT_NEAR(filtration.spectrum().back(), 2756.939, 1e-3);
}

TEST(Signature, OfTheWeightedTetrahedronOfCgalAndGudhi) {
  const Filtration<3> filtration =
      filtration_of<3>({1, -1, -1, -1, 1, -1, -1, -1, 1, 1, 1, 1, 2, 2, 2}, {4, 4, 4, 4, 1});
  // Edge 3-4 enters with vertex 4: the exact tie.
  const Signature<3> tie = at_alpha2(filtration, -1.0);
  EXPECT_EQ(tie.betti, (BettiNumbers<3>{1, 0, 0}));
  EXPECT_EQ(tie.exterior, (ByDimension<3>{0, 3, 6, 3}));
  EXPECT_NEAR(tie.volume, 8.0 / 3, 1e-14);
  EXPECT_EQ(last(filtration).interior[3], 4U);
}

TEST(Signature, ScalesWithPowersOfTwo) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Coordinates small(90), large;
  for (double& x : small) x = uniform(random);
  for (const double x : small) large.push_back(8 * x);
  const Filtration<3> a = filtration_of<3>(small), b = filtration_of<3>(large);
  ASSERT_EQ(a.spectrum_size(), b.spectrum_size());
  for (std::uint32_t i = 1; i <= a.spectrum_size(); i += 7) {
    const Signature<3> s = at(a, i), t = at(b, i);
    EXPECT_EQ(t.alpha2, 64 * s.alpha2);
    EXPECT_EQ(t.volume, 512 * s.volume);
    EXPECT_EQ(t.area, 64 * s.area);
    EXPECT_EQ(t.length, 8 * s.length);
    EXPECT_EQ(t.betti, s.betti);
  }
}

TEST(Signature, OfDecimalsIsInInputUnits) {
  // The cube of edge 0.1, and its corners as integers in units of 0.1.
  const WeightedPoints points =
      WeightedPoints::fixed_point(3, 1, box(1, 1, 1), WeightKind::none, {});
  const Signature<3> cube = last(Filtration<3>(regular_triangulation<3>(points)));
  EXPECT_EQ(cube.volume, 0.001);
  EXPECT_EQ(cube.area, 0.06);
  EXPECT_NEAR(cube.length, 0.6 * std::numbers::pi, 1e-15);
}

TEST(Signature, OfFarApartScalesKeepsTheSmallOnes) {
  // A unit right triangle beside a site at 1e300.
  const Filtration<2> filtration = filtration_of<2>({0, 0, 1, 0, 0, 1, 1e300, 1e300});
  const Signature<2> near = at_alpha2(filtration, 0.5);
  EXPECT_EQ(near.volume, 0.5);
  EXPECT_EQ(near.area, 2 + std::sqrt(2.0));
  const Signature<2> whole = last(filtration);
  EXPECT_FALSE(std::isnan(whole.volume));
  EXPECT_NEAR(whole.area / (2 * std::sqrt(2.0) * 1e300), 1.0, 1e-15);
}

TEST(Signature, OverflowsToInfinityWithoutNaN) {
  Coordinates corners = box(1, 1, 1);
  for (double& x : corners) x *= 1e300;
  const Filtration<3> filtration = filtration_of<3>(corners);
  scan_signatures<3>(filtration, [&](const Signature<3>& s) {
    EXPECT_FALSE(std::isnan(s.volume) || std::isnan(s.area_singular) ||
                 std::isnan(s.area_regular) || std::isnan(s.area) || std::isnan(s.length));
  });
  const Signature<3> whole = last(filtration);
  EXPECT_EQ(whole.volume, std::numeric_limits<double>::infinity());
  EXPECT_EQ(whole.area, std::numeric_limits<double>::infinity());
  EXPECT_EQ(whole.area_singular, 0.0);
  EXPECT_NEAR(whole.length / (6 * std::numbers::pi * 1e300), 1.0, 1e-14);
}

TEST(Signature, EndsAtTheConvexHullTo12Digits) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Coordinates points{};
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
    for (const int axis : {0, 1, 2}) points.push_back((corner >> axis & 1) != 0 ? 1.0 : -1.0);
  }
  for (int i = 0; i < 3 * 5000; ++i) points.push_back(uniform(random));
  const Filtration<3> filtration = filtration_of<3>(points);
  const Signature<3> whole = last(filtration);
  EXPECT_NEAR(whole.volume / 8, 1.0, 1e-13);
  EXPECT_NEAR(whole.area / 24, 1.0, 1e-13);
  EXPECT_NEAR(whole.length / (12 * std::numbers::pi), 1.0, 1e-12);
  const HullMeasures hull = hull_measures(filtration);
  EXPECT_EQ(hull.volume, whole.volume);
  EXPECT_EQ(hull.area, whole.area);
}

TEST(Signature, HasEulerNumberOfItsBettiNumbersAtEveryIndex) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Coordinates points(900);
  for (double& x : points) x = uniform(random);
  scan_signatures<3>(filtration_of<3>(points), [&](const Signature<3>& s) {
    EXPECT_EQ(s.euler, std::int64_t{s.betti[0]} - s.betti[1] + s.betti[2]);
  });
  scan_signatures<2>(filtration_of<2>(points), [&](const Signature<2>& s) {
    EXPECT_EQ(s.euler, std::int64_t{s.betti[0]} - s.betti[1]);
  });
}

}  // namespace
}  // namespace orthoball
