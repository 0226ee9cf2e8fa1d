// SPDX-License-Identifier: MIT
#include "orthoball/exact/orthoradius.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>

#include "generators/point_families.h"
#include "oracles/exact_points.h"

namespace orthoball {
namespace {

using generators::PointFamily;
using generators::points_of;
using oracles::Rational;

template <int D>
Sites<D> sites_of(const WeightedPoints& points) {
  std::vector<SiteId> rows;
  for (std::uint32_t row = 0; row < points.size(); ++row) rows.emplace_back(row);
  return Sites<D>(points, std::move(rows));
}

// The orthocentre of some sites by Gaussian elimination on its definition.
struct Orthoball {
  bool exists = false;                // the sites are affinely independent
  std::vector<Rational> barycentric;  // [corner], of the centre
  Rational squared_radius;            // in input units
};

Orthoball orthoball_of(const oracles::ExactPoints& points, std::span<const std::uint32_t> rows) {
  // The centre is p_0 + sum t_j e_j with 2 (e_i . sum t_j e_j) = |e_i|^2 + w_0 - w_i.
  const std::size_t n = rows.size() - 1;
  const auto axes = static_cast<std::size_t>(points.dimension);
  std::vector<std::vector<Rational>> edge(n, std::vector<Rational>(axes));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const oracles::Integer difference =
          points.position[rows[i + 1]][axis] - points.position[rows[0]][axis];
      edge[i][axis] = Rational(difference);
    }
  }
  const auto dot = [&](const std::vector<Rational>& a, const std::vector<Rational>& b) {
    Rational sum;
    for (std::size_t axis = 0; axis < axes; ++axis) sum += a[axis] * b[axis];
    return sum;
  };
  std::vector<std::vector<Rational>> system(n, std::vector<Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) system[i][j] = dot(edge[i], edge[j]) * Rational(2);
    const oracles::Integer apart = points.weight[rows[0]] - points.weight[rows[i + 1]];
    system[i][n] = dot(edge[i], edge[i]) + Rational(apart);
  }
  Orthoball result;
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && system[pivot][column] == 0) ++pivot;
    if (pivot == n) return result;
    std::swap(system[pivot], system[column]);
    for (std::size_t row = 0; row < n; ++row) {
      if (row == column) continue;
      const Rational factor = system[row][column] / system[column][column];
      for (std::size_t k = column; k <= n; ++k) system[row][k] -= factor * system[column][k];
    }
  }
  result.exists = true;
  result.barycentric.assign(n + 1, Rational(1));
  std::vector<Rational> centre(axes);
  for (std::size_t i = 0; i < n; ++i) {
    const Rational t = system[i][n] / system[i][i];
    result.barycentric[i + 1] = t;
    result.barycentric[0] -= t;
    for (std::size_t axis = 0; axis < axes; ++axis) centre[axis] += t * edge[i][axis];
  }
  result.squared_radius = dot(centre, centre) - Rational(points.weight[rows[0]]);
  result.squared_radius *= points.unit;
  result.squared_radius *= points.unit;
  return result;
}

template <int D, std::size_t Corners>
double label_of(const Sites<D>& sites, const CornerSites<Corners>& simplex) {
  double label = 0.0;
  squared_orthoradii<D, Corners>(sites, std::span(&simplex, 1), std::span(&label, 1));
  return label;
}

Rational exact_power_of_two(int exponent) {
  const oracles::Integer power = oracles::Integer(1) << std::abs(exponent);
  return exponent < 0 ? Rational(oracles::Integer(1), power) : Rational(power);
}

bool same_bits(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Everything about one simplex of the first Corners sites.
template <int D, std::size_t Corners>
void expect_exact_simplex(const Sites<D>& sites, const oracles::ExactPoints& exact,
                          CornerSites<Corners> simplex) {
  const Orthoball expected = orthoball_of(exact, simplex);
  if (!expected.exists) return;
  const double label = oracles::nearest_double(expected.squared_radius);
  unsigned attached = 0;
  for (std::size_t i = 0; i < Corners; ++i) {
    attached |= static_cast<unsigned>(expected.barycentric[i] < 0) << i;
  }
  ASSERT_PRED2(same_bits, (label_of<D, Corners>(sites, simplex)), label);
  ASSERT_PRED2(same_bits, (orthoradius_stages::exact_label<D, Corners>(sites, simplex)), label);
  if constexpr (Corners > 1) {
    if (const auto certified = orthoradius_stages::certified_label<D, Corners>(sites, simplex)) {
      ASSERT_EQ(*certified, label);
    }
    ASSERT_EQ((attached_facets<D, Corners>(sites, simplex)), attached);
    ASSERT_EQ((orthoradius_stages::exact_attached_facets<D, Corners>(sites, simplex)), attached);
    if (const auto mask =
            orthoradius_stages::filtered_attached_facets<D, Corners>(sites, simplex)) {
      ASSERT_EQ(*mask, attached);
    }
    if (const Bounds above = label_remainder<D>(sites, simplex, label); std::isfinite(above.most)) {
      // In the unit of the bounds: the sites', but for decimals.
      const Rational scale = exact_power_of_two(2 * sites.scale_exponent());
      const Rational remainder = (expected.squared_radius - Rational(label)) * scale;
      ASSERT_LE(Rational(above.least), remainder);
      ASSERT_GE(Rational(above.most), remainder);
    }
    std::reverse(simplex.begin(), simplex.end());
    ASSERT_PRED2(same_bits, (label_of<D, Corners>(sites, simplex)), label);
  }
}

template <int D>
void expect_exact(const WeightedPoints& points) {
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints exact = oracles::exact_points(points);
  for (std::uint32_t i = 0; i + 4 <= points.size(); ++i) {
    expect_exact_simplex<D, 1>(sites, exact, {i});
    expect_exact_simplex<D, 2>(sites, exact, {i, i + 1});
    expect_exact_simplex<D, 3>(sites, exact, {i, i + 1, i + 2});
    if constexpr (D == 3) expect_exact_simplex<D, 4>(sites, exact, {i, i + 1, i + 2, i + 3});
  }
}

TEST(Orthoradius, IsTheRoundedRationalOnEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE(std::string(name(family)) + " seed " + std::to_string(seed));
      expect_exact<2>(points_of(family, 2, 12, seed));
      expect_exact<3>(points_of(family, 3, 12, seed));
      if (HasFatalFailure()) return;
    }
  }
}

// Every two simplices of the first few sites, of all dimensions.
template <int D>
void expect_exact_order(const WeightedPoints& points) {
  const Sites<D> sites = sites_of<D>(points);
  const oracles::ExactPoints exact = oracles::exact_points(points);
  std::vector<std::vector<std::uint32_t>> simplices;
  std::vector<Rational> values;
  const auto count = std::min<std::size_t>(points.size(), 6);
  for (unsigned set = 1; set < 1U << count; ++set) {
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < count; ++i) {
      if ((set >> i & 1U) != 0) corners.push_back(i);
    }
    if (corners.size() > D + 1) continue;
    const Orthoball orthoball = orthoball_of(exact, corners);
    if (!orthoball.exists) continue;
    simplices.push_back(corners);
    values.push_back(orthoball.squared_radius);
  }
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    const OrthoradiusPivot<D> pivot(sites, simplices[i]);
    for (std::size_t j = 0; j < simplices.size(); ++j) {
      const Sign expected = values[j] < values[i]   ? Sign::negative
                            : values[j] > values[i] ? Sign::positive
                                                    : Sign::zero;
      ASSERT_EQ(pivot.compare(simplices[j]), expected) << i << " " << j;
    }
  }
}

TEST(OrthoradiusPivot, OrdersAsRationalsDoOnEveryFamily) {
  for (const PointFamily family : generators::point_families()) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      SCOPED_TRACE(std::string(name(family)) + " seed " + std::to_string(seed));
      expect_exact_order<2>(points_of(family, 2, 6, seed));
      expect_exact_order<3>(points_of(family, 3, 5, seed));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Orthoradius, TiesAreNotAttached) {
  // A right triangle: its orthocentre is the middle of the hypotenuse.
  const auto sites = sites_of<2>(WeightedPoints(2, {0, 0, 3, 0, 0, 4}, WeightKind::none, {}));
  EXPECT_EQ((attached_facets<2, 3>(sites, {0, 1, 2})), 0U);
  // One ulp lower, the right angle is obtuse and the hypotenuse attached; one ulp higher, acute.
  const double below = std::nextafter(4.0, 0.0);
  const auto obtuse =
      sites_of<2>(WeightedPoints(2, {0, 0, 3, -0x1p-50, 0, below, 0, 0}, WeightKind::none, {}));
  EXPECT_EQ((attached_facets<2, 3>(obtuse, {0, 1, 2})), 1U);
  EXPECT_EQ((orthoradius_stages::filtered_attached_facets<2, 3>(obtuse, {0, 1, 2})), std::nullopt);
}

TEST(Orthoradius, AVertexIsAttachedByABallThatReachesBeyondItsCentre) {
  const WeightedPoints points(3, {0, 0, 0, 2, 0, 0}, WeightKind::weight, {0.5, 4.5});
  EXPECT_EQ((attached_facets<3, 2>(sites_of<3>(points), {0, 1})), 0U);  // a tie
  const WeightedPoints beyond(3, {0, 0, 0, 2, 0, 0}, WeightKind::weight,
                              {0.5, std::nextafter(4.5, 9.0)});
  EXPECT_EQ((attached_facets<3, 2>(sites_of<3>(beyond), {0, 1})), 2U);
}

TEST(Orthoradius, IsCorrectAtTheEndsOfTheDoubleRange) {
  const double denormal = std::numeric_limits<double>::denorm_min();
  for (const double scale : {1e300, 1e154, 1e-154, 1e-300, 1e-310, denormal}) {
    SCOPED_TRACE(scale);
    expect_exact<3>(
        WeightedPoints(3, {0, 0, 0, 5 * scale, 0, scale, scale, 4 * scale, 0, 0, scale, 3 * scale},
                       WeightKind::none, {}));
    expect_exact<3>(
        WeightedPoints(3, {0, 0, 0, 5 * scale, 0, scale, scale, 4 * scale, 0, 0, scale, 3 * scale},
                       WeightKind::radius, {1e200, 1e200, 0, 1e-200}));
  }
  // Squares beyond the double range are infinite labels and still in exact order.
  const auto sites =
      sites_of<2>(WeightedPoints(2, {0, 0, 1e200, 0, 0, 3e200}, WeightKind::none, {}));
  EXPECT_EQ((label_of<2, 2>(sites, {0, 1})), std::numeric_limits<double>::infinity());
  EXPECT_EQ((label_of<2, 2>(sites, {0, 2})), std::numeric_limits<double>::infinity());
  const std::uint32_t shorter[] = {0, 1}, longer[] = {2, 0};
  EXPECT_EQ(OrthoradiusPivot<2>(sites, shorter).compare(longer), Sign::positive);
}

TEST(Orthoradius, OfDecimalsIsRoundedOnceInInputUnits) {
  // Edges of 0.1 and 0.3: squares 0.01 / 4 and 0.09 / 4 exactly, not those of the doubles 0.1, 0.3.
  const auto sites =
      sites_of<2>(WeightedPoints::fixed_point(2, 1, {0, 0, 1, 0, 0, 3}, WeightKind::none, {}));
  EXPECT_EQ((label_of<2, 2>(sites, {0, 1})), 0.0025);
  EXPECT_EQ((label_of<2, 2>(sites, {0, 2})), 0.0225);
  for (const int decimals : {1, 3, 11, 22, 23, 160, 330, 400}) {
    SCOPED_TRACE(decimals);
    expect_exact<3>(WeightedPoints::fixed_point(3, decimals, {0, 0, 0, 5, 1, 1, -7, 3, 2, 1, 1, 9},
                                                WeightKind::radius, {3, -2, 1, 5}));
  }
}

TEST(Orthoradius, WeightsOfTwoDoublesAreExact) {
  const double large = 0x1p53 - 1;
  expect_exact<3>(WeightedPoints::fixed_point(3, 4, {0, 0, 0, 5, 1, 1, -7, 3, 2, 1, 1, 9},
                                              WeightKind::radius, {large, large - 2, 1, 5}));
  expect_exact<2>(WeightedPoints(2, {0, 0, 5, 1, 1, -7, 3, 2}, WeightKind::radius,
                                 {0.1, 1.0 / 3.0, 1e-9, 1e9}));
}

TEST(Orthoradius, NearlyFlatTetrahedraNeedTheExactStage) {
  const WeightedPoints flat(3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0x1p-52}, WeightKind::none, {});
  const auto sites = sites_of<3>(flat);
  EXPECT_EQ((orthoradius_stages::filtered_attached_facets<3, 4>(sites, {0, 1, 2, 3})),
            std::nullopt);
  expect_exact<3>(flat);
}

TEST(LabelRemainder, SeparatesNearlyAllNearlyCosphericalTetrahedra) {
  const WeightedPoints points = points_of(PointFamily::near_sphere, 3, 400, 3);
  const auto sites = sites_of<3>(points);
  const oracles::ExactPoints exact = oracles::exact_points(points);
  struct Labelled {
    CornerSites<4> corners;
    Bounds above;
  };
  std::vector<Labelled> ones;
  for (std::uint32_t i = 0; i + 4 <= points.size(); i += 4) {
    const CornerSites<4> corners{i, i + 1, i + 2, i + 3};
    expect_exact_simplex<3, 4>(sites, exact, corners);
    if (label_of<3, 4>(sites, corners) != 1.0) continue;
    ones.push_back({corners, label_remainder<3>(sites, corners, 1.0)});
  }
  ASSERT_GT(ones.size(), 30U);
  std::size_t overlapping = 0;
  for (const Labelled& a : ones) {
    const OrthoradiusPivot<3> pivot(sites, a.corners);
    for (const Labelled& b : ones) {
      if (b.above.most < a.above.least) {
        ASSERT_EQ(pivot.compare(b.corners), Sign::negative);
      } else if (a.above.most >= b.above.least && &a != &b) {
        ++overlapping;
      }
    }
  }
  EXPECT_LT(overlapping, ones.size());
}

TEST(Orthoradius, DoublesAreEnoughForNearlyAllRandomSimplices) {
  const WeightedPoints points = points_of(PointFamily::uniform, 3, 4000, 5);
  const auto sites = sites_of<3>(points);
  int filtered = 0;
  int certified = 0;
  int simplices = 0;
  for (std::uint32_t i = 0; i + 4 <= points.size(); i += 4, ++simplices) {
    const CornerSites<4> simplex{i, i + 1, i + 2, i + 3};
    filtered += orthoradius_stages::filtered_attached_facets<3, 4>(sites, simplex) ? 1 : 0;
    certified += orthoradius_stages::certified_label<3, 4>(sites, simplex) ? 1 : 0;
  }
  EXPECT_EQ(filtered, simplices);
  EXPECT_EQ(certified, simplices);
}

}  // namespace
}  // namespace orthoball
