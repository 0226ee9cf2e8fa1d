// SPDX-License-Identifier: MIT
// A filtration of some values of alpha2 tells of these what that of all values does.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "generators/cases.h"
#include "orthoball/error.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/queries/voids.h"
#include "orthoball/topology/betti.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;
using generators::PointFamily;
using generators::points_of;

const UnionOptions kEverything{.contacts = true, .derivatives = true, .threads = Threads(1)};

template <class Check>
void for_each_case(const Check& check) {
  for (const Case& one : generators::cases(1, 4, 100)) {
    SCOPED_TRACE(::testing::Message() << one);
    if (one.dimension == 2) check.template operator()<2>(one);
    if (one.dimension == 3) check.template operator()<3>(one);
    if (::testing::Test::HasFailure()) return;
  }
}

// `count` values along the spectrum, every second between two entries, one before and one beyond.
std::vector<double> some_values(std::span<const double> spectrum, std::size_t count) {
  std::vector<double> values{-0x1p1000, 0x1p1000};
  for (std::size_t i = 0; i < count && !spectrum.empty(); ++i) {
    const std::size_t entry = i * spectrum.size() / count;
    const double here = spectrum[entry];
    const double next = spectrum[std::min(entry + 1, spectrum.size() - 1)];
    values.push_back(i % 2 == 0 ? here : here / 2 + next / 2);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  while (!std::isfinite(values.back())) values.pop_back();
  return values;
}

TEST(CoarseFiltration, TellsTheRolesAtItsValues) {
  for_each_case([]<int D>(const Case& one) {
    const Filtration<D> all(regular_triangulation<D>(one.points()));
    for (const std::size_t count : {0U, 1U, 5U, 40U}) {
      const std::vector<double> values = some_values(all.spectrum(), count);
      const Filtration<D> coarse(regular_triangulation<D>(one.points()), values, Threads(3));
      ASSERT_TRUE(coarse.is_coarse());
      ASSERT_EQ(coarse.spectrum_size(), values.size() + 1);
      ASSERT_EQ(coarse.size(), all.size());
      for (std::uint32_t index = 1; index <= coarse.spectrum_size(); ++index) {
        const double alpha2 = coarse.alpha2(index);
        ASSERT_EQ(coarse.index(alpha2), index);
        const std::uint32_t there = all.index(alpha2);
        for (std::uint32_t i = 0; i < all.size(); ++i) {
          const SimplexId simplex(i);
          ASSERT_EQ(coarse.role(simplex, index), all.role(simplex, there))
              << "alpha2 " << alpha2 << ", simplex " << i;
        }
      }
    }
  });
}

TEST(CoarseFiltration, MeasuresTheSameUnions) {
  for_each_case([]<int D>(const Case& one) {
    const Filtration<D> all(regular_triangulation<D>(one.points()));
    const std::vector<double> values = some_values(all.spectrum(), 6);
    const Filtration<D> coarse(regular_triangulation<D>(one.points()), values);
    for (std::uint32_t index = 1; index < coarse.spectrum_size(); ++index) {
      const double alpha2 = coarse.alpha2(index);
      const UnionOfBalls found = union_of_balls(coarse, index, alpha2, kEverything);
      const UnionOfBalls expected = union_of_balls(all, all.index(alpha2), alpha2, kEverything);
      const auto is_same = [](double a, double b) { return a == b || (a != a && b != b); };
      ASSERT_PRED2(is_same, found.volume, expected.volume);
      ASSERT_PRED2(is_same, found.area, expected.area);
      ASSERT_PRED2(is_same, found.mean_curvature, expected.mean_curvature);
      ASSERT_EQ(found.euler, expected.euler);
      ASSERT_TRUE(std::equal(found.areas.begin(), found.areas.end(), expected.areas.begin(),
                             expected.areas.end(), is_same));
      ASSERT_EQ(found.contacts.size(), expected.contacts.size());
      ASSERT_EQ(betti_numbers<D>(coarse, index, Threads(1)),
                betti_numbers<D>(all, all.index(alpha2), Threads(1)));
    }
  });
}

template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CoarseFiltration, RefusesValuesThatDoNotAscend) {
  const auto make = [](std::vector<double> values) {
    return message_of([&] {
      (void)Filtration<2>(regular_triangulation<2>(points_of(PointFamily::grid, 2, 9, 0)), values);
    });
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(make({0.0, 1.0, 2.0}), "");
  EXPECT_NE(make({0.0, 1.0, 1.0}), "");
  EXPECT_NE(make({1.0, 0.0}), "");
  EXPECT_NE(make({0.0, kInfinity}), "");
  EXPECT_NE(make({std::nan("")}), "");
}

TEST(CoarseFiltration, RefusesWhatItDoesNotKnow) {
  const Filtration<3> coarse(
      regular_triangulation<3>(points_of(PointFamily::uniform_balls, 3, 50, 1)),
      std::array{0.0, 1.0});
  EXPECT_EQ(message_of([&] { (void)union_of_balls(coarse, 2, 1.0, kEverything); }), "");
  EXPECT_NE(message_of([&] { (void)union_of_balls(coarse, 1, 0.5, kEverything); }), "");
  EXPECT_NE(message_of([&] { (void)union_of_balls(coarse, 0, -1.0, kEverything); }), "");
  EXPECT_NE(message_of([&] { (void)voids(coarse, 1, 0.0, VoidsOf::balls, Threads(1)); }), "");
}

}  // namespace
}  // namespace orthoball
