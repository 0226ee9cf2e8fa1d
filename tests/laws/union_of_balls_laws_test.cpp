// SPDX-License-Identifier: MIT
// What holds for the unions of any balls.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "generators/cases.h"
#include "orthoball/measures/ball_overlaps.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/topology/betti.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;
using generators::PointFamily;

const UnionOptions kEverything{.contacts = true, .derivatives = true, .threads = Threads(1)};
const UnionOptions kMeasures{.threads = Threads(1)};

template <int D>
Filtration<D> filtration_of(const WeightedPoints& points) {
  return Filtration<D>(regular_triangulation<D>(points));
}

// Every family but those at the ends of the double range.
template <class Check>
void for_each_case(const Check& check) {
  for (const Case& one : generators::cases(3, 5, 120)) {
    if (generators::is_extreme(one.family)) continue;
    SCOPED_TRACE(::testing::Message() << one);
    if (one.dimension == 2) check.template operator()<2>(one);
    if (one.dimension == 3) check.template operator()<3>(one);
    if (::testing::Test::HasFailure()) return;  // one case tells enough
  }
}

// Families in which nothing happens twice at once, and balls never touch.
constexpr std::array kGeneral{PointFamily::uniform, PointFamily::uniform_balls,
                              PointFamily::gaussian};

// Indices along the spectrum, the last included, and alpha2 halfway to the next entry.
struct At {
  std::uint32_t index;
  double alpha2;
};
template <int D>
std::vector<At> some_of(const Filtration<D>& filtration, std::uint32_t parts) {
  const std::uint32_t last = filtration.spectrum_size();
  std::vector<At> result;
  for (std::uint32_t part = 1; part <= parts; ++part) {
    const auto index = static_cast<std::uint32_t>(std::uint64_t{last} * part / parts);
    if (index == 0) continue;
    const double here = filtration.alpha2(index);
    const double next = index < last ? filtration.alpha2(index + 1) : here + std::abs(here) + 1;
    result.push_back({index, here + (next - here) / 2});
  }
  return result;
}

// A sum, and what its error is measured against.
struct Sum {
  double value = 0.0, magnitude = 0.0;
  void add(double term, double size) {
    value += term;
    magnitude += size;
  }
};

struct Sums {
  Sum volume, area;
  std::vector<Sum> volumes, areas;  // [row]
};

// Over all simplices of the complex, those inside too.
template <int D>
Sums inclusion_and_exclusion(const Filtration<D>& filtration, const WeightedPoints& points,
                             const At& at) {
  Sums sums;
  sums.volumes.resize(points.size());
  sums.areas.resize(points.size());
  for (std::uint32_t i = 0; i < filtration.size(); ++i) {
    const SimplexId simplex(i);
    if (filtration.enters(simplex) > at.index) continue;
    std::vector<Ball<D>> balls;
    double size = 1.0;
    for (const SiteId row : filtration.rows(simplex)) {
      Ball<D>& ball = balls.emplace_back();
      for (int axis = 0; axis < D; ++axis) {
        ball.centre[static_cast<std::size_t>(axis)] = points.coordinate(row.row(), axis);
      }
      ball.radius = std::sqrt(std::max(0.0, points.weight(row.row()) + at.alpha2));
      size = balls.size() == 1 ? ball.radius : std::max(size, ball.radius);
    }
    const BallOverlap<D> overlap = ball_overlap<D>(std::span<const Ball<D>>(balls));
    const double sign = balls.size() % 2 == 1 ? 1.0 : -1.0;
    const double area = std::pow(size, D - 1), volume = area * size;
    sums.volume.add(sign * overlap.volume, volume);
    sums.area.add(sign * overlap.area, area);
    std::size_t ball = 0;
    for (const SiteId row : filtration.rows(simplex)) {
      sums.volumes[row.row()].add(sign * overlap.volumes[ball], volume);
      sums.areas[row.row()].add(sign * overlap.areas[ball], area);
      ++ball;
    }
  }
  return sums;
}

TEST(UnionOfBalls, IsAllOverlapsIncludedAndExcluded) {
  for_each_case([]<int D>(const Case& one) {
    // Centres so close tell nothing about where planes are once a radius is rounded.
    if (one.family == PointFamily::one_ulp) return;
    const WeightedPoints points = one.points();
    const auto filtration = filtration_of<D>(points);
    for (const At& at : some_of(filtration, 6)) {
      SCOPED_TRACE(at.index);
      const UnionOfBalls found = union_of_balls(filtration, at.index, at.alpha2, kMeasures);
      const Sums expected = inclusion_and_exclusion(filtration, points, at);
      const auto expect_near = [](double value, const Sum& sum) {
        ASSERT_NEAR(value, sum.value, 1e-10 * sum.magnitude);
      };
      expect_near(found.volume, expected.volume);
      expect_near(found.area, expected.area);
      for (std::size_t row = 0; row < points.size(); ++row) {
        expect_near(found.volumes[row], expected.volumes[row]);
        expect_near(found.areas[row], expected.areas[row]);
      }
      if (::testing::Test::HasFailure()) return;
    }
  });
}

TEST(UnionOfBalls, IsTheSumOfItsPartsWhichAreFiniteAndNotNegative) {
  for_each_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    for (const At& at : some_of(filtration, 6)) {
      const UnionOfBalls found = union_of_balls(filtration, at.index, at.alpha2, kEverything);
      double volume = 0.0, area = 0.0;
      for (std::size_t row = 0; row < one.count; ++row) {
        ASSERT_GE(found.volumes[row], 0.0);
        ASSERT_GE(found.areas[row], 0.0);
        volume += found.volumes[row];
        area += found.areas[row];
      }
      ASSERT_NEAR(found.volume, volume, 1e-12 * volume);
      ASSERT_NEAR(found.area, area, 1e-12 * area);
      ASSERT_TRUE(std::isfinite(found.volume));
      ASSERT_TRUE(std::isfinite(found.area));
      ASSERT_TRUE(std::isfinite(found.mean_curvature));
      for (const Contact& contact : found.contacts) {
        ASSERT_LT(contact.rows[0], contact.rows[1]);
        ASSERT_GE(contact.area, 0.0);
        ASSERT_GE(contact.exposed_length, 0.0);
        ASSERT_TRUE(std::isfinite(contact.area));
        ASSERT_TRUE(std::isfinite(contact.exposed_length));
      }
      ASSERT_TRUE(std::is_sorted(found.contacts.begin(), found.contacts.end(),
                                 [](const auto& a, const auto& b) { return a.rows < b.rows; }));
      for (const auto* list :
           {&found.derivatives.area_by_radius, &found.derivatives.volume_by_centre,
            &found.derivatives.area_by_centre}) {
        for (const double derivative : *list) ASSERT_TRUE(std::isfinite(derivative));
      }
    }
  });
}

TEST(UnionOfBalls, HasTheEulerNumberOfItsDualComplex) {
  for_each_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    for (const At& at : some_of(filtration, 5)) {
      const auto betti = betti_numbers(filtration, at.index, Threads(1));
      std::int64_t expected = 0;
      for (std::size_t k = 0; k < D; ++k)
        expected += k % 2 == 0 ? betti[k] : -std::int64_t{betti[k]};
      ASSERT_EQ(union_of_balls(filtration, at.index, at.alpha2, kMeasures).euler, expected);
    }
  });
}

TEST(UnionOfBalls, IsNothingAtIndexZero) {
  for_each_case([]<int D>(const Case& one) {
    const auto filtration = filtration_of<D>(one.points());
    const UnionOfBalls none = union_of_balls(filtration, 0, -1e9, kEverything);
    ASSERT_EQ(none.volume, 0.0);
    ASSERT_EQ(none.area, 0.0);
    ASSERT_EQ(none.mean_curvature, 0.0);
    ASSERT_EQ(none.euler, 0);
    ASSERT_EQ(none.volumes, std::vector<double>(one.count, 0.0));
    ASSERT_EQ(none.areas, std::vector<double>(one.count, 0.0));
    ASSERT_TRUE(none.contacts.empty());
    ASSERT_EQ(none.derivatives.volume_by_centre, std::vector<double>(D * one.count, 0.0));
  });
}

bool have_the_same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool have_the_same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

TEST(UnionOfBalls, OfShuffledRowsIsShuffled) {
  for_each_case([]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    const auto order = generators::random_permutation(points.size(), one.seed + 1);
    const auto original = filtration_of<D>(points);
    const auto shuffled = filtration_of<D>(generators::with_rows(points, order));
    for (const At& at : some_of(original, 3)) {
      const UnionOfBalls a = union_of_balls(original, at.index, at.alpha2, kEverything);
      const UnionOfBalls b = union_of_balls(shuffled, at.index, at.alpha2, kEverything);
      ASSERT_TRUE(have_the_same_bits(a.volume, b.volume));
      ASSERT_TRUE(have_the_same_bits(a.area, b.area));
      ASSERT_TRUE(have_the_same_bits(a.mean_curvature, b.mean_curvature));
      ASSERT_EQ(a.euler, b.euler);
      ASSERT_EQ(a.contacts.size(), b.contacts.size());
      // A duplicate's representative may be another of its rows.
      const auto& triangulation = original.triangulation();
      if (triangulation.distinct_site_count() != points.size()) continue;
      for (std::size_t row = 0; row < order.size(); ++row) {
        ASSERT_TRUE(have_the_same_bits(a.volumes[order[row]], b.volumes[row]));
        ASSERT_TRUE(have_the_same_bits(a.areas[order[row]], b.areas[row]));
        ASSERT_TRUE(have_the_same_bits(a.derivatives.area_by_radius[order[row]],
                                       b.derivatives.area_by_radius[row]));
        for (std::size_t axis = 0; axis < D; ++axis) {
          ASSERT_TRUE(have_the_same_bits(a.derivatives.volume_by_centre[D * order[row] + axis],
                                         b.derivatives.volume_by_centre[D * row + axis]));
        }
      }
    }
  });
}

// A turn by integers about the cube's diagonal and a mirror image, then one by (3, 4, 5) and
// another: the last two in doubles.
template <int D>
WeightedPoints turned(const WeightedPoints& points, bool is_exact) {
  std::vector<double> coordinates;
  for (std::size_t row = 0; row < points.size(); ++row) {
    std::array<double, 3> x{};
    for (int axis = 0; axis < D; ++axis) {
      x[static_cast<std::size_t>(axis)] = points.coordinate(row, axis);
    }
    if (is_exact) {
      x = D == 2 ? std::array{-x[1], x[0], 0.0} : std::array{x[1], -x[2], x[0]};
    } else {
      x = {0.6 * x[0] - 0.8 * x[1], 0.8 * x[0] + 0.6 * x[1], x[2]};
      if (D == 3) x = {x[0], (5 * x[1] - 12 * x[2]) / 13, (12 * x[1] + 5 * x[2]) / 13};
    }
    coordinates.insert(coordinates.end(), x.begin(), x.begin() + D);
  }
  return {D, coordinates, points.weight_kind(), {points.weights().begin(), points.weights().end()}};
}

TEST(UnionOfBalls, OfTurnedSitesHasTheSameMeasures) {
  const auto expect = []<int D>(PointFamily family, bool is_exact) {
    SCOPED_TRACE(::testing::Message() << name(family) << ' ' << D << "D " << is_exact);
    const WeightedPoints points = generators::points_of(family, D, 150, 2);
    const auto original = filtration_of<D>(points);
    const auto other = filtration_of<D>(turned<D>(points, is_exact));
    for (const At& at : some_of(original, 5)) {
      const UnionOfBalls a = union_of_balls(original, at.index, at.alpha2, kMeasures);
      const UnionOfBalls b = union_of_balls(other, other.index(at.alpha2), at.alpha2, kMeasures);
      ASSERT_NEAR(a.volume, b.volume, 1e-12 * a.volume);
      ASSERT_NEAR(a.area, b.area, 1e-12 * a.area);
      ASSERT_NEAR(a.mean_curvature, b.mean_curvature, 1e-11 * std::abs(a.mean_curvature));
      ASSERT_EQ(a.euler, b.euler);
    }
  };
  for (const PointFamily family : kGeneral) {
    for (const bool is_exact : {true, false}) {
      expect.template operator()<2>(family, is_exact);
      expect.template operator()<3>(family, is_exact);
    }
  }
  // Of degenerate sites a turned one has other simplices, but the same union.
  for (const PointFamily family :
       {PointFamily::grid, PointFamily::lattice, PointFamily::cospherical}) {
    expect.template operator()<2>(family, true);
    expect.template operator()<3>(family, true);
  }
}

TEST(UnionOfBalls, OfLargerWeightsIsThatAtALargerAlpha2) {
  for_each_case([]<int D>(const Case& one) {
    const WeightedPoints points = one.points();
    if (points.decimals() || points.weight_kind() == WeightKind::radius) return;
    if (one.family == PointFamily::one_ulp) return;  // radii of rounding
    constexpr double kMore = 8.0;
    std::vector<double> weights;
    for (std::size_t row = 0; row < points.size(); ++row) {
      const double weight = points.weight_kind() == WeightKind::none ? 0.0 : points.weights()[row];
      weights.push_back(weight + kMore);
      if (weights.back() - kMore != weight) return;  // rounded
    }
    const auto original = filtration_of<D>(points);
    const auto larger = filtration_of<D>(
        WeightedPoints(D, {points.coordinates().begin(), points.coordinates().end()},
                       WeightKind::weight, weights));
    ASSERT_EQ(original.spectrum_size(), larger.spectrum_size());
    for (const At& at : some_of(original, 4)) {
      const UnionOfBalls a = union_of_balls(original, at.index, at.alpha2, kMeasures);
      const UnionOfBalls b = union_of_balls(larger, at.index, at.alpha2 - kMore, kMeasures);
      // Rounded at 2^-53 of 8; radii at the root of it, where they vanish.
      ASSERT_NEAR(a.volume, b.volume, 1e-11 * a.volume);
      ASSERT_NEAR(a.area, b.area, 1e-11 * a.area);
    }
  });
}

// Of fourth order; no entry of the spectrum is among the five alpha2.
template <class Change>
double slope(const Change& change, double step) {
  return (8 * (change(step) - change(-step)) - (change(2 * step) - change(-2 * step))) /
         (12 * step);
}

TEST(UnionOfBalls, GrowsWithAlpha2ByAreasOverDiameters) {
  const auto expect = []<int D>(PointFamily family) {
    const WeightedPoints points = generators::points_of(family, D, 60, 4);
    const auto filtration = filtration_of<D>(points);
    int compared = 0;
    for (const At& at : some_of(filtration, 40)) {
      const double here = filtration.alpha2(at.index);
      const double step = (at.alpha2 - here) / 8;
      // Away from 0, where radii may be, and wide enough that differences are not all rounding.
      if (step < 1e-5 * std::abs(here) || here <= 0.0) continue;
      const UnionOfBalls found = union_of_balls(filtration, at.index, at.alpha2, kMeasures);
      double expected = 0.0;
      for (std::size_t row = 0; row < points.size(); ++row) {
        const double radius2 = points.weight(row) + at.alpha2;
        if (found.areas[row] > 0.0) expected += found.areas[row] / (2 * std::sqrt(radius2));
      }
      const double growth = slope(
          [&](double more) {
            return union_of_balls(filtration, at.index, at.alpha2 + more, kMeasures).volume;
          },
          step);
      ++compared;
      ASSERT_NEAR(growth, expected, 1e-4 * expected)
          << name(family) << ' ' << D << "D " << at.index << ' ' << step;
    }
    ASSERT_GE(compared, 8) << name(family) << ' ' << D;
  };
  for (const PointFamily family : kGeneral) {
    expect.template operator()<2>(family);
    expect.template operator()<3>(family);
  }
}

TEST(UnionOfBalls, GrowsWithAllRadiiByItsArea) {
  const auto expect = []<int D>() {
    const WeightedPoints points = generators::points_of(PointFamily::uniform_balls, D, 200, 6);
    ASSERT_EQ(points.weight_kind(), WeightKind::radius);
    const auto with_radii = [&](double more) {
      std::vector<double> radii(points.weights().begin(), points.weights().end());
      for (double& radius : radii) radius += more;
      const auto filtration = filtration_of<D>(
          WeightedPoints(D, {points.coordinates().begin(), points.coordinates().end()},
                         WeightKind::radius, radii));
      return union_of_balls(filtration, filtration.index(0.0), 0.0, kMeasures);
    };
    const UnionOfBalls found = with_radii(0.0);
    ASSERT_GT(found.volume, 0.0);
    const double growth = slope([&](double more) { return with_radii(more).volume; }, 1e-6);
    ASSERT_NEAR(growth, found.area, 1e-6 * found.area) << D;
  };
  expect.template operator()<2>();
  expect.template operator()<3>();
}

template <int D>
void expect_the_same_on_all(PointFamily family, std::size_t count) {
  SCOPED_TRACE(::testing::Message() << name(family) << ' ' << D << 'D');
  const auto filtration = filtration_of<D>(generators::points_of(family, D, count, 3));
  for (const At& at : some_of(filtration, 2)) {
    const UnionOfBalls one = union_of_balls(filtration, at.index, at.alpha2, kEverything);
    for (const unsigned threads : {2U, 4U, 16U}) {
      UnionOptions options = kEverything;
      options.threads = Threads(threads);
      const UnionOfBalls many = union_of_balls(filtration, at.index, at.alpha2, options);
      ASSERT_TRUE(have_the_same_bits(one.volume, many.volume));
      ASSERT_TRUE(have_the_same_bits(one.area, many.area));
      ASSERT_TRUE(have_the_same_bits(one.mean_curvature, many.mean_curvature));
      ASSERT_TRUE(have_the_same_bits(one.volumes, many.volumes));
      ASSERT_TRUE(have_the_same_bits(one.areas, many.areas));
      ASSERT_TRUE(
          have_the_same_bits(one.derivatives.area_by_radius, many.derivatives.area_by_radius));
      ASSERT_TRUE(
          have_the_same_bits(one.derivatives.volume_by_centre, many.derivatives.volume_by_centre));
      ASSERT_TRUE(
          have_the_same_bits(one.derivatives.area_by_centre, many.derivatives.area_by_centre));
      ASSERT_EQ(one.contacts.size(), many.contacts.size());
      for (std::size_t i = 0; i < one.contacts.size(); ++i) {
        ASSERT_EQ(one.contacts[i].rows, many.contacts[i].rows);
        ASSERT_TRUE(have_the_same_bits(one.contacts[i].area, many.contacts[i].area));
        ASSERT_TRUE(
            have_the_same_bits(one.contacts[i].exposed_length, many.contacts[i].exposed_length));
      }
    }
  }
}

TEST(UnionOfBalls, HasTheSameBytesOnAnyNumberOfThreads) {
  for (const PointFamily family :
       {PointFamily::uniform, PointFamily::protein_like, PointFamily::hidden_heavy}) {
    expect_the_same_on_all<2>(family, 5000);
    expect_the_same_on_all<3>(family, 5000);
  }
  expect_the_same_on_all<3>(PointFamily::uniform, 12000);  // more edges than are measured at once
}

}  // namespace
}  // namespace orthoball
