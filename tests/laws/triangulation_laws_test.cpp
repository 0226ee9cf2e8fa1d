// SPDX-License-Identifier: MIT
// What holds for the regular triangulation of any sites.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "generators/cases.h"
#include "generators/random.h"
#include "matchers/same_bytes.h"
#include "oracles/exact_points.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;
using generators::PointFamily;
using oracles::Integer;

// The cells as rows and neighbours as they lie in memory.
template <int D>
bool have_same_cells(const RegularTriangulation<D>& a, const RegularTriangulation<D>& b) {
  if (a.affine_dimension() != b.affine_dimension()) return false;
  if constexpr (D == 3) {
    if (!matchers::same_bytes(a.template cells<3>(), b.template cells<3>())) return false;
  }
  return matchers::same_bytes(a.template cells<1>(), b.template cells<1>()) &&
         matchers::same_bytes(a.template cells<2>(), b.template cells<2>());
}

// Sum of the measures of the cells, times D!, in units of the exact points.
template <int D>
Integer measure_of_cells(const RegularTriangulation<D>& triangulation,
                         const WeightedPoints& points) {
  const oracles::ExactPoints exact = oracles::exact_points(points);
  Integer sum = 0;
  for (const CellRecord<D>& cell : triangulation.template cells<D>()) {
    std::vector<std::vector<Integer>> edges;
    for (std::size_t i = 1; i <= D; ++i) {
      auto& edge = edges.emplace_back();
      for (std::size_t axis = 0; axis < D; ++axis) {
        edge.push_back(exact.position[triangulation.sites().row(cell.corners[i]).row()][axis] -
                       exact.position[triangulation.sites().row(cell.corners[0]).row()][axis]);
      }
    }
    const Integer measure = oracles::determinant(edges);
    EXPECT_GT(measure, 0) << "a cell that is flat or negatively oriented";
    sum += measure;
  }
  return sum;
}

template <class Check>
void for_each_large_case(const Check& check) {
  for (Case one : generators::cases(3, 40, 300)) {
    // Integers of tens of thousands of bits: seconds for dozens of sites.
    if (generators::is_extreme(one.family)) one.count = std::min<std::size_t>(one.count, 16);
    SCOPED_TRACE(::testing::Message() << one);
    if (one.family == PointFamily::mixed_scales && one.count > 60) continue;  // minutes of bigints
    if (one.dimension == 2) check.template operator()<2>(one);
    if (one.dimension == 3) check.template operator()<3>(one);
  }
}

TEST(RegularTriangulation, DoesNotDependOnTheOrderOfTheRows) {
  for_each_large_case([]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    const auto order = generators::random_permutation(points.size(), one.seed + 1);
    const auto original = regular_triangulation<D>(points);
    const auto shuffled = regular_triangulation<D>(generators::with_rows(points, order));
    EXPECT_TRUE(have_same_cells(original, shuffled));
    EXPECT_EQ(matchers::renaming_faults(original, shuffled, order), std::vector<std::string>{});
  });
}

TEST(RegularTriangulation, FillsTheConvexHullWhateverTheWeights) {
  for_each_large_case([]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    const WeightedPoints unweighted =
        points.decimals()
            ? WeightedPoints::fixed_point(
                  D, *points.decimals(), {points.coordinates().begin(), points.coordinates().end()},
                  WeightKind::none, {})
            : WeightedPoints(D, {points.coordinates().begin(), points.coordinates().end()},
                             WeightKind::none, {});
    const auto weighted_measure = measure_of_cells(regular_triangulation<D>(points), points);
    const auto measure = measure_of_cells(regular_triangulation<D>(unweighted), unweighted);
    // The two may have different units.
    const auto unit = [](const WeightedPoints& of) {
      oracles::Rational product = 1;
      for (int i = 0; i < D; ++i) product *= oracles::exact_points(of).unit;
      return product;
    };
    EXPECT_EQ(weighted_measure * unit(points), measure * unit(unweighted));
  });
}

TEST(RegularTriangulation, StaysTheSameWhenScaledByAPowerOfTwo) {
  for_each_large_case([]<int D>(const Case& one) {
    if (one.family == PointFamily::huge || one.family == PointFamily::tiny ||
        one.family == PointFamily::mixed_scales || one.family == PointFamily::protein_like) {
      return;
    }
    const WeightedPoints points = one.points();
    for (const int exponent : {-300, -1, 40, 300}) {
      EXPECT_TRUE(have_same_cells(
          regular_triangulation<D>(points),
          regular_triangulation<D>(generators::scaled_by_power_of_two(points, exponent))))
          << exponent;
    }
  });
}

TEST(RegularTriangulation, OfUnweightedSitesHidesNone) {
  for_each_large_case([]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    if (points.weight_kind() != WeightKind::none) return;
    EXPECT_TRUE(regular_triangulation<D>(points).hidden().empty());
  });
}

}  // namespace
}  // namespace orthoball
