// SPDX-License-Identifier: MIT
#include "orthoball/queries/star_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
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
std::uint32_t largest_star(const Filtration<D>& filtration) {
  std::vector<std::uint32_t> degree(filtration.count(0), 0);
  for (const auto& cell : filtration.triangulation().template cells<D>()) {
    for (const std::uint32_t vertex : cell.corners) ++degree[vertex];
  }
  return static_cast<std::uint32_t>(std::max_element(degree.begin(), degree.end()) -
                                    degree.begin());
}

std::vector<bool> random_solid(std::size_t cells, generators::Random& random) {
  std::vector<bool> solid(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) solid[cell] = random.coin();
  return solid;
}

// Some cells next to each other, of one side.
template <int D>
std::vector<std::uint32_t> patch(const StarParts<D>& stars, std::uint32_t start, std::size_t most) {
  std::vector<std::uint32_t> cells, front{start};
  while (!front.empty() && cells.size() < most) {
    const std::uint32_t cell = front.back();
    front.pop_back();
    if (stars.is_inside(cell) != stars.is_inside(start)) continue;
    if (std::find(cells.begin(), cells.end(), cell) != cells.end()) continue;
    cells.push_back(cell);
    for (const std::uint32_t beyond : stars.records()[cell].neighbours) {
      if (beyond != kOutside) front.push_back(beyond / 4);
    }
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

template <int D>
void expect_same(const StarParts<D>& stars, const StarParts<D>& anew, std::uint32_t vertex) {
  ASSERT_EQ(stars.surplus(vertex), anew.surplus(vertex)) << vertex;
  std::map<std::uint32_t, std::uint32_t> name;  // of a part, among those found anew
  for (const std::uint32_t cell : stars.cells(vertex)) {
    const std::uint32_t part = stars.part(vertex, cell);
    const auto [found, is_new] = name.emplace(part, anew.part(vertex, cell));
    ASSERT_EQ(found->second, anew.part(vertex, cell)) << vertex;
    ASSERT_EQ(part == 0 && stars.has_outside(vertex),
              found->second == 0 && anew.has_outside(vertex));
  }
  ASSERT_EQ(stars.part_count(vertex, true), anew.part_count(vertex, true));
  ASSERT_EQ(stars.part_count(vertex, false), anew.part_count(vertex, false));
}

template <int D>
void check_turns(const Filtration<D>& filtration) {
  generators::Random random(5);
  StarParts<D> stars(filtration, random_solid(filtration.count(D), random));
  const auto cells = stars.cells(largest_star(filtration));
  for (int turn = 0; turn < 600; ++turn) {
    const bool is_inside = random.integer(0, 1199) < turn;  // late ones more often
    const int first = random.integer(0, static_cast<int>(cells.size()) - 1);
    const std::uint32_t start = cells[static_cast<std::size_t>(first)];
    if (stars.is_inside(start) != is_inside) continue;
    const auto turned = patch(stars, start, turn % 50 == 0 ? 60 : 3);
    const std::int64_t gain = stars.gain(turned, -1000), most = stars.most_gain(turned);
    std::vector<bool> solid = stars.solid();
    for (const std::uint32_t cell : turned) solid[cell] = !solid[cell];
    const StarParts<D> anew(filtration, solid);
    std::int64_t gained = 0;
    for (std::uint32_t vertex = 0; vertex < filtration.count(0); ++vertex) {
      gained += stars.surplus(vertex);
      gained -= anew.surplus(vertex);
    }
    ASSERT_EQ(gain, gained) << "turn " << turn;
    ASSERT_GE(most, gained) << "turn " << turn;
    ASSERT_TRUE(gained > 0 || stars.gain(turned, 1) <= 0);
    stars.turn(turned);
    ASSERT_EQ(stars.solid(), solid);
    ASSERT_EQ(stars.offending_count(), anew.offending_count());
    for (std::uint32_t vertex = 0; vertex < filtration.count(0); ++vertex) {
      expect_same(stars, anew, vertex);
      if (::testing::Test::HasFatalFailure()) FAIL() << "turn " << turn;
    }
  }
}

TEST(StarParts, AreThoseFoundAnewAsCellsTurn) {
  for (const bool is_half : {false, true}) {
    check_turns(cone<3>(100, is_half));
    check_turns(cone<2>(100, is_half));
  }
  check_turns(Filtration<3>(
      regular_triangulation<3>(generators::points_of(generators::PointFamily::uniform, 3, 60, 1))));
}

// A ring of many cells around a vertex is cut next to where it was cut before: what is flooded is
// the short end, not the ring.
TEST(StarParts, FloodOnlyTheSmallerPieces) {
  const Filtration<2> filtration = cone<2>(4000, false);
  const std::uint32_t vertex = largest_star(filtration);
  StarParts<2> stars(filtration, std::vector<bool>(filtration.count(2), true));
  std::vector<std::uint32_t> ring{stars.cells(vertex)[0]};
  while (ring.size() < stars.cells(vertex).size()) {
    std::uint32_t next = kOutside;
    for_each_beside(stars.records(), vertex, ring.back(), [&](std::uint32_t beside) {
      if (ring.size() == 1 || beside != ring[ring.size() - 2]) next = beside;
    });
    ring.push_back(next);
  }
  const std::uint64_t before = stars.work();
  for (std::size_t place = 0; place < ring.size(); place += 2) {
    stars.turn(std::array{ring[place]});
  }
  EXPECT_EQ(stars.surplus(vertex), ring.size() - 2);
  EXPECT_LT(stars.work() - before, 10 * ring.size());
}

// The cost of the cheapest path from a part, by trying all cells until nothing changes.
double cheapest(const StarParts<3>& stars, std::uint32_t vertex, std::uint32_t part, bool side,
                const std::vector<double>& volumes) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  std::vector<double> cost(volumes.size(), kNever);
  double best = kNever;
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const std::uint32_t cell : stars.cells(vertex)) {
      if (stars.is_inside(cell) == side) continue;
      double before = kNever;
      bool arrives = false;
      for_each_beside(stars.records(), vertex, cell, [&](std::uint32_t beside) {
        if (stars.is_inside(beside) == side) {
          if (stars.part(vertex, beside) == part) before = 0.0;
          arrives |= stars.part(vertex, beside) != part;
        } else if (beside != kOutside) {
          before = std::min(before, cost[beside]);
        }
      });
      if (before + volumes[cell] < cost[cell]) {
        cost[cell] = before + volumes[cell];
        is_new = true;
      }
      if (arrives) best = std::min(best, cost[cell]);
    }
  }
  return best;
}

TEST(PartSteps, AreTheCheapestPathsAndWholeParts) {
  for (const bool is_half : {false, true}) {
    const Filtration<3> filtration = cone<3>(120, is_half);
    const std::uint32_t vertex = largest_star(filtration);
    generators::Random random(2);
    const StarParts<3> stars(filtration, random_solid(filtration.count(3), random));
    std::vector<double> volumes;
    for (std::size_t cell = 0; cell < filtration.count(3); ++cell) {
      volumes.push_back(1.0 + static_cast<double>(cell % 7));
    }
    std::map<std::pair<std::uint32_t, bool>, std::vector<double>> parts;  // volumes of their cells
    if (stars.has_outside(vertex)) parts[{0, false}];
    for (const std::uint32_t cell : stars.cells(vertex)) {
      parts[{stars.part(vertex, cell), stars.is_inside(cell)}].push_back(volumes[cell]);
    }
    std::vector<double> wanted;
    double many = std::numeric_limits<double>::infinity();  // the cheapest of more than 32 cells
    for (const auto& [part, of_cells] : parts) {
      wanted.push_back(cheapest(stars, vertex, part.first, part.second, volumes));
      if (part.first == 0 && stars.has_outside(vertex)) continue;
      const double whole = std::accumulate(of_cells.begin(), of_cells.end(), 0.0);
      of_cells.size() > 32 ? void(many = std::min(many, whole)) : wanted.push_back(whole);
    }
    for (const bool of_any_size : {false, true}) {
      if (of_any_size && many < std::numeric_limits<double>::infinity()) wanted.push_back(many);
      std::sort(wanted.begin(), wanted.end());
      ASSERT_GT(wanted.size(), 20U);
      const std::vector<bool> is_fixed(volumes.size(), false);
      std::vector<double> found;
      for (const PartStep& step : PartSteps<3>(stars, volumes, is_fixed).at(vertex, of_any_size)) {
        found.push_back(step.cost);
        double sum = 0.0;
        for (const std::uint32_t cell : step.cells) sum += volumes[cell];
        EXPECT_EQ(sum, step.cost);
      }
      EXPECT_EQ(found, wanted);
    }
  }
}

TEST(PartSteps, HaveNoFixedCells) {
  const Filtration<3> filtration = cone<3>(120, false);
  const std::uint32_t vertex = largest_star(filtration);
  generators::Random random(2);
  const StarParts<3> stars(filtration, random_solid(filtration.count(3), random));
  const std::vector<double> volumes(filtration.count(3), 1.0);
  const std::vector<bool> is_fixed = random_solid(filtration.count(3), random);
  PartSteps<3> steps(stars, volumes, is_fixed);
  EXPECT_FALSE(steps.at(vertex, true).empty());
  for (const PartStep& step : steps.at(vertex, true)) {
    for (const std::uint32_t cell : step.cells) EXPECT_FALSE(is_fixed[cell]);
  }
}

}  // namespace
}  // namespace orthoball
