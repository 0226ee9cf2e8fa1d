// SPDX-License-Identifier: MIT
#include "orthoball/filtration/alpha_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/error.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::points_of;

std::vector<SimplexId> joined(std::vector<SimplexId> a, const std::vector<SimplexId>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  return a;
}

template <int D>
void expect_boundaries(const WeightedPoints& points) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  const BoundaryIndex<D> boundary(filtration);
  for (std::uint32_t index = 0; index <= filtration.spectrum_size(); ++index) {
    const AlphaComplex<D> complex(filtration, index);
    ASSERT_EQ(boundary.facets(index), joined(complex.simplices(D - 1, Role::singular),
                                             complex.simplices(D - 1, Role::regular)));
    for (int dimension = 0; dimension < D - 1; ++dimension) {
      ASSERT_EQ(boundary.singular(dimension, index), complex.simplices(dimension, Role::singular));
    }
  }
}

TEST(BoundaryIndex, FindsTheRolesThatAScanFinds) {
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::gaussian, PointFamily::lattice, PointFamily::coplanar,
        PointFamily::collinear, PointFamily::hidden_heavy}) {
    for (const std::size_t count : {1U, 4U, 60U}) {
      SCOPED_TRACE(std::string(name(family)) + " count " + std::to_string(count));
      expect_boundaries<2>(points_of(family, 2, count, count));
      expect_boundaries<3>(points_of(family, 3, count, count));
    }
  }
}

template <int D>
void expect_same_roles(const WeightedPoints& points) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  const std::uint32_t step = filtration.spectrum_size() / 9 + 1;
  for (std::uint32_t index = 0; index <= filtration.spectrum_size(); index += step) {
    const AlphaComplex<D> complex(filtration, index);
    const AlphaComplex<D> closed(filtration, index, complex.maximal_simplices());
    const AlphaComplex<D> solid = regularized(complex);
    EXPECT_EQ(closed.maximal_simplices(), complex.maximal_simplices());
    for (std::uint32_t row = 0; row < filtration.size(); ++row) {
      const SimplexId simplex(row);
      ASSERT_EQ(closed.role(simplex), complex.role(simplex)) << row;
      ASSERT_EQ(closed.contains(simplex), complex.contains(simplex)) << row;
      ASSERT_NE(solid.role(simplex), Role::singular);
      ASSERT_TRUE(complex.contains(simplex) || !solid.contains(simplex));
      if (filtration.dimension(simplex) < D - 1) continue;
      const Role role = complex.role(simplex);
      ASSERT_EQ(solid.role(simplex), role == Role::singular ? Role::exterior : role);
    }
  }
}

TEST(AlphaComplex, OfTheMaximalSimplicesHasTheRolesOfTheFiltration) {
  for (const PointFamily family : generators::point_families()) {
    for (const std::size_t count : {0U, 1U, 2U, 5U, 60U}) {
      SCOPED_TRACE(std::string(name(family)) + " count " + std::to_string(count));
      expect_same_roles<2>(points_of(family, 2, count, count));
      expect_same_roles<3>(points_of(family, 3, count, count));
    }
  }
}

TEST(AlphaComplex, OfSomeSimplicesHasTheirFacesInTheRolesOfWhatIsThere) {
  // Two triangles with a common edge: one of them, and the far edge of the other.
  const Filtration<2> filtration(
      regular_triangulation<2>(WeightedPoints(2, {0, 0, 4, 0, 0, 3, 9, 9}, WeightKind::none, {})));
  ASSERT_EQ(filtration.count(2), 2U);
  const auto simplex = [&](std::vector<std::uint32_t> rows) {
    for (std::uint32_t i = 0; i < filtration.size(); ++i) {
      const auto found = filtration.rows(SimplexId(i));
      if (std::equal(found.begin(), found.end(), rows.begin(), rows.end(),
                     [](SiteId a, std::uint32_t b) { return a.row() == b; })) {
        return SimplexId(i);
      }
    }
    return SimplexId();
  };
  const std::vector<SimplexId> simplices{simplex({0, 1, 2}), simplex({1, 3})};
  const AlphaComplex<2> complex(filtration, 0, simplices);
  EXPECT_EQ(complex.role(simplex({0, 1, 2})), Role::interior);
  EXPECT_EQ(complex.role(simplex({1, 2, 3})), Role::exterior);
  for (const auto& rows : {std::vector{0U, 1U}, {0U, 2U}, {1U, 2U}, {0U}, {1U}, {2U}, {3U}}) {
    EXPECT_EQ(complex.role(simplex(rows)), Role::regular);
  }
  EXPECT_EQ(complex.role(simplex({1, 3})), Role::singular);
  EXPECT_EQ(complex.role(simplex({2, 3})), Role::exterior);
}

TEST(AlphaComplex, RefusesAnIndexBeyondTheSpectrum) {
  const Filtration<2> filtration(regular_triangulation<2>(points_of(PointFamily::grid, 2, 9, 0)));
  EXPECT_NO_THROW(AlphaComplex<2>(filtration, filtration.spectrum_size()));
  EXPECT_THROW(AlphaComplex<2>(filtration, filtration.never()), InputError);
}

}  // namespace
}  // namespace orthoball
