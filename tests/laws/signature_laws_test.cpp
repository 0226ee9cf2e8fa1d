// SPDX-License-Identifier: MIT
// What holds for the signatures of any sites.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "generators/cases.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;
using generators::PointFamily;

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

template <int D>
std::vector<Signature<D>> all_signatures(const Filtration<D>& filtration) {
  std::vector<Signature<D>> all;
  scan_signatures<D>(filtration, [&](const Signature<D>& signature) { all.push_back(signature); });
  return all;
}

TEST(Signature, HasAnEulerNumberThatIsTheAlternatingSumOfItsBettiNumbers) {
  for_each_large_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    for (const Signature<D>& signature : all_signatures(filtration)) {
      std::int64_t by_betti = 0, by_roles = 0;
      for (std::size_t k = 0; k < D; ++k) {
        by_betti += (k % 2 == 0 ? 1 : -1) * static_cast<std::int64_t>(signature.betti[k]);
      }
      for (std::size_t k = 0; k <= D; ++k) {
        const std::int64_t in_complex =
            std::int64_t{signature.singular[k]} + signature.regular[k] + signature.interior[k];
        by_roles += k % 2 == 0 ? in_complex : -in_complex;
        ASSERT_EQ(in_complex + signature.exterior[k],
                  static_cast<std::int64_t>(filtration.count(static_cast<int>(k))));
      }
      ASSERT_EQ(signature.euler, by_betti) << signature.index;
      ASSERT_EQ(signature.euler, by_roles) << signature.index;
    }
  });
}

TEST(Signature, CountsRolesAsTheFiltrationHasThem) {
  for_each_large_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    const auto all = all_signatures(filtration);
    for (const std::uint32_t index :
         {1U, filtration.spectrum_size() / 3 + 1, filtration.spectrum_size() / 2 + 1,
          filtration.spectrum_size()}) {
      Signature<D> counts;
      for (std::uint32_t row = 0; row < filtration.size(); ++row) {
        const SimplexId simplex(row);
        const auto dimension = static_cast<std::size_t>(filtration.dimension(simplex));
        switch (filtration.role(simplex, index)) {
          case Role::exterior:
            ++counts.exterior[dimension];
            break;
          case Role::singular:
            ++counts.singular[dimension];
            break;
          case Role::regular:
            ++counts.regular[dimension];
            break;
          case Role::interior:
            ++counts.interior[dimension];
            break;
        }
      }
      ASSERT_EQ(all[index - 1].exterior, counts.exterior);
      ASSERT_EQ(all[index - 1].singular, counts.singular);
      ASSERT_EQ(all[index - 1].regular, counts.regular);
      ASSERT_EQ(all[index - 1].interior, counts.interior);
    }
  });
}

// The measures of the boundary of the convex hull, each from its facets alone.
struct HullMeasures {
  double volume = 0.0, area = 0.0, length = 0.0;
};

using Vector = std::array<double, 3>;
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Edge lengths times the angle between the outer normals of the two hull triangles beside them.
HullMeasures hull_measures(const Filtration<3>& filtration, const WeightedPoints& points) {
  const auto position = [&](SiteId row) {
    Vector x{};
    for (int axis = 0; axis < 3; ++axis) {
      x[static_cast<std::size_t>(axis)] = points.coordinate(row.row(), axis);
    }
    return x;
  };
  HullMeasures result;
  std::map<std::pair<SiteId, SiteId>, std::vector<Vector>> normals;
  const Vector origin = position(filtration.triangulation().sites().row(0));
  for (std::size_t i = 0; i < filtration.count(2); ++i) {
    const SimplexId facet(filtration.table().first(2) + static_cast<std::uint32_t>(i));
    const auto cells = filtration.cells_beside(facet);
    if (cells.size() != 1) continue;
    const auto rows = filtration.rows(facet);
    Vector inside{};
    for (const SiteId row : filtration.rows(cells[0])) {
      if (std::find(rows.begin(), rows.end(), row) == rows.end()) inside = position(row);
    }
    const Vector a = position(rows[0]), b = position(rows[1]), c = position(rows[2]);
    Vector normal = cross(difference(b, a), difference(c, a));
    if (dot(normal, difference(inside, a)) > 0) normal = {-normal[0], -normal[1], -normal[2]};
    const double norm = std::sqrt(dot(normal, normal));
    result.area += norm / 2;
    result.volume += dot(normal, difference(a, origin)) / 6;
    for (const auto& [from, to] : {std::pair(0U, 1U), std::pair(0U, 2U), std::pair(1U, 2U)}) {
      normals[{rows[from], rows[to]}].push_back(normal);
    }
  }
  for (const auto& [edge, beside] : normals) {
    const Vector along = difference(position(edge.second), position(edge.first));
    const Vector turn = cross(beside[0], beside[1]);
    result.length += std::sqrt(dot(along, along)) *
                     std::atan2(std::sqrt(dot(turn, turn)), dot(beside[0], beside[1]));
  }
  return result;
}

TEST(Signature, EndsWithTheConvexHull) {
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::uniform_balls, PointFamily::gaussian,
        PointFamily::protein_like, PointFamily::scan_like, PointFamily::grid,
        PointFamily::cospherical, PointFamily::hidden_heavy}) {
    for (const std::size_t count : {20U, 200U, 2000U}) {
      const WeightedPoints points = generators::points_of(family, 3, count, 5);
      const auto filtration = filtration_of<3>(points);
      const std::uint32_t last = filtration.spectrum_size();
      const Signature<3> end = signatures<3>(filtration, std::span(&last, 1)).front();
      const HullMeasures hull = hull_measures(filtration, points);
      SCOPED_TRACE(name(family));
      EXPECT_EQ(end.betti, (std::array<std::uint32_t, 3>{1, 0, 0}));
      EXPECT_NEAR(end.volume, hull.volume, 1e-12 * hull.volume);
      EXPECT_NEAR(end.area, hull.area, 1e-12 * hull.area);
      EXPECT_NEAR(end.length, hull.length, 1e-12 * hull.length);
      EXPECT_EQ(end.area_singular, 0.0);
    }
  }
}

TEST(Signature, EndsWithOneComponentThatFillsTheSpan) {
  for_each_large_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    const std::uint32_t last = filtration.spectrum_size();
    const Signature<D> end = signatures<D>(filtration, std::span(&last, 1)).front();
    ASSERT_EQ(end.betti[0], 1U);
    for (std::size_t k = 1; k < D; ++k) ASSERT_EQ(end.betti[k], 0U);
    if (filtration.triangulation().affine_dimension() == D) return;
    ASSERT_EQ(end.volume, 0.0);
    ASSERT_EQ(end.area_regular, 0.0);
    ASSERT_EQ(end.area, 2 * end.area_singular);
  });
}

TEST(Signature, HasTheSameBytesForShuffledRows) {
  for_each_large_case([]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    const auto order = generators::random_permutation(points.size(), one.seed + 1);
    const auto original = all_signatures(filtration_of<D>(points));
    const auto shuffled = all_signatures(filtration_of<D>(generators::with_rows(points, order)));
    ASSERT_EQ(original.size(), shuffled.size());
    const auto numbers = [](const Signature<D>& of) {
      return std::array{of.alpha2, of.volume,       of.area,
                        of.length, of.area_regular, of.area_singular};
    };
    for (std::size_t i = 0; i < original.size(); ++i) {
      const auto a = numbers(original[i]), b = numbers(shuffled[i]);
      ASSERT_EQ(std::memcmp(a.data(), b.data(), sizeof a), 0) << i;
      ASSERT_EQ(original[i].betti, shuffled[i].betti);
      ASSERT_EQ(original[i].regular, shuffled[i].regular);
      ASSERT_EQ(original[i].interior, shuffled[i].interior);
    }
  });
}

TEST(Signature, ScaledByAPowerOfTwoScalesItsMeasures) {
  for_each_large_case([]<int D>(const Case& one) {
    if (generators::is_extreme(one.family) || one.family == PointFamily::protein_like) return;
    const WeightedPoints points = one.points();
    const auto original = all_signatures(filtration_of<D>(points));
    // Lengths pass through 0, between values that are as large as the hull's.
    const double size = std::max({1e-9, original.back().volume, original.back().length});
    const auto expect_scaled = [&](double scaled, double value, int exponent) {
      ASSERT_NEAR(std::ldexp(scaled, -exponent), value, 1e-12 * (std::abs(value) + size));
    };
    for (const int exponent : {-200, 13, 200}) {
      const auto scaled =
          all_signatures(filtration_of<D>(generators::scaled_by_power_of_two(points, exponent)));
      ASSERT_EQ(original.size(), scaled.size());
      for (std::size_t i = 0; i < original.size(); ++i) {
        const auto &a = original[i], &b = scaled[i];
        expect_scaled(b.volume, a.volume, D * exponent);
        expect_scaled(b.area, a.area, (D - 1) * exponent);
        expect_scaled(b.area_regular, a.area_regular, (D - 1) * exponent);
        expect_scaled(b.length, a.length, exponent);
      }
    }
  });
}

// The dihedral angles of one cube, however it is cut into tetrahedra, add up to the cube's.
TEST(Signature, OfTurnedLatticesKeepsItsBettiNumbersAndMeasures) {
  for (const PointFamily family : {PointFamily::grid, PointFamily::lattice,
                                   PointFamily::cospherical, PointFamily::nested_balls}) {
    const WeightedPoints points = generators::points_of(family, 3, 64, 3);
    const auto original = all_signatures(filtration_of<3>(points));
    for (std::size_t turn = 1; turn < 6; ++turn) {
      std::vector<double> turned;
      for (std::size_t row = 0; row < points.size(); ++row) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double x = points.coordinates()[3 * row + (axis + turn) % 3];
          turned.push_back(turn >= 3 && axis == 0 ? -x : x);
        }
      }
      const auto signatures = all_signatures(filtration_of<3>(WeightedPoints(
          3, turned, points.weight_kind(), {points.weights().begin(), points.weights().end()})));
      ASSERT_EQ(signatures.size(), original.size());
      for (std::size_t i = 0; i < original.size(); ++i) {
        const auto &a = signatures[i], &b = original[i];
        SCOPED_TRACE(name(family));
        ASSERT_EQ(a.betti, b.betti);
        ASSERT_EQ(a.singular, b.singular);
        ASSERT_NEAR(a.volume, b.volume, 1e-12 * original.back().volume);
        ASSERT_NEAR(a.area, b.area, 1e-11 * std::max(b.area, original.back().area));
        ASSERT_NEAR(a.length, b.length, 1e-11 * std::max(b.length, original.back().length));
      }
    }
  }
}

}  // namespace
}  // namespace orthoball
