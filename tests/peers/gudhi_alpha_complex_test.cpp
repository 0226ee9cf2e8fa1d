// SPDX-License-Identifier: MIT
// Our values beside those of GUDHI's alpha complex in its exact form, which finds them by other
// code than CGAL's alpha shapes. It gives doubles within an ulp or so of the exact values.
#include <CGAL/Epeck_d.h>
#include <gtest/gtest.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Simplex_tree.h>

#include <limits>
#include <span>

#include "orthoball/triangulation/build.h"
#include "peers/peer_sites.h"

namespace orthoball::peers {
namespace {

using Values = std::map<Rows, double>;

template <int D, bool IsWeighted>
Values values_by_gudhi(const WeightedPoints& points) {
  using Kernel = CGAL::Epeck_d<CGAL::Dimension_tag<D>>;
  std::vector<typename Kernel::Point_d> centres;
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double* x = points.coordinates().data() + D * row;
    centres.emplace_back(x, x + D);
  }
  Gudhi::Simplex_tree<> tree;
  bool is_made = false;
  if constexpr (IsWeighted) {
    const std::vector<typename Kernel::FT> weights(points.weights().begin(),
                                                   points.weights().end());
    is_made = Gudhi::alpha_complex::Alpha_complex<Kernel, true>(centres, weights)
                  .create_complex(tree, std::numeric_limits<double>::infinity(), /*exact=*/true);
  } else {
    is_made = Gudhi::alpha_complex::Alpha_complex<Kernel, false>(centres).create_complex(
        tree, std::numeric_limits<double>::infinity(), /*exact=*/true);
  }
  EXPECT_TRUE(is_made);
  Values values;
  for (const auto simplex : tree.complex_simplex_range()) {
    Rows rows;
    for (const int vertex : tree.simplex_vertex_range(simplex)) {
      rows.push_back(static_cast<std::uint32_t>(vertex));
    }
    std::sort(rows.begin(), rows.end());
    values[rows] = tree.filtration(simplex);
  }
  return values;
}

template <int D>
Values values_by_gudhi(const WeightedPoints& points) {
  return has_weights(points) ? values_by_gudhi<D, true>(points) : values_by_gudhi<D, false>(points);
}

template <int D>
void expect_same_values(std::size_t count) {
  for_each_generic_family(D, count, /*seeds=*/2, [](const WeightedPoints& points) {
    const Filtration<D> filtration(regular_triangulation<D>(points));
    const Values values = values_by_gudhi<D>(points);
    const auto simplices = simplices_by_rows(filtration);
    ASSERT_EQ(simplices.size(), values.size());
    for (const auto& [rows, value] : values) {
      EXPECT_DOUBLE_EQ(filtration.alpha2(filtration.enters(simplices.at(rows))), value);
    }
  });
}

TEST(GudhiAlphaComplex, GivesEverySimplexInThePlaneTheSameValue) { expect_same_values<2>(120); }

TEST(GudhiAlphaComplex, GivesEverySimplexInSpaceTheSameValue) { expect_same_values<3>(60); }

// Whether each number has one among `others`, ascending, that agrees with it to a few ulps.
bool has_partners(std::span<const double> numbers, std::span<const double> others) {
  using Double = ::testing::internal::Double;
  return std::all_of(numbers.begin(), numbers.end(), [&](double number) {
    const auto above = std::lower_bound(others.begin(), others.end(), number);
    return (above != others.end() && Double(*above).AlmostEquals(Double(number))) ||
           (above != others.begin() && Double(*(above - 1)).AlmostEquals(Double(number)));
  });
}

template <int D>
void expect_same_spectrum(std::size_t count) {
  for_each_family(D, count, /*seeds=*/2, [](const WeightedPoints& points) {
    const Filtration<D> filtration(regular_triangulation<D>(points));
    if (filtration.triangulation().affine_dimension() < D) return;
    std::vector<double> theirs;
    for (const auto& [rows, value] : values_by_gudhi<D>(points)) theirs.push_back(value);
    std::sort(theirs.begin(), theirs.end());
    EXPECT_TRUE(has_partners(filtration.spectrum(), theirs));
    EXPECT_TRUE(has_partners(theirs, filtration.spectrum()));
  });
}

TEST(GudhiAlphaComplex, HasTheSameValuesOfAnySitesInThePlane) { expect_same_spectrum<2>(60); }

TEST(GudhiAlphaComplex, HasTheSameValuesOfAnySitesInSpace) { expect_same_spectrum<3>(40); }

}  // namespace
}  // namespace orthoball::peers
