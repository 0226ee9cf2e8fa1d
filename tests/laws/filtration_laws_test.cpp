// SPDX-License-Identifier: MIT
// What holds for the filtration of any sites.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "generators/cases.h"
#include "matchers/same_bytes.h"
#include "matchers/same_filtration.h"
#include "orthoball/filtration/filter.h"
#include "orthoball/filtration/filtration.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;
using generators::PointFamily;
using Sentences = std::vector<std::string>;

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

template <class Check>
void for_each_large_case(const Check& check) {
  for (Case one : generators::cases(3, 40, 300)) {
    // Integers of tens of thousands of bits: seconds for dozens of sites.
    if (generators::is_extreme(one.family)) one.count = std::min<std::size_t>(one.count, 16);
    SCOPED_TRACE(::testing::Message() << one);
    if (one.dimension == 2) check.template operator()<2>(one);
    if (one.dimension == 3) check.template operator()<3>(one);
    if (::testing::Test::HasFailure()) return;  // one case tells enough
  }
}

// Families whose numbers are small integers, so that moving them is exact.
template <class Check>
void for_each_integer_case(const Check& check) {
  for_each_large_case([&]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    const auto is_small_integer = [](double x) { return std::round(x) == x && std::abs(x) < 1e4; };
    if (points.decimals() ||
        !std::all_of(points.coordinates().begin(), points.coordinates().end(), is_small_integer) ||
        !std::all_of(points.weights().begin(), points.weights().end(), is_small_integer)) {
      return;
    }
    check.template operator()<D>(points);
  });
}

std::vector<double> spectrum_of(const auto& filtration) {
  return {filtration.spectrum().begin(), filtration.spectrum().end()};
}

TEST(Filtration, HasThreeIndicesThatFollowFromTheCofaces) {
  for_each_large_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    const int top = filtration.triangulation().affine_dimension();
    std::vector<std::uint32_t> first_coface(filtration.size(), filtration.never());
    std::vector<std::uint32_t> last_cell(filtration.size(), 0);
    std::vector<bool> is_on_hull(filtration.size(), top < D);

    for (auto row = static_cast<std::uint32_t>(filtration.size()); row-- > 0;) {  // cofaces first
      const SimplexId simplex(row);
      const int dimension = filtration.dimension(simplex);
      const std::uint32_t enters = filtration.enters(simplex);
      if (dimension == top) last_cell[row] = enters;
      if (dimension == top - 1) {
        is_on_hull[row] = is_on_hull[row] || filtration.cells_beside(simplex).size() == 1;
      }
      for (const SimplexId facet : filtration.facets(simplex)) {
        ASSERT_LE(filtration.enters(facet), enters);
        first_coface[facet.row()] = std::min(first_coface[facet.row()], enters);
        last_cell[facet.row()] = std::max(last_cell[facet.row()], last_cell[row]);
        if (is_on_hull[row]) is_on_hull[facet.row()] = true;
      }
      const bool is_solid = dimension == D;
      ASSERT_EQ(filtration.regular(simplex), is_solid ? enters : first_coface[row]);
      ASSERT_EQ(filtration.interior(simplex),
                is_on_hull[row] ? filtration.never() : last_cell[row]);
      ASSERT_LE(enters, filtration.regular(simplex));
      ASSERT_LE(filtration.regular(simplex), filtration.interior(simplex));
      if (filtration.is_attached(simplex)) {
        ASSERT_EQ(enters, first_coface[row]);
      }
    }
  });
}

TEST(Filter, IsSortedSoThatEveryPrefixIsAComplex) {
  for_each_large_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    const Filter<D> filter(filtration);
    std::vector<bool> is_in(filtration.size(), false);
    std::uint32_t index = 0;
    int dimension = 0;
    for (std::size_t position = 0; position < filtration.size(); ++position) {
      const SimplexId simplex = filter.simplices()[position];
      ASSERT_FALSE(is_in[simplex.row()]);
      is_in[simplex.row()] = true;
      for (const SimplexId facet : filtration.facets(simplex)) ASSERT_TRUE(is_in[facet.row()]);
      ASSERT_GE(filtration.enters(simplex), index);
      if (filtration.enters(simplex) != index) {
        ASSERT_EQ(filtration.enters(simplex), index + 1) << "an entry of the spectrum is not used";
        ASSERT_EQ(filter.complex_size(index), position);
        index = filtration.enters(simplex);
        dimension = 0;
      }
      ASSERT_GE(filtration.dimension(simplex), dimension);
      dimension = filtration.dimension(simplex);
    }
    ASSERT_EQ(index, filtration.spectrum_size());
    ASSERT_TRUE(std::is_sorted(filtration.spectrum().begin(), filtration.spectrum().end()));
  });
}

TEST(Filtration, DoesNotDependOnTheOrderOfTheRows) {
  for_each_large_case([]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    const auto order = generators::random_permutation(points.size(), one.seed + 1);
    const auto original = filtration_of<D>(points);
    const auto shuffled = filtration_of<D>(generators::with_rows(points, order));
    EXPECT_EQ(matchers::order_faults(original, shuffled), Sentences{});
    EXPECT_TRUE(matchers::same_bytes(original.spectrum(), shuffled.spectrum()));
    EXPECT_EQ(matchers::renaming_faults(original.triangulation(), shuffled.triangulation(), order),
              Sentences{});
  });
}

TEST(Filtration, ScaledByAPowerOfTwoScalesItsLabelsExactly) {
  for_each_large_case([]<int D>(const Case& one) {
    if (one.family == PointFamily::huge || one.family == PointFamily::tiny ||
        one.family == PointFamily::mixed_scales || one.family == PointFamily::protein_like) {
      return;
    }
    const WeightedPoints points = one.points();
    const auto original = filtration_of<D>(points);
    for (const int exponent : {-200, -1, 40, 200}) {
      const auto scaled = filtration_of<D>(generators::scaled_by_power_of_two(points, exponent));
      EXPECT_EQ(matchers::order_faults(original, scaled), Sentences{}) << exponent;
      std::vector<double> labels = spectrum_of(original);
      for (double& label : labels) label = std::ldexp(label, 2 * exponent);
      EXPECT_EQ(spectrum_of(scaled), labels) << exponent;
    }
  });
}

TEST(Filtration, OfIntegersMovedByIntegersKeepsItsLabels) {
  for_each_integer_case([]<int D>(const WeightedPoints& points) {
    const auto original = filtration_of<D>(points);
    for (const double shift : {1.0, -37.0, 0x1p30, 0x1p50}) {
      std::vector<double> moved(points.coordinates().begin(), points.coordinates().end());
      for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += i % D == 0 ? shift : 1 - shift;
      const auto filtration = filtration_of<D>(WeightedPoints(
          D, moved, points.weight_kind(), {points.weights().begin(), points.weights().end()}));
      EXPECT_EQ(spectrum_of(filtration), spectrum_of(original)) << shift;
      // Vertices may be numbered along another curve: compare what people see.
      const auto rows = [](const Filtration<D>& of) {
        std::vector<std::vector<std::uint32_t>> table;
        for (const SimplexId simplex : Filter<D>(of).by_rows()) {
          auto& entry = table.emplace_back();
          for (const SiteId row : of.rows(simplex)) entry.push_back(row.row());
          entry.insert(entry.end(), {of.enters(simplex), of.regular(simplex), of.interior(simplex),
                                     of.is_attached(simplex) ? 1U : 0U});
        }
        return table;
      };
      EXPECT_EQ(rows(filtration), rows(original)) << shift;
    }
  });
}

TEST(Filtration, OfSitesWithAllWeightsRaisedOnlyMovesItsLabels) {
  for_each_integer_case([]<int D>(const WeightedPoints& points) {
    if (points.weight_kind() == WeightKind::radius) return;
    const auto original = filtration_of<D>(points);
    for (const double raise : {3.0, -1000.0, 0x1p-10}) {
      std::vector<double> weights(points.size(), 0.0);
      std::copy(points.weights().begin(), points.weights().end(), weights.begin());
      for (double& weight : weights) weight += raise;
      const auto raised = filtration_of<D>(
          WeightedPoints(D, {points.coordinates().begin(), points.coordinates().end()},
                         WeightKind::weight, weights));
      EXPECT_EQ(matchers::order_faults(original, raised), Sentences{}) << raise;
      ASSERT_EQ(original.spectrum_size(), raised.spectrum_size());
      for (std::uint32_t index = 1; index < original.never(); ++index) {
        // Each label is rounded once: half an ulp on either side.
        const double label = original.alpha2(index), moved = raised.alpha2(index);
        const double ulp = std::ldexp(std::max({std::abs(label), std::abs(moved), raise}), -52);
        EXPECT_NEAR(moved, label - raise, ulp);
      }
    }
  });
}

TEST(Filtration, OfTurnedLatticesKeepsItsSpectrum) {
  for_each_integer_case([]<int D>(const WeightedPoints& points) {
    const auto original = filtration_of<D>(points);
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      for (unsigned mirrored = 0; mirrored < 1U << D; mirrored += 3) {
        std::vector<double> turned;
        for (std::size_t row = 0; row < points.size(); ++row) {
          for (std::size_t axis = 0; axis < D; ++axis) {
            const double x = points.coordinates()[D * row + axes[axis]];
            turned.push_back((mirrored >> axis & 1U) != 0 ? -x : x);
          }
        }
        const auto filtration = filtration_of<D>(WeightedPoints(
            D, turned, points.weight_kind(), {points.weights().begin(), points.weights().end()}));
        EXPECT_EQ(spectrum_of(filtration), spectrum_of(original));
      }
    } while (std::next_permutation(axes.begin(), axes.begin() + D));
  });
}

}  // namespace
}  // namespace orthoball
