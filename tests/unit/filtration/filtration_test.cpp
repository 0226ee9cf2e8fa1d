// SPDX-License-Identifier: MIT
#include "orthoball/filtration/filtration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "generators/point_families.h"
#include "matchers/same_bytes.h"
#include "matchers/same_filtration.h"
#include "oracles/brute_force.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::points_of;
using oracles::brute_force;
using oracles::BruteForce;
using oracles::BruteSimplex;

std::vector<std::uint32_t> numbers(const auto& ids) {
  std::vector<std::uint32_t> result;
  for (const auto id : ids) result.push_back(id.row());
  return result;
}

// The filtration in the oracle's form, in the order that people see.
template <int D>
std::vector<BruteSimplex> simplices_of(const Filtration<D>& filtration) {
  std::vector<BruteSimplex> result;
  for (const SimplexId simplex : Filter<D>(filtration).by_rows()) {
    result.push_back({numbers(filtration.rows(simplex)), filtration.is_attached(simplex),
                      filtration.enters(simplex), filtration.regular(simplex),
                      filtration.interior(simplex)});
  }
  return result;
}

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

std::string text(const BruteSimplex& simplex) {
  std::string result = "rows";
  for (const std::uint32_t row : simplex.rows) result += " " + std::to_string(row);
  return result + (simplex.is_attached ? " attached" : " unattached") + " enters " +
         std::to_string(simplex.enters) + " regular " + std::to_string(simplex.regular) +
         " interior " + std::to_string(simplex.interior);
}

template <int D>
void expect_definitions(const WeightedPoints& points) {
  const BruteForce expected = brute_force(points);
  const Filtration<D> filtration = filtration_of<D>(points);
  ASSERT_EQ(filtration.size(), expected.simplices.size());
  ASSERT_EQ(filtration.spectrum_size(), expected.spectrum.size());
  for (std::uint32_t index = 1; index <= filtration.spectrum_size(); ++index) {
    ASSERT_EQ(filtration.alpha2(index), oracles::nearest_double(expected.spectrum[index - 1]));
  }
  const auto found = simplices_of(filtration);
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(text(found[i]), text(expected.simplices[i])) << "at position " << i;
  }
}

TEST(Filtration, AgreesWithTheDefinitionsOnEveryFamily) {
  const std::uint64_t seeds = std::getenv("ORTHOBALL_LONG") != nullptr ? 400 : 14;
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const std::size_t count = 1 + seed % 12;
      SCOPED_TRACE(std::string(name(family)) + " count " + std::to_string(count) + " seed " +
                   std::to_string(seed));
      expect_definitions<2>(points_of(family, 2, count, seed));
      expect_definitions<3>(points_of(family, 3, count, seed));
      if (HasFatalFailure()) return;
    }
  }
}

// Everything the header promises of any filtration.
template <int D>
void expect_laws(const WeightedPoints& points) {
  const Filtration<D> filtration = filtration_of<D>(points);
  const std::uint32_t never = filtration.never();
  ASSERT_TRUE(std::is_sorted(filtration.spectrum().begin(), filtration.spectrum().end()));
  const Filter<D> filter(filtration);
  std::vector<bool> has_entered(filtration.size(), false);
  std::uint32_t last_index = 0;
  int last_dimension = 0;
  for (std::size_t position = 0; position < filtration.size(); ++position) {
    const SimplexId simplex = filter.simplices()[position];
    const std::uint32_t index = filtration.enters(simplex);
    const int dimension = filtration.dimension(simplex);
    ASSERT_GE(index, last_index);
    ASSERT_TRUE(index > last_index || dimension >= last_dimension);
    last_index = index;
    last_dimension = dimension;
    has_entered[simplex.row()] = true;

    ASSERT_LE(index, filtration.regular(simplex));
    ASSERT_LE(filtration.regular(simplex), filtration.interior(simplex));
    ASSERT_LE(filtration.interior(simplex), never);
    const auto vertices = filtration.vertices(simplex);
    const auto facets = filtration.facets(simplex);
    ASSERT_EQ(vertices.size(), static_cast<std::size_t>(dimension) + 1);
    ASSERT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
    ASSERT_EQ(facets.size(), dimension == 0 ? 0U : vertices.size());
    for (std::size_t i = 0; i < facets.size(); ++i) {
      ASSERT_TRUE(has_entered[facets[i].row()]);
      ASSERT_LE(filtration.regular(facets[i]), index);
      auto without = numbers(vertices);
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      ASSERT_EQ(numbers(filtration.vertices(facets[i])), without);
    }
    if (dimension == filtration.triangulation().affine_dimension() - 1) {
      std::uint32_t first = never;
      std::uint32_t last = 0;
      for (const SimplexId cell : filtration.cells_beside(simplex)) {
        first = std::min(first, filtration.enters(cell));
        last = std::max(last, filtration.enters(cell));
        const auto sides = numbers(filtration.facets(cell));
        ASSERT_NE(std::find(sides.begin(), sides.end(), simplex.row()), sides.end());
      }
      ASSERT_EQ(filtration.regular(simplex), first);
      const bool is_hull = filtration.cells_beside(simplex).size() == 1;
      ASSERT_EQ(filtration.interior(simplex), is_hull || dimension < D - 1 ? never : last);
    }
  }
  for (std::uint32_t index = 1; index <= filtration.spectrum_size(); ++index) {
    const std::uint32_t back = filtration.index(filtration.alpha2(index));
    ASSERT_GE(back, index);
    ASSERT_EQ(filtration.alpha2(back), filtration.alpha2(index));
  }
}

TEST(Filtration, KeepsItsLawsOnEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const std::size_t count = 20 + 40 * seed;
      SCOPED_TRACE(std::string(name(family)) + " count " + std::to_string(count) + " seed " +
                   std::to_string(seed));
      expect_laws<2>(points_of(family, 2, count, seed));
      expect_laws<3>(points_of(family, 3, count, seed));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Filtration, KeepsItsLawsOnThousandsOfSites) {
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::protein_like, PointFamily::cospherical,
        PointFamily::near_sphere, PointFamily::hidden_heavy}) {
    SCOPED_TRACE(name(family));
    expect_laws<2>(points_of(family, 2, 2000, 7));
    expect_laws<3>(points_of(family, 3, 2000, 7));
  }
}

// Large enough for several parts of everything.
TEST(Filtration, IsTheSameOnAnyNumberOfThreads) {
  const auto expect_same = [&]<int D>(PointFamily family, std::size_t count) {
    const auto triangulation = regular_triangulation<D>(points_of(family, D, count, 3));
    const Filtration<D> one(triangulation, Threads(1));
    for (const unsigned threads : {2U, 4U, 16U}) {
      const Filtration<D> many(triangulation, Threads(threads));
      EXPECT_EQ(matchers::order_faults(one, many), std::vector<std::string>())
          << name(family) << " on " << threads;
      EXPECT_TRUE(matchers::same_bytes(one.spectrum(), many.spectrum())) << name(family);
    }
  };
  expect_same.operator()<3>(PointFamily::uniform, 40000);
  expect_same.operator()<3>(PointFamily::uniform, 125000);  // for more parts than labels have lists
  expect_same.operator()<3>(PointFamily::protein_like, 40000);
  expect_same.operator()<3>(PointFamily::grid, 42875);
  expect_same.operator()<3>(PointFamily::lattice, 60000);
  expect_same.operator()<2>(PointFamily::uniform_balls, 150000);
  expect_same.operator()<2>(PointFamily::grid, 160000);
}

TEST(Filtration, IsEmptyWithoutSites) {
  for (const Filtration<3>& filtration : {Filtration<3>(), filtration_of<3>(WeightedPoints(3))}) {
    EXPECT_EQ(filtration.size(), 0U);
    EXPECT_EQ(filtration.spectrum_size(), 0U);
    EXPECT_EQ(filtration.index(1e9), 0U);
  }
}

TEST(Filtration, OfOneSiteIsASingularVertexForEver) {
  const auto filtration = filtration_of<3>(WeightedPoints(3, {1, 2, 3}, WeightKind::weight, {5}));
  ASSERT_EQ(filtration.size(), 1U);
  const SimplexId vertex(0);
  EXPECT_EQ(filtration.alpha2(1), -5.0);
  EXPECT_EQ(filtration.role(vertex, 0), Role::exterior);
  EXPECT_EQ(filtration.role(vertex, 1), Role::singular);
  EXPECT_EQ(filtration.regular(vertex), filtration.never());
  EXPECT_EQ(filtration.interior(vertex), filtration.never());
}

TEST(Filtration, ThresholdsAreClosed) {
  const auto filtration = filtration_of<2>(WeightedPoints(2, {0, 0, 3, 0, 0, 4}, {}, {}));
  // Vertices at 0, legs at 9/4 and 4, hypotenuse and triangle at 25/4: a tie, unattached.
  ASSERT_EQ(filtration.spectrum_size(), 4U);
  EXPECT_EQ(filtration.index(6.25), 4U);
  EXPECT_EQ(filtration.index(std::nextafter(6.25, 0.0)), 3U);
  EXPECT_EQ(filtration.index(-1.0), 0U);
  const Filter<2> filter(filtration);
  EXPECT_FALSE(filtration.is_attached(filter.simplices()[filter.complex_size(3)]));
}

TEST(Filtration, AnIntegerGridHasFourValues) {
  const auto filtration = filtration_of<3>(points_of(PointFamily::grid, 3, 6 * 6 * 6, 0));
  ASSERT_EQ(filtration.spectrum_size(), 4U);
  EXPECT_EQ(filtration.alpha2(1), 0.0);
  EXPECT_EQ(filtration.alpha2(2), 0.25);
  EXPECT_EQ(filtration.alpha2(3), 0.5);
  EXPECT_EQ(filtration.alpha2(4), 0.75);
}

}  // namespace
}  // namespace orthoball
