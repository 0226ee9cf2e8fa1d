// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "generators/cases.h"
#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/input/formats.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/points_table.h"
#include "orthoball/triangulation/build.h"
#include "orthoball/vectors.h"
#include "orthoball/weights/added_sites.h"
#include "orthoball/weights/enforced_weights.h"
#include "orthoball/weights/linear_program.h"
#include "orthoball/weights/simplex_presence.h"

namespace orthoball {
namespace {

using generators::Random;

// A wish that can be granted, for other weights do: some simplices of the alpha complex of points
// with weights, and the points without.
struct Wish {
  WeightedPoints points;
  std::vector<SimplexRows> simplices;
  double alpha2;
};

// Decimals, a lattice with many ties and duplicates, or doubles; without weights or with radii.
WeightedPoints random_points(Random& random, int dimension, std::size_t count) {
  const bool is_decimal = random.coin(), is_lattice = is_decimal && random.coin();
  std::vector<double> coordinates, radii;
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(dimension); ++i) {
    coordinates.push_back(is_lattice   ? 2000 * random.integer(0, 4)
                          : is_decimal ? random.integer(0, 10000)
                                       : random.uniform(0.0, 10.0));
  }
  const bool has_radii = random.coin();
  for (std::size_t i = 0; has_radii && i < count; ++i) {
    radii.push_back(is_decimal ? random.integer(0, 1500) : random.uniform(0.0, 1.5));
  }
  const WeightKind kind = has_radii ? WeightKind::radius : WeightKind::none;
  if (!is_decimal) return {dimension, std::move(coordinates), kind, std::move(radii)};
  return WeightedPoints::fixed_point(dimension, 3, std::move(coordinates), kind, std::move(radii));
}

template <int D>
Wish random_wish(std::uint64_t seed) {
  Random random(seed);
  const auto count = static_cast<std::size_t>(random.integer(D + 2, 40));
  Wish wish{random_points(random, D, count), {}, 0.0};
  std::vector<double> coordinates, weights;
  for (std::size_t row = 0; row < count; ++row) {
    for (int axis = 0; axis < D; ++axis) coordinates.push_back(wish.points.coordinate(row, axis));
    weights.push_back(wish.points.weight(row) + random.uniform(-4.0, 4.0));
  }
  const Filtration<D> other(regular_triangulation<D>(
      WeightedPoints(D, std::move(coordinates), WeightKind::weight, std::move(weights))));
  const auto last = static_cast<int>(other.spectrum_size());
  const auto index = static_cast<std::uint32_t>(random.integer((last + 1) / 2, last));
  wish.alpha2 = other.alpha2(index) + 0.001;
  const int wanted = random.integer(1, 8);
  for (int i = 0; i < 200 && static_cast<int>(wish.simplices.size()) < wanted; ++i) {
    const SimplexId simplex(
        static_cast<std::uint32_t>(random.integer(0, static_cast<int>(other.size()) - 1)));
    if (other.dimension(simplex) == 0 || other.enters(simplex) > index) continue;
    const auto rows = other.rows(simplex);
    wish.simplices.emplace_back(rows.begin(), rows.end());
  }
  return wish;
}

// A wish among sites of which some lie in one or two clusters, 10^3 to 10^6 times smaller than all:
// large and small simplices, which share corners.
template <int D>
Wish clustered_wish(std::uint64_t seed) {
  Random random(seed);
  const double ratio = std::pow(10.0, -random.uniform(3.0, 6.0));
  std::vector<double> coordinates, weights;
  const auto put = [&](int count, double size) {
    std::array<double, std::size_t{D}> centre{};
    for (double& x : centre) x = size < 1.0 ? random.uniform(-5.0, 5.0) : 0.0;
    for (int i = 0; i < count; ++i) {
      for (const double x : centre) coordinates.push_back(x + size * random.uniform(-5.0, 5.0));
      weights.push_back(size * size * random.uniform(-80.0, 80.0));
    }
  };
  put(random.integer(D + 1, 10), 1.0);
  const int clusters = random.integer(1, 2);
  for (int i = 0; i < clusters; ++i) put(random.integer(3, 8), ratio);
  const Filtration<D> other(
      regular_triangulation<D>(WeightedPoints(D, coordinates, WeightKind::weight, weights)));
  Wish wish{WeightedPoints(D, std::move(coordinates), WeightKind::none, {}), {}, 0.0};
  wish.alpha2 = std::pow(10.0, random.uniform(-4.0, 1.0));
  while (wish.simplices.size() < 8) {
    const SimplexId simplex(
        static_cast<std::uint32_t>(random.integer(0, static_cast<int>(other.size()) - 1)));
    if (other.dimension(simplex) == 0) continue;
    const auto rows = other.rows(simplex);
    wish.simplices.emplace_back(rows.begin(), rows.end());
  }
  return wish;
}

template <int D>
std::vector<bool> present(const Wish& wish, const WeightedPoints& points) {
  const Filtration<D> filtration(regular_triangulation<D>(points));
  return are_present<D>(filtration, filtration.index(wish.alpha2), wish.simplices);
}

// The weights of points, of which the last `added` cost nothing; fails unless they hold what is
// wished for.
template <int D>
EnforcedWeights granted(const WeightedPoints& points, const Wish& wish, std::size_t added = 0) {
  EnforcedWeights result = enforced_weights(points, wish.simplices, wish.alpha2, Threads(), added);
  EXPECT_EQ(result.conflict, std::vector<std::size_t>());
  if (!result.conflict.empty()) return result;
  const auto are_there = present<D>(wish, result.points);
  EXPECT_EQ(std::count(are_there.begin(), are_there.end(), false), 0);
  return result;
}

// What a reader makes of the table of points.
WeightedPoints written_and_read(const WeightedPoints& points) {
  std::ostringstream text;
  ByteSink sink(text);
  write_points_csv(sink, points);
  const bool are_radii = points.weight_kind() == WeightKind::radius;
  const bool has_weights = points.weight_kind() == WeightKind::weight;
  return read_table({"table.csv", text.str()}, {.radius_column = are_radii ? "radius" : "",
                                                .weight_column = has_weights ? "weight" : ""})
      .points;
}

template <int D>
void expect_granted(std::uint64_t seed) {
  SCOPED_TRACE(testing::Message() << "dimension " << D << ", seed " << seed);
  const Wish wish = random_wish<D>(seed);
  const EnforcedWeights result = granted<D>(wish.points, wish);
  ASSERT_TRUE(result.conflict.empty());

  const Filtration<D> held(regular_triangulation<D>(result.points));
  const Filtration<D> read_back(regular_triangulation<D>(written_and_read(result.points)));
  EXPECT_TRUE(std::equal(held.spectrum().begin(), held.spectrum().end(),
                         read_back.spectrum().begin(), read_back.spectrum().end()));

  // Nothing else: coordinates and the other weights are what they were, and nothing changes where
  // all was there.
  for (std::size_t row = 0; row < wish.points.size(); ++row) {
    for (int axis = 0; axis < D; ++axis) {
      ASSERT_EQ(result.points.coordinate(row, axis), wish.points.coordinate(row, axis));
    }
    const SiteId id(static_cast<std::uint32_t>(row));
    if (std::binary_search(result.changed.begin(), result.changed.end(), id)) continue;
    ASSERT_NEAR(result.points.weight(row), wish.points.weight(row), 1e-13);
  }
  const auto were_there = present<D>(wish, wish.points);
  const bool was_granted = std::count(were_there.begin(), were_there.end(), false) == 0;
  EXPECT_EQ(result.changed.empty(), was_granted);
}

TEST(EnforcedWeights, HoldWhatSomeWeightsHold) {
  if (!has_linear_solver()) GTEST_SKIP() << "built without CLP";
  const std::uint64_t seeds = generators::is_long_run() ? 1000 : 40;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    expect_granted<2>(seed);
    expect_granted<3>(seed);
  }
}

// Weights may be as large as it takes, so that alpha2 is no limit.
template <int D>
void expect_all_sizes_held(std::uint64_t seed) {
  SCOPED_TRACE(testing::Message() << "dimension " << D << ", seed " << seed);
  const Wish wish = clustered_wish<D>(seed);
  (void)granted<D>(wish.points, wish);
}

TEST(EnforcedWeights, HoldSimplicesOfVeryDifferentSizes) {
  if (!has_linear_solver()) GTEST_SKIP() << "built without CLP";
  const std::uint64_t seeds = generators::is_long_run() ? 60 : 20;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    expect_all_sizes_held<2>(seed);
    expect_all_sizes_held<3>(seed);
  }
}

// Random edges, in space triangles too, of few points; most exclude each other: what is named does,
// but for any one left out; what is left can be held; and added sites free all of them.
template <int D>
void expect_fewest_named_and_freed(std::uint64_t seed) {
  SCOPED_TRACE(testing::Message() << "dimension " << D << ", seed " << seed);
  Random random(seed);
  const WeightedPoints points = random_points(random, D, 10);
  const Filtration<D> filtration(regular_triangulation<D>(points));
  std::vector<SimplexRows> simplices;
  while (simplices.size() < (D == 2 ? 6U : 4U)) {
    SimplexRows rows;
    const int corners = D == 2 ? 2 : random.integer(2, 3);
    while (static_cast<int>(rows.size()) < corners) {
      const SiteId row(static_cast<std::uint32_t>(random.integer(0, 9)));
      if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end());
    try {
      (void)enforced_weights(points, std::vector<SimplexRows>{rows}, 1.0);
      simplices.push_back(rows);
    } catch (const InputError&) {  // of corners on one line
    }
  }
  const double alpha2 = 1.0;
  const auto conflict = enforced_weights(points, simplices, alpha2).conflict;
  for (const std::size_t left_out : conflict) {
    std::vector<SimplexRows> others;
    for (const std::size_t i : conflict) {
      if (i != left_out) others.push_back(simplices[i]);
    }
    EXPECT_TRUE(others.empty() || enforced_weights(points, others, alpha2).conflict.empty());
  }
  const AddedSites sites = with_added_sites(points, simplices);
  EXPECT_TRUE(!conflict.empty() || sites.added == 0);
  (void)granted<D>(sites.points, Wish{points, sites.simplices, 1.0}, sites.added);
}

TEST(EnforcedWeights, NameTheFewestThatExcludeEachOtherAndSitesFreeThem) {
  if (!has_linear_solver()) GTEST_SKIP() << "built without CLP";
  const std::uint64_t seeds = generators::is_long_run() ? 1000 : 15;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    expect_fewest_named_and_freed<2>(seed);
    expect_fewest_named_and_freed<3>(seed);
  }
}

double size(const WeightedPoints& points, const SimplexRows& rows) {
  std::array<std::array<double, 3>, 3> x{};
  for (std::size_t corner = 0; corner < rows.size(); ++corner) {
    for (int axis = 0; axis < points.dimension(); ++axis) {
      x[corner][static_cast<std::size_t>(axis)] = points.coordinate(rows[corner].row(), axis);
    }
  }
  const auto along = difference(x[1], x[0]);
  if (rows.size() == 2) return std::sqrt(inner(along, along));
  const auto normal = cross_product(along, difference(x[2], x[0]));
  return std::sqrt(inner(normal, normal));
}

// Triangles, and in the plane edges too, many of which meet: sites are added, few, and all parts
// are held, which together are as large as what they are parts of.
template <int D>
void expect_triangles_freed(std::uint64_t seed) {
  SCOPED_TRACE(testing::Message() << "dimension " << D << ", seed " << seed);
  Random random(seed);
  const int count = D == 2 ? 12 : 18;
  std::vector<double> coordinates;
  for (int i = 0; i < count * D; ++i) coordinates.push_back(random.integer(0, 1000));
  const WeightedPoints points =
      WeightedPoints::fixed_point(D, 3, std::move(coordinates), WeightKind::none, {});
  std::vector<SimplexRows> simplices;
  while (simplices.size() < (D == 2 ? 4 : 3)) {
    const auto order = generators::random_permutation(
        static_cast<std::size_t>(count), static_cast<std::uint64_t>(random.integer(1, 1 << 30)));
    SimplexRows rows;
    for (int i = 0; i < (D == 2 ? random.integer(2, 3) : 3); ++i) {
      rows.emplace_back(order[static_cast<std::size_t>(i)]);
    }
    std::sort(rows.begin(), rows.end());
    if (size(points, rows) > 1e-3) simplices.push_back(rows);
  }
  const AddedSites sites = with_added_sites(points, simplices);
  EXPECT_LE(sites.added, 30U);
  std::vector<double> sum(simplices.size());
  for (std::size_t part = 0; part < sites.simplices.size(); ++part) {
    sum[sites.part_of[part]] += size(sites.points, sites.simplices[part]);
  }
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    EXPECT_NEAR(sum[i], size(points, simplices[i]), 1e-6) << "simplex " << i;
  }
  (void)granted<D>(sites.points, Wish{points, sites.simplices, 1.0}, sites.added);
}

TEST(EnforcedWeights, HoldPartsOfTrianglesThatMeet) {
  if (!has_linear_solver()) GTEST_SKIP() << "built without CLP";
  const std::uint64_t seeds = generators::is_long_run() ? 300 : 15;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    expect_triangles_freed<2>(seed);
    expect_triangles_freed<3>(seed);
  }
}

}  // namespace
}  // namespace orthoball
