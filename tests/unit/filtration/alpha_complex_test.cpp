// SPDX-License-Identifier: MIT
#include "orthoball/filtration/alpha_complex.h"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(AlphaComplex, RefusesAnIndexBeyondTheSpectrum) {
  const Filtration<2> filtration(regular_triangulation<2>(points_of(PointFamily::grid, 2, 9, 0)));
  EXPECT_NO_THROW(AlphaComplex<2>(filtration, filtration.spectrum_size()));
  EXPECT_THROW(AlphaComplex<2>(filtration, filtration.never()), InputError);
}

}  // namespace
}  // namespace orthoball
