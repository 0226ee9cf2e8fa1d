// SPDX-License-Identifier: MIT
// Signatures and notable alphas of a few sites are what the definitions say, at every index.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generators/cases.h"
#include "oracles/brute_force.h"
#include "oracles/exact_points.h"
#include "orthoball/measures/complex_measures.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"
#include "orthoball/topology/union_find.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using oracles::BruteForce;
using oracles::BruteSimplex;
using oracles::ExactPoints;
using oracles::Rational;

Role role(const BruteSimplex& simplex, std::uint32_t index) {
  if (index < simplex.enters) return Role::exterior;
  if (index < simplex.regular) return Role::singular;
  return index < simplex.interior ? Role::regular : Role::interior;
}

using Vector = std::vector<Rational>;

Vector difference(const ExactPoints& points, std::uint32_t a, std::uint32_t b) {
  Vector result;
  for (std::size_t axis = 0; axis < points.position[a].size(); ++axis) {
    result.push_back((Rational(points.position[b][axis]) - points.position[a][axis]) * points.unit);
  }
  return result;
}

Rational dot(const Vector& a, const Vector& b) {
  Rational sum = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += a[axis] * b[axis];
  return sum;
}

// Half the exponent of a positive number, so that value / 4^result is near 1.
int half_exponent(const Rational& value) {
  const auto bits = [](const oracles::Integer& n) { return static_cast<int>(msb(n)); };
  return (bits(numerator(value)) - bits(denominator(value))) / 2;
}

Rational power_of_four(int exponent) {
  const oracles::Integer power = oracles::Integer(1) << (2 * std::abs(exponent));
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

double root(const Rational& value) {
  if (value == 0) return 0.0;
  const int half = half_exponent(value);
  return std::ldexp(std::sqrt(oracles::nearest_double(value / power_of_four(half))), half);
}

// The squared k-dimensional volume of a simplex by Gram's determinant.
Rational squared_volume(const ExactPoints& points, const std::vector<std::uint32_t>& rows) {
  const std::size_t k = rows.size() - 1;
  std::vector<Vector> edges;
  for (std::size_t i = 1; i <= k; ++i) edges.push_back(difference(points, rows[0], rows[i]));
  if (k == 1) return dot(edges[0], edges[0]);
  const auto g = [&](std::size_t i, std::size_t j) { return dot(edges[i], edges[j]); };
  if (k == 2) return (g(0, 0) * g(1, 1) - g(0, 1) * g(0, 1)) / 4;
  const Rational determinant = g(0, 0) * (g(1, 1) * g(2, 2) - g(1, 2) * g(1, 2)) -
                               g(0, 1) * (g(0, 1) * g(2, 2) - g(1, 2) * g(0, 2)) +
                               g(0, 2) * (g(0, 1) * g(1, 2) - g(1, 1) * g(0, 2));
  return determinant / 36;
}

// The angle of a tetrahedron at the edge of rows i and j, between its facets.
double dihedral(const ExactPoints& points, std::uint32_t i, std::uint32_t j, std::uint32_t k,
                std::uint32_t l) {
  const Vector edge = difference(points, i, j);
  const auto across = [&](std::uint32_t row) {  // from the line of the edge to the row
    Vector to = difference(points, i, row);
    const Rational share = dot(to, edge) / dot(edge, edge);
    for (std::size_t axis = 0; axis < to.size(); ++axis) to[axis] -= share * edge[axis];
    return to;
  };
  const Vector a = across(k), b = across(l);
  const Rational cosine = dot(a, b);  // times |a| |b|
  const Rational squared_sine = dot(a, a) * dot(b, b) - cosine * cosine;
  const int half = half_exponent(dot(a, a) * dot(b, b));
  const double c = root(cosine * cosine / power_of_four(half));
  const double s = root(squared_sine / power_of_four(half));
  return std::atan2(s, cosine < 0 ? -c : c);
}

// What each simplex contributes by itself.
struct Measured {
  double volume = 0.0;  // of its own dimension
  double length =
      0.0;  // edges: 2 pi len; triangles: -pi perimeter; tetrahedra: sum len (pi - dihedral)
  double size = 0.0;  // longest edge
};

Measured measured(const ExactPoints& points, const std::vector<std::uint32_t>& rows) {
  Measured result{root(squared_volume(points, rows)), 0.0, 0.0};
  const auto length = [&](std::size_t i, std::size_t j) {
    return root(squared_volume(points, {rows[i], rows[j]}));
  };
  double total = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      total += length(i, j);
      result.size = std::max(result.size, length(i, j));
      if (rows.size() != 4) continue;
      const std::size_t k = i == 0 ? (j == 1 ? 2 : 1) : 0;
      const std::size_t l = 6 - i - j - k;
      result.length += length(i, j) * (M_PI - dihedral(points, rows[i], rows[j], rows[k], rows[l]));
    }
  }
  if (rows.size() == 2) result.length = 2 * M_PI * total;
  if (rows.size() == 3) result.length = -M_PI * total;
  return result;
}

bool agree(double actual, double expected, double tolerance) {
  if (std::isnan(actual)) return false;
  return actual == expected || std::isinf(tolerance) || std::isnan(tolerance) ||
         std::abs(actual - expected) <= tolerance;
}

template <int D>
class Definitions {
 public:
  explicit Definitions(const WeightedPoints& points)
      : exact_(oracles::exact_points(points)), brute_(oracles::brute_force(points)) {
    for (const BruteSimplex& simplex : brute_.simplices) {
      measured_.push_back(simplex.rows.size() == 1 ? Measured{} : measured(exact_, simplex.rows));
    }
  }

  [[nodiscard]] const BruteForce& brute() const { return brute_; }

  // `has_angles`: whether rounded coordinates leave dihedral angles well defined.
  void expect(const Signature<D>& s, bool has_angles) const {
    ByDimension<D> exterior{}, singular{}, regular{}, interior{};
    std::int64_t euler = 0;
    double volume = 0, area_singular = 0, area_regular = 0, length = 0;
    double volume_scale = 0, area_scale = 0, length_scale = 0;
    for (std::size_t i = 0; i < brute_.simplices.size(); ++i) {
      const BruteSimplex& simplex = brute_.simplices[i];
      const auto k = static_cast<std::size_t>(simplex.dimension());
      const Role at = role(simplex, s.index);
      ++(at == Role::exterior   ? exterior
         : at == Role::singular ? singular
         : at == Role::regular  ? regular
                                : interior)[k];
      if (at == Role::exterior) continue;
      euler += k % 2 == 0 ? 1 : -1;
      const Measured& m = measured_[i];
      if (k == D) volume += m.volume;
      if (k == D - 1 && at == Role::singular) area_singular += m.volume;
      if (k == D - 1 && at == Role::regular) area_regular += m.volume;
      length += m.length;
      volume_scale += std::pow(m.size, D);
      area_scale += std::pow(m.size, D - 1);
      length_scale += m.size;
    }
    EXPECT_EQ(s.exterior, exterior);
    EXPECT_EQ(s.singular, singular);
    EXPECT_EQ(s.regular, regular);
    EXPECT_EQ(s.interior, interior);
    EXPECT_EQ(s.euler, euler);
    for (std::size_t k = 0; k < D; ++k) EXPECT_EQ(s.betti[k], brute_.betti[s.index][k]) << k;
    constexpr double kTolerance = 0x1p-44;
    EXPECT_PRED3(agree, s.volume, volume, kTolerance * volume_scale);
    EXPECT_PRED3(agree, s.area_singular, area_singular, kTolerance * area_scale);
    EXPECT_PRED3(agree, s.area_regular, area_regular, kTolerance * area_scale);
    EXPECT_PRED3(agree, s.area, area_regular + 2 * area_singular, kTolerance * area_scale);
    if (D == 3 && has_angles) {
      EXPECT_PRED3(agree, s.length, length, 0x1p-38 * length_scale);
    }
    EXPECT_FALSE(std::isnan(s.length));
    EXPECT_TRUE(singular[D - 1] != 0 || s.area_singular == 0.0);
    EXPECT_TRUE(regular[D - 1] != 0 || s.area_regular == 0.0);
  }

  // The value of a notable alpha by looking at all indices.
  [[nodiscard]] std::optional<std::uint32_t> notable(const std::string& name,
                                                     const Filtration<D>& filtration) const {
    const auto last = static_cast<std::uint32_t>(brute_.spectrum.size());
    const auto first_with = [&](const auto& holds) -> std::optional<std::uint32_t> {
      for (std::uint32_t i = 1; i <= last; ++i) {
        if (holds(i)) return i;
      }
      return {};
    };
    const auto first_lasting = [&](const auto& holds) {
      return first_with([&](std::uint32_t i) {
        for (std::uint32_t j = i; j <= last; ++j) {
          if (!holds(j)) return false;
        }
        return true;
      });
    };
    const auto has_all = [&](std::uint32_t i) { return all_in(i); };
    const auto connected = [&](std::uint32_t i) { return all_in(i) && brute_.betti[i][0] == 1; };
    const auto solid = [&](std::uint32_t i) {
      return connected(i) && std::none_of(brute_.simplices.begin(), brute_.simplices.end(),
                                          [&](const BruteSimplex& simplex) {
                                            return role(simplex, i) == Role::singular;
                                          });
    };
    if (name == "all_vertices") return first_with(has_all);
    if (name == "connected") return first_lasting(connected);
    if (name == "solid") return first_with(solid);
    if (name == "solid_from") return first_lasting(solid);
    if (name == "all_vertices_in_cells") {
      return first_with([&](std::uint32_t i) { return regions(i).first; });
    }
    if (name == "one_region") {
      return first_lasting([&](std::uint32_t i) { return regions(i) == std::pair(true, 1); });
    }
    const auto k = static_cast<std::size_t>(name.back() - '0');
    const auto value = [&](std::uint32_t i) {
      return i > last || (k == 0 && !all_in(i)) ? 0 : brute_.betti[i][k];
    };
    const auto alpha = [&](std::uint32_t i) {
      const double alpha2 = filtration.alpha2(i);
      return alpha2 < 0 ? -std::sqrt(-alpha2) : std::sqrt(alpha2);
    };
    std::optional<std::uint32_t> best;
    double extent = -1.0;
    for (std::uint32_t i = 1; i <= last; ++i) {
      if (value(i) == 0 || (i > 1 && value(i - 1) == value(i))) continue;
      std::uint32_t end = i + 1;
      while (end <= last && value(end) == value(i)) ++end;
      if (end > last || !(alpha(end) - alpha(i) > extent)) continue;
      extent = alpha(end) - alpha(i);
      best = i;
    }
    return best;
  }

 private:
  [[nodiscard]] bool all_in(std::uint32_t index) const {
    return std::all_of(brute_.simplices.begin(), brute_.simplices.end(),
                       [&](const BruteSimplex& simplex) {
                         return simplex.dimension() > 0 || simplex.enters <= index;
                       });
  }
  // Whether the cells at an index have all vertices, and how many components they form.
  [[nodiscard]] std::pair<bool, int> regions(std::uint32_t index) const {
    std::map<std::uint32_t, std::uint32_t> number;
    for (const BruteSimplex& simplex : brute_.simplices) {
      if (simplex.dimension() == 0) number.emplace(simplex.rows[0], number.size());
    }
    UnionFind sets(number.size());
    std::vector<bool> is_in(number.size(), false);
    for (const BruteSimplex& simplex : brute_.simplices) {
      if (simplex.dimension() != D || simplex.enters > index) continue;
      for (const std::uint32_t row : simplex.rows) {
        sets.unite(number[simplex.rows[0]], number[row]);
        is_in[number[row]] = true;
      }
    }
    const auto outside = std::count(is_in.begin(), is_in.end(), false);
    return {!is_in.empty() && outside == 0,
            static_cast<int>(sets.set_count()) - static_cast<int>(outside)};
  }

  ExactPoints exact_;
  BruteForce brute_;
  std::vector<Measured> measured_;
};

bool has_clear_angles(generators::PointFamily family) {
  using Family = generators::PointFamily;
  return family != Family::one_ulp && family != Family::huge && family != Family::tiny &&
         family != Family::mixed_scales && family != Family::scan_like;
}

template <int D>
void expect_definitions(const generators::Case& one) {
  const WeightedPoints points = one.points();
  const Definitions<D> definitions(points);
  const Filtration<D> filtration(regular_triangulation<D>(points));
  ASSERT_EQ(filtration.spectrum_size(), definitions.brute().spectrum.size());
  std::uint32_t visited = 0;
  Signature<D> last;
  scan_signatures<D>(filtration, [&](const Signature<D>& s) {
    EXPECT_EQ(s.index, ++visited);
    EXPECT_EQ(s.alpha2, filtration.alpha2(s.index));
    definitions.expect(s, has_clear_angles(one.family));
    last = s;
  });
  EXPECT_EQ(visited, filtration.spectrum_size());
  const HullMeasures hull = hull_measures(filtration);
  EXPECT_PRED3(agree, hull.volume, last.volume, 0x1p-52 * last.volume);
  EXPECT_PRED3(agree, hull.area, last.area, 0x1p-52 * last.area);
  for (const NotableAlpha& alpha : notable_alphas(filtration)) {
    EXPECT_EQ(alpha.index, definitions.notable(alpha.name, filtration)) << alpha.name;
    if (alpha.index) {
      EXPECT_EQ(alpha.alpha2, filtration.alpha2(*alpha.index));
    }
  }
}

TEST(SignatureByDefinition, AgreesOnSmallSetsOfEveryFamily) {
  for (const generators::Case& one : generators::cases(6, 1, 11)) {
    SCOPED_TRACE(testing::Message() << one);
    one.dimension == 2 ? expect_definitions<2>(one) : expect_definitions<3>(one);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace orthoball
