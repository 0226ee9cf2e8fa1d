// SPDX-License-Identifier: MIT
#include "orthoball/measures/contact_facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using std::numbers::pi;

template <int D>
struct Facets {
  Filtration<D> filtration;
  std::map<std::array<std::uint32_t, 2>, ContactFacet<D>> of;  // by rows, ascending
};

// Of all edges of the complex of the balls, at once, in input units.
template <int D>
Facets<D> facets_of(std::vector<double> coordinates, std::vector<double> radii) {
  Facets<D> result;
  result.filtration = Filtration<D>(regular_triangulation<D>(
      WeightedPoints(D, std::move(coordinates), WeightKind::radius, std::move(radii))));
  const Filtration<D>& filtration = result.filtration;
  const int exponent = filtration.triangulation().sites().scale_exponent();
  const std::uint32_t index = filtration.index(0.0);
  std::vector<SimplexId> edges;
  for (std::uint32_t i = 0; i < filtration.count(1); ++i) {
    const SimplexId edge(filtration.table().first(1) + i);
    if (filtration.enters(edge) <= index) edges.push_back(edge);
  }
  const ContactFacets<D> facets(filtration, index, 0.0);
  std::vector<ContactFacet<D>> measured(edges.size());
  typename ContactFacets<D>::Room room;
  facets.measure(edges, measured, room);
  for (ContactFacet<D>& facet : measured) {
    EXPECT_LT(facet.ends[0], facet.ends[1]);
    facet.area = std::ldexp(facet.area, -(D - 1) * exponent);
    facet.lens.distance = std::ldexp(facet.lens.distance, -exponent);
    for (double& x : facet.moment) x = std::ldexp(x, -exponent);
    std::array<std::uint32_t, 2> rows{};
    for (std::size_t end = 0; end < 2; ++end) {
      rows[end] = filtration.triangulation().sites().row(facet.ends[end]).row();
    }
    std::sort(rows.begin(), rows.end());
    result.of[rows] = facet;
  }
  return result;
}

template <std::size_t D>
double norm(const std::array<double, D>& a) {
  double sum = 0.0;
  for (const double x : a) sum += x * x;
  return std::sqrt(sum);
}

std::vector<double> cube_corners(int side) {
  std::vector<double> coordinates;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        for (const int i : {x, y, z}) coordinates.push_back(i);
      }
    }
  }
  return coordinates;
}

TEST(ContactFacets, OfTwoBallsAreDisks) {
  const auto facets = facets_of<3>({0, 0, 0, 0, 0, 1}, {1, 1});
  ASSERT_EQ(facets.of.size(), 1U);
  const ContactFacet<3>& facet = facets.of.begin()->second;
  EXPECT_DOUBLE_EQ(facet.area, 0.75 * pi);
  EXPECT_DOUBLE_EQ(facet.exposed, 2 * pi);
  EXPECT_NEAR(facet.bend, pi / 3, 1e-15);
  EXPECT_DOUBLE_EQ(facet.taken[0], pi);  // a cap of height 1/2
  EXPECT_DOUBLE_EQ(facet.taken[1], pi);
  EXPECT_EQ(norm(facet.moment), 0.0);
}

TEST(ContactFacets, OfTwoDisksAreChords) {
  const auto facets = facets_of<2>({0, 0, 0, 1}, {1, 1});
  ASSERT_EQ(facets.of.size(), 1U);
  const ContactFacet<2>& facet = facets.of.begin()->second;
  EXPECT_DOUBLE_EQ(facet.area, std::sqrt(3.0));
  EXPECT_EQ(facet.exposed, 2.0);
  EXPECT_NEAR(facet.bend, pi / 3, 1e-15);
  EXPECT_DOUBLE_EQ(facet.taken[0], 2 * pi / 3);
  EXPECT_EQ(norm(facet.moment), 0.0);
}

TEST(ContactFacets, OfBallsThatJustTouchArePoints) {
  const auto facets = facets_of<3>({0, 0, 0, 0, 3, 0}, {1, 2});
  ASSERT_EQ(facets.of.size(), 1U);
  EXPECT_EQ(facets.of.begin()->second.area, 0.0);
  EXPECT_NEAR(facets.of.begin()->second.bend, pi, 1e-15);
  EXPECT_EQ(facets.of.begin()->second.taken[0], 0.0);
}

// The facet of an edge is what two planes at right angles, at 1/2, leave of its disk.
TEST(ContactFacets, OfCubeCornersAreCornersOfDisks) {
  const double r = 0.8, c = std::sqrt(r * r - 0.25);  // of the disk
  const auto facets = facets_of<3>(cube_corners(2), std::vector<double>(8, r));
  // The square's sides end where the disk does; a void is around the cube's centre.
  ASSERT_LT(2 * 0.25, c * c * 2);
  ASSERT_LT(c * c, 0.5);
  // Below x = 1/2 and y = 1/2, less what both leave out; they do not meet inside the disk.
  const double beyond = c * c * std::acos(0.5 / c) - 0.5 * std::sqrt(c * c - 0.25);
  int edges = 0;
  for (const auto& [rows, facet] : facets.of) {
    if (facet.lens.distance != 1.0) continue;
    ++edges;
    EXPECT_NEAR(facet.area, pi * c * c - 2 * beyond, 1e-14);
    EXPECT_NEAR(facet.exposed, 2 * pi - 4 * std::acos(0.5 / c), 1e-14);
    EXPECT_NEAR(facet.bend, pi - 2 * std::acos(0.5 / r), 1e-14);
  }
  EXPECT_EQ(edges, 12);
}

// Without a void: the corner of the square, (1/2, 1/2), is in the disk.
TEST(ContactFacets, OfAFilledCubeReachItsCentre) {
  const double r = 0.9, c = std::sqrt(r * r - 0.25);
  const auto facets = facets_of<3>(cube_corners(2), std::vector<double>(8, r));
  const double right = std::sqrt(c * c - 0.25);  // half the chords, from their middles outwards
  const double sector = 1.5 * pi - 2 * std::acos(0.5 / c);  // outside of the angle at the centre
  for (const auto& [rows, facet] : facets.of) {
    if (facet.lens.distance != 1.0) continue;
    EXPECT_NEAR(facet.area, c * c * sector / 2 + 0.5 * right + 0.25, 1e-14);
    EXPECT_NEAR(facet.exposed, sector, 1e-14);
    // Opposite the corner, along the diagonal.
    const double half = sector / 2;
    EXPECT_NEAR(norm(facet.moment), 2 * c * std::sin(half), 1e-14);
  }
}

TEST(ContactFacets, InsideALatticeAreSquares) {
  const auto facets = facets_of<3>(cube_corners(3), std::vector<double>(27, 0.9));
  const std::uint32_t centre = 13;
  double taken = 0.0;
  int squares = 0;
  for (const auto& [rows, facet] : facets.of) {
    if (rows[0] != centre && rows[1] != centre) continue;
    const std::size_t end =
        facets.filtration.triangulation().sites().row(facet.ends[0]).row() == centre ? 0 : 1;
    taken += facet.taken[end];
    EXPECT_EQ(facet.exposed, 0.0);
    EXPECT_EQ(facet.bend, 0.0);
    if (facet.lens.distance == 1.0) {
      ++squares;
      EXPECT_NEAR(facet.area, 1.0, 1e-14);
      EXPECT_EQ(norm(facet.moment), 0.0);
    } else {
      EXPECT_NEAR(facet.area, 0.0, 1e-14);  // diagonals
    }
  }
  EXPECT_EQ(squares, 6);
  EXPECT_NEAR(taken, 4 * pi, 1e-13);  // nothing of the ball in the middle is exposed
}

TEST(ContactFacets, InsideALatticeOfDisksAreSidesOfSquares) {
  std::vector<double> coordinates;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) coordinates.insert(coordinates.end(), {double(x), double(y)});
  }
  const auto facets = facets_of<2>(coordinates, std::vector<double>(9, 0.75));
  double taken = 0.0;
  for (const auto& [rows, facet] : facets.of) {
    const bool is_side = facet.lens.distance == 1.0;
    const bool is_inside = rows[0] == 4 || rows[1] == 4;
    const std::size_t end =
        facets.filtration.triangulation().sites().row(facet.ends[0]).row() == 4 ? 0 : 1;
    if (is_inside) taken += facet.taken[end];
    if (is_side && is_inside) {
      EXPECT_NEAR(facet.area, 1.0, 1e-15);
      EXPECT_EQ(facet.exposed, 0.0);
      EXPECT_NEAR(norm(facet.moment), 0.0, 1e-15);
    } else if (is_side) {
      const double half = std::sqrt(0.75 * 0.75 - 0.25);
      EXPECT_NEAR(facet.area, 0.5 + half, 1e-15);
      EXPECT_EQ(facet.exposed, 1.0);
      EXPECT_NEAR(norm(facet.moment), half, 1e-15);
    } else {
      EXPECT_NEAR(facet.area, 0.0, 1e-15);
    }
  }
  EXPECT_NEAR(taken, 2 * pi, 1e-14);
}

// A row of balls at distance 1: no triangle cuts their disks.
TEST(ContactFacets, OfCollinearBallsAreDisks) {
  const auto facets =
      facets_of<3>({0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0}, std::vector<double>(4, 1.0));
  ASSERT_EQ(facets.of.size(), 3U);
  for (const auto& [rows, facet] : facets.of) {
    EXPECT_EQ(rows[1], rows[0] + 1);
    EXPECT_DOUBLE_EQ(facet.area, 0.75 * pi);
    EXPECT_DOUBLE_EQ(facet.exposed, 2 * pi);
  }
  const auto chords = facets_of<2>({0, 0, 0, 1, 0, 2}, std::vector<double>(3, 1.0));
  ASSERT_EQ(chords.of.size(), 2U);
  for (const auto& [rows, facet] : chords.of) EXPECT_DOUBLE_EQ(facet.area, std::sqrt(3.0));
}

// Squares of balls at distance 1 in one plane: two lines cut the facets of inner edges.
TEST(ContactFacets, OfCoplanarBallsAreCutOnBothSides) {
  std::vector<double> coordinates;
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 3; ++y) coordinates.insert(coordinates.end(), {double(x), double(y), 5.0});
  }
  const double r = 0.8, c = std::sqrt(r * r - 0.25);
  const auto facets = facets_of<3>(coordinates, std::vector<double>(6, r));
  const double beyond = c * c * std::acos(0.5 / c) - 0.5 * std::sqrt(c * c - 0.25);
  int inner = 0;
  for (const auto& [rows, facet] : facets.of) {
    if (facet.lens.distance != 1.0) continue;
    const bool is_inner = rows[0] == 1 && rows[1] == 4;
    inner += is_inner ? 1 : 0;
    const double sides = is_inner ? 2 : 1;
    EXPECT_NEAR(facet.area, pi * c * c - sides * beyond, 1e-14);
    EXPECT_NEAR(facet.exposed, 2 * pi - sides * 2 * std::acos(0.5 / c), 1e-14);
  }
  EXPECT_EQ(inner, 1);
}

}  // namespace
}  // namespace orthoball
