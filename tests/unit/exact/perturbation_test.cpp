// SPDX-License-Identifier: MIT
#include "orthoball/exact/perturbation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "oracles/exact_predicates.h"
#include "tuples.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::Random;
using oracles::Integer;
using tuples::sites_at;
using tuples::sites_of;

TEST(Precedes, OrdersPositionsLexicographically) {
  const Sites<3> sites = sites_at<3>({0, 5, 5, 1, 0, 0, 1, 0, 2, 1, 3, -9, 2, -1, 0});
  for (std::uint32_t a = 0; a < 5; ++a) {
    for (std::uint32_t b = 0; b < 5; ++b) EXPECT_EQ(precedes(sites, a, b), a < b);
  }
}

TEST(Precedes, SeesWhatADoubleOfTheFastStagesCannotHold) {
  const double least = std::numeric_limits<double>::denorm_min();
  const Sites<2> sites = sites_at<2>({least, 1e300, 2 * least, 0, 2 * least, 1});
  ASSERT_FALSE(sites.is_exact());
  ASSERT_EQ(sites[0].x[0], sites[1].x[0]);
  EXPECT_TRUE(precedes(sites, 0, 1));
  EXPECT_FALSE(precedes(sites, 1, 0));
  EXPECT_TRUE(precedes(sites, 1, 2));
}

// The points with actual numbers for the infinitesimals: the weight of rank i of n is lowered by
// 2^-200 (n - i), so each number outweighs all before it by far more than lattice coordinates do.
oracles::ExactPoints lowered(const oracles::ExactPoints& points) {
  std::vector<std::size_t> by_position(points.position.size());
  std::iota(by_position.begin(), by_position.end(), std::size_t{0});
  std::sort(by_position.begin(), by_position.end(),
            [&](std::size_t a, std::size_t b) { return points.position[a] < points.position[b]; });
  const auto scale = static_cast<unsigned>(100 * (points.position.size() + 1));
  oracles::ExactPoints result = points;
  for (auto& position : result.position) {
    for (Integer& x : position) x <<= scale;
  }
  for (std::size_t rank = 0; rank < by_position.size(); ++rank) {
    Integer& weight = result.weight[by_position[rank]];
    weight <<= 2 * scale;
    weight -= Integer(1) << (200 * (rank + 1));
  }
  return result;
}

struct Reached {
  bool query_first = false;  // the query dominates: no conflict
  bool positive = false;     // a corner with positive coefficient dominates: conflict
  bool negative = false;     // one with negative coefficient: none
  bool left_out = false;     // the highest corner has coefficient 0 and is passed over
};

// Compares every tie among random tuples with the lowered weights.
template <int A, int D>
void check_ties(const WeightedPoints& points, std::uint64_t seed, int count, Reached& reached) {
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints truth = oracles::exact_points(points);
  Random random(seed);
  std::array<int, std::size_t{A}> axes;
  std::iota(axes.begin(), axes.end(), 0);
  for (int i = 0; i < count; ++i) {
    const auto rows = tuples::any_rows<A + 2>(random, points.size());
    const std::uint32_t query = rows.back();
    Corners<A> corners;
    std::copy_n(rows.begin(), A + 1, corners.begin());
    const Sign side = oracles::sign_of(oracles::orientation(truth, corners, axes));
    if (side == Sign::zero) continue;
    if (side == Sign::negative) std::swap(corners[0], corners[1]);
    if (power_side<A, D>(sites, corners, query) != Sign::zero) continue;

    oracles::ExactPoints tuple{truth.dimension, truth.unit, {}, {}};
    for (const std::uint32_t row : corners) {
      tuple.position.push_back(truth.position[row]);
      tuple.weight.push_back(truth.weight[row]);
    }
    tuple.position.push_back(truth.position[query]);
    tuple.weight.push_back(truth.weight[query]);
    auto places = tuple.position;
    std::sort(places.begin(), places.end());
    if (std::adjacent_find(places.begin(), places.end()) != places.end()) continue;
    Corners<A> first;
    std::iota(first.begin(), first.end(), 0U);
    const Integer lifted = oracles::power_determinant(lowered(tuple), first, A + 1);
    ASSERT_NE(lifted, 0);
    EXPECT_EQ((perturbed_conflict<A, D>(sites, corners, query)), lifted > 0);
    EXPECT_EQ((in_conflict<A, D>(sites, corners, query)), lifted > 0);

    // Which branch that was.
    std::array<std::uint32_t, std::size_t{A + 2}> descending{};
    std::iota(descending.begin(), descending.end(), 0U);
    std::sort(descending.begin(), descending.end(), [&](std::uint32_t a, std::uint32_t b) {
      return tuple.position[b] < tuple.position[a];
    });
    for (const std::uint32_t at : descending) {
      if (at == A + 1) {
        reached.query_first = true;
        break;
      }
      Corners<A> replaced = first;
      replaced[at] = A + 1;
      const Integer coefficient = oracles::orientation(tuple, replaced, axes);
      if (coefficient > 0) reached.positive = true;
      if (coefficient < 0) reached.negative = true;
      if (coefficient != 0) break;
      reached.left_out = true;
    }
  }
}

// Lengths times an odd number, which no unit takes back.
WeightedPoints stretched(const WeightedPoints& points, double factor) {
  std::vector<double> coordinates(points.coordinates().begin(), points.coordinates().end());
  std::vector<double> weights(points.weights().begin(), points.weights().end());
  for (double& x : coordinates) x *= factor;
  const bool are_squares = points.weight_kind() == WeightKind::weight;
  for (double& weight : weights) weight *= are_squares ? factor * factor : factor;
  return {points.dimension(), coordinates, points.weight_kind(), weights};
}

template <int A, int D>
Reached reached_by_ties() {
  Reached reached;
  for (const PointFamily family :
       {PointFamily::grid, PointFamily::lattice, PointFamily::cospherical, PointFamily::coplanar,
        PointFamily::nested_balls}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const WeightedPoints points = points_of(family, D, 27, seed);
      // About where differences become too large for the way of small ones, and far beyond.
      for (const double factor : {1.0, 301.0, 3001.0, 1000003.0}) {
        check_ties<A, D>(factor == 1.0 ? points : stretched(points, factor), seed, 200, reached);
      }
    }
  }
  return reached;
}

TEST(PerturbedConflict, LowersTheWeightOfTheLargestPositionMostInThePlane) {
  const Reached reached = reached_by_ties<2, 2>();
  EXPECT_TRUE(reached.query_first);
  EXPECT_TRUE(reached.positive);
  EXPECT_TRUE(reached.negative);
  EXPECT_TRUE(reached.left_out);
}

TEST(PerturbedConflict, LowersTheWeightOfTheLargestPositionMostInSpace) {
  const Reached reached = reached_by_ties<3, 3>();
  EXPECT_TRUE(reached.query_first);
  EXPECT_TRUE(reached.positive);
  EXPECT_TRUE(reached.negative);
  EXPECT_TRUE(reached.left_out);
}

// On a line with weights: squares whose lifts lie on one line. No coefficient vanishes there.
TEST(PerturbedConflict, LowersTheWeightOfTheLargestPositionMostOnALine) {
  Reached reached;
  std::vector<double> coordinates, weights;
  for (int i = 0; i < 12; ++i) {
    coordinates.insert(coordinates.end(), {static_cast<double>(i), 0.0, 0.0});
    weights.push_back(static_cast<double>(i * i));
  }
  check_ties<1, 3>({3, coordinates, WeightKind::weight, weights}, 1, 300, reached);
  EXPECT_TRUE(reached.query_first);
  EXPECT_TRUE(reached.positive);
  EXPECT_TRUE(reached.negative);
}

// Sites of a plane of space, on their first two axes with all three in the lift.
TEST(PerturbedConflict, HoldsWithinAPlaneOfSpace) {
  std::vector<double> coordinates;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      coordinates.insert(coordinates.end(), {static_cast<double>(i), static_cast<double>(j),
                                             static_cast<double>(2 * i)});
    }
  }
  Reached reached;
  check_ties<2, 3>({3, coordinates, WeightKind::none, {}}, 1, 2000, reached);
  EXPECT_TRUE(reached.query_first);
  EXPECT_TRUE(reached.positive);
  EXPECT_TRUE(reached.negative);
}

// The unit square: each corner in turn is the query, the others the triangle. By the rule the
// diagonal is the one that avoids the largest position, (1, 1).
TEST(PerturbedConflict, CutsASquareBesideItsLargestCorner) {
  const Sites<2> sites = sites_at<2>({0, 0, 1, 0, 1, 1, 0, 1});
  EXPECT_FALSE((perturbed_conflict<2, 2>(sites, {0, 1, 3}, 2)));
  EXPECT_TRUE((perturbed_conflict<2, 2>(sites, {0, 1, 2}, 3)));
  EXPECT_TRUE((perturbed_conflict<2, 2>(sites, {0, 2, 3}, 1)));
  EXPECT_FALSE((perturbed_conflict<2, 2>(sites, {1, 2, 3}, 0)));
}

TEST(PerturbedConflict, PassesOverACornerThatDoesNotBearOnTheQuery) {
  // The query halves the edge from 0 to 1: the third corner, the largest, has coefficient 0.
  const Sites<2> sites =
      sites_of<2>({2, {0, 0, 2, 0, 3, 3, 1, 0}, WeightKind::weight, {0, 0, 5, -1}});
  ASSERT_EQ((power_side<2, 2>(sites, {0, 1, 2}, 3)), Sign::zero);
  EXPECT_TRUE((perturbed_conflict<2, 2>(sites, {0, 1, 2}, 3)));
}

}  // namespace
}  // namespace orthoball
