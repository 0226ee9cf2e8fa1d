// SPDX-License-Identifier: MIT
#include "orthoball/queries/large_star.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "generators/point_families.h"
#include "generators/random.h"
#include "orthoball/queries/part_steps.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

// Sites on a sphere or circle around the origin, which is the last row; with half of it the origin
// is on the hull.
template <int D>
Filtration<D> cone(std::size_t count, bool is_half) {
  const WeightedPoints sphere =
      generators::points_of(generators::PointFamily::near_sphere, D, count, 3);
  std::vector<double> coordinates;
  for (std::uint32_t row = 0; row < count; ++row) {
    if (is_half && sphere.coordinate(row, 0) < 0.0) continue;
    for (int axis = 0; axis < D; ++axis) coordinates.push_back(sphere.coordinate(row, axis));
  }
  coordinates.insert(coordinates.end(), D, 0.0);
  return Filtration<D>(
      regular_triangulation<D>(WeightedPoints(D, coordinates, WeightKind::none, {})));
}

template <int D>
std::uint32_t largest_star(const Filtration<D>& filtration, const StarParts<D>& stars) {
  std::uint32_t largest = 0;
  for (std::uint32_t vertex = 0; vertex < filtration.count(0); ++vertex) {
    if (stars.cells(vertex).size() > stars.cells(largest).size()) largest = vertex;
  }
  return largest;
}

std::vector<bool> random_solid(std::size_t cells, generators::Random& random) {
  std::vector<bool> solid(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) solid[cell] = random.coin();
  return solid;
}

template <int D>
void check_turns(std::size_t count, bool is_half) {
  const Filtration<D> filtration = cone<D>(count, is_half);
  StarParts<D> stars(filtration);
  const std::uint32_t vertex = largest_star(filtration, stars);
  const auto cells = stars.cells(vertex);
  ASSERT_GT(cells.size(), count / 3);
  generators::Random random(5);
  std::vector<bool> solid = random_solid(filtration.count(D), random);
  LargeStar<D> star(filtration, stars, vertex, solid);
  for (int turn = 0; turn < 1500; ++turn) {
    // Some cells near each other, of one side; late ones more often inside.
    const int first = random.integer(0, static_cast<int>(cells.size()) - 1);
    const bool is_inside = random.integer(0, 2999) < turn;
    std::vector<std::uint32_t> turned;
    const int most = turn % 50 == 0 ? 60 : 3;
    std::vector<std::uint32_t> front{cells[static_cast<std::size_t>(first)]};
    while (!front.empty() && static_cast<int>(turned.size()) < most) {
      const std::uint32_t cell = front.back();
      front.pop_back();
      if (solid[cell] != is_inside) continue;
      if (std::find(turned.begin(), turned.end(), cell) != turned.end()) continue;
      turned.push_back(cell);
      for (const std::uint32_t beyond :
           filtration.triangulation().template cells<D>()[cell].neighbours) {
        if (beyond != kOutside) front.push_back(beyond / 4);
      }
    }
    std::sort(turned.begin(), turned.end());
    const std::uint32_t after = star.surplus_after(turned);
    star.turn(turned);
    for (const std::uint32_t cell : turned) solid[cell] = !solid[cell];
    stars.read(vertex, solid);
    ASSERT_EQ(star.surplus(), stars.surplus()) << "turn " << turn;
    ASSERT_EQ(after, stars.surplus()) << "turn " << turn;
  }
}

TEST(LargeStar, HasTheSurplusOfItsPartsAsCellsTurn) {
  for (const bool is_half : {false, true}) {
    check_turns<3>(300, is_half);
    check_turns<2>(300, is_half);
  }
}

// The cost of the cheapest path from a part, by trying all cells until nothing changes.
template <int D>
double cheapest(const StarParts<D>& stars, std::size_t count, std::uint32_t part) {
  const bool side = stars.parts()[part].is_inside;
  const auto part_at = [&](std::size_t place) {
    return place == count ? 0U : stars.part_of()[place];
  };
  std::vector<double> cost(count, std::numeric_limits<double>::infinity());
  double best = std::numeric_limits<double>::infinity();
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (std::size_t place = 0; place < count; ++place) {
      if (stars.parts()[part_at(place)].is_inside == side) continue;
      double before = std::numeric_limits<double>::infinity();
      bool arrives = false;
      stars.for_each_beside(place, [&](std::size_t beside) {
        if (part_at(beside) == part) before = 0.0;
        if (stars.parts()[part_at(beside)].is_inside != side) {
          if (beside < count) before = std::min(before, cost[beside]);
        } else {
          arrives |= part_at(beside) != part;
        }
      });
      const double volume = 1.0 + static_cast<double>(place % 7);
      if (before + volume < cost[place]) {
        cost[place] = before + volume;
        is_new = true;
      }
      if (arrives) best = std::min(best, cost[place]);
    }
  }
  return best;
}

TEST(PartSteps, AreTheCheapestPathsAndWholeParts) {
  for (const bool is_half : {false, true}) {
    const Filtration<3> filtration = cone<3>(120, is_half);
    StarParts<3> stars(filtration);
    const std::uint32_t vertex = largest_star(filtration, stars);
    const auto cells = stars.cells(vertex);
    generators::Random random(2);
    stars.read(vertex, random_solid(filtration.count(3), random));
    const auto volume = [&](std::uint32_t cell) {
      const auto place = std::lower_bound(cells.begin(), cells.end(), cell) - cells.begin();
      return 1.0 + static_cast<double>(place % 7);
    };
    std::vector<double> wanted;
    for (std::uint32_t part = 0; part < stars.parts().size(); ++part) {
      wanted.push_back(cheapest(stars, cells.size(), part));
      if (stars.parts()[part].has_outside) continue;
      double whole = 0.0;
      for (std::size_t place = 0; place < cells.size(); ++place) {
        if (stars.part_of()[place] == part) whole += volume(cells[place]);
      }
      wanted.push_back(whole);
    }
    std::sort(wanted.begin(), wanted.end());
    ASSERT_GT(wanted.size(), 20U);
    std::vector<double> found;
    for (const PartStep& step : part_steps<3>(stars, cells, volume)) {
      found.push_back(step.cost);
      double sum = 0.0;
      for (const std::uint32_t cell : step.cells) sum += volume(cell);
      EXPECT_EQ(sum, step.cost);
    }
    EXPECT_EQ(found, wanted);
  }
}

}  // namespace
}  // namespace orthoball
