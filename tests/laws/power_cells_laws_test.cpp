// SPDX-License-Identifier: MIT
// What holds for the power cells of any sites.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "generators/cases.h"
#include "generators/random.h"
#include "orthoball/error.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/queries/convex_polytope.h"
#include "orthoball/queries/power_cells.h"
#include "orthoball/queries/power_neighbours.h"
#include "orthoball/triangulation/build.h"

namespace orthoball {
namespace {

using generators::Case;
using generators::PointFamily;

const PowerCellOptions kOneThread{.threads = Threads(1)};

template <int D>
struct Cells {
  explicit Cells(const Case& one)
      : points(one.points()),
        filtration(regular_triangulation<D>(points)),
        box(box_around(filtration, 0.0)),
        cells(power_cells(filtration, box, kOneThread)) {
    box_volume = 1.0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      box_volume *= box.upper[axis] - box.lower[axis];
      longest = std::max(longest, box.upper[axis] - box.lower[axis]);
      furthest = std::max({furthest, std::abs(box.lower[axis]), std::abs(box.upper[axis])});
    }
  }

  WeightedPoints points;
  Filtration<D> filtration;
  Box<D> box;
  std::vector<PowerCell<D>> cells;
  double box_volume = 0.0, longest = 0.0, furthest = 0.0;
};

// Every family, but the last bits of coordinates and weights tell nothing about where planes are
// once they are rounded.
template <class Check>
void for_each_case(const Check& check) {
  for (const Case& one : generators::cases(3, 5, 120)) {
    if (generators::is_extreme(one.family) || one.family == PointFamily::one_ulp) continue;
    SCOPED_TRACE(::testing::Message() << one);
    if (one.dimension == 2) check(Cells<2>(one));
    if (one.dimension == 3) check(Cells<3>(one));
    if (::testing::Test::HasFailure()) return;  // one case tells enough
  }
}

TEST(PowerCells, FillTheBox) {
  for_each_case([]<int D>(const Cells<D>& of) {
    double sum = 0.0;
    for (const PowerCell<D>& cell : of.cells) sum += cell.volume;
    if (!of.cells.empty()) {
      EXPECT_NEAR(sum, of.box_volume, 1e-12 * of.box_volume);
    }
  });
}

TEST(PowerCells, HaveFacetsInCommon) {
  for_each_case([]<int D>(const Cells<D>& of) {
    std::map<std::pair<SiteId, SiteId>, double> areas;
    for (const PowerCell<D>& cell : of.cells) {
      double exposed = 0.0, area = 0.0;
      for (const PowerFacet& facet : cell.facets) {
        // The corners' fan; in the plane a side.
        double its_area = 0.0;
        const auto corner = [&](std::uint32_t i, std::size_t axis) {
          return cell.corners[cell.loops[i]][axis] - cell.corners[cell.loops[facet.begin]][axis];
        };
        if constexpr (D == 2) {
          its_area = std::hypot(corner(facet.begin + 1, 0), corner(facet.begin + 1, 1));
        } else {
          std::array<double, 3> twice{};
          for (std::uint32_t i = facet.begin + 1; i + 1 < facet.end; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
              const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
              twice[axis] += corner(i, u) * corner(i + 1, v) - corner(i, v) * corner(i + 1, u);
            }
          }
          its_area = std::hypot(twice[0], twice[1], twice[2]) / 2;
        }
        area += its_area;
        if (facet.neighbour.exists()) {
          areas[{cell.row, facet.neighbour}] += its_area;
        } else {
          exposed += its_area;
        }
      }
      const double error = 1e-11 * std::pow(of.longest, D - 1);
      EXPECT_NEAR(cell.area, area, error);
      EXPECT_NEAR(cell.exposed_area, exposed, error);
    }
    for (const auto& [pair, area] : areas) {
      const auto other = areas.find({pair.second, pair.first});
      const double area_there = other == areas.end() ? 0.0 : other->second;
      EXPECT_NEAR(area, area_there, 1e-11 * std::pow(of.longest, D - 1));
    }
  });
}

// Half the difference of the powers of x to two sites, as a distance; and how far that may be off.
template <int D>
std::pair<double, double> beyond(const WeightedPoints& points, SiteId one, SiteId other,
                                 const std::array<double, std::size_t{D}>& x, double scale) {
  double power = points.weight(other.row()) - points.weight(one.row()), distance2 = 0.0;
  double magnitude = std::abs(points.weight(other.row())) + std::abs(points.weight(one.row()));
  for (int axis = 0; axis < D; ++axis) {
    const double p = points.coordinate(one.row(), axis), q = points.coordinate(other.row(), axis);
    const double at = x[static_cast<std::size_t>(axis)];
    power += (at - p) * (at - p) - (at - q) * (at - q);
    distance2 += (p - q) * (p - q);
  }
  magnitude += scale * scale;
  const double twice = 2 * std::sqrt(distance2);
  return {power / twice, 1e-14 * magnitude / twice + 1e-13 * scale};
}

TEST(PowerCells, EndAtPlanesOfEqualPower) {
  for_each_case([]<int D>(const Cells<D>& of) {
    const double scale = of.furthest + of.longest;
    for (const PowerCell<D>& cell : of.cells) {
      for (const PowerFacet& facet : cell.facets) {
        for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
          const auto& x = cell.corners[cell.loops[i]];
          if (facet.neighbour.exists()) {
            const auto [off, error] = beyond<D>(of.points, cell.row, facet.neighbour, x, scale);
            EXPECT_LE(std::abs(off), error);
          } else {
            const auto& sides = facet.side % 2 == 0 ? of.box.lower : of.box.upper;
            EXPECT_NEAR(x[facet.side / 2], sides[facet.side / 2], 1e-14 * scale);
          }
        }
      }
    }
  });
}

TEST(PowerCells, HaveNoPointThatIsNearerToOthers) {
  for_each_case([]<int D>(const Cells<D>& of) {
    const double scale = of.furthest + of.longest;
    generators::Random random(1);
    for (const PowerCell<D>& cell : of.cells) {
      if (cell.corners.empty()) continue;
      for (int round = 0; round < 3; ++round) {  // a point between its corners
        std::array<double, std::size_t{D}> x{};
        double sum = 0.0;
        for (const auto& corner : cell.corners) {
          const double share = random.uniform(0.01, 1.0);
          sum += share;
          for (std::size_t axis = 0; axis < D; ++axis) x[axis] += share * corner[axis];
        }
        for (double& one : x) one /= sum;
        for (const PowerCell<D>& other : of.cells) {
          if (other.row == cell.row) continue;
          const auto [off, error] = beyond<D>(of.points, cell.row, other.row, x, scale);
          if (std::isfinite(off)) {
            EXPECT_LE(off, error);
          }
        }
      }
    }
  });
}

// The cell of a vertex as all other sites leave it, of which flat cells bound none.
template <int D>
ConvexPolytope<D> cut_by_all(const Cells<D>& of, std::size_t cell) {
  using Point = typename ConvexPolytope<D>::Point;
  const auto site = [&](std::size_t i) {
    Point x;
    for (std::size_t axis = 0; axis < D; ++axis) {
      x[axis] = of.points.coordinate(of.cells[i].row.row(), static_cast<int>(axis));
    }
    return x;
  };
  const Point here = site(cell);
  Point lower = of.box.lower, upper = of.box.upper;
  for (std::size_t axis = 0; axis < D; ++axis) {
    lower[axis] -= here[axis];
    upper[axis] -= here[axis];
  }
  ConvexPolytope<D> polytope(lower, upper, 1000);
  const double weight = of.points.weight(of.cells[cell].row.row());
  for (std::uint32_t i = 0; i < of.cells.size(); ++i) {
    if (i == cell || of.cells[i].volume == 0.0) continue;
    HalfSpace<D> half{site(i), weight - of.points.weight(of.cells[i].row.row())};
    for (std::size_t axis = 0; axis < D; ++axis) {
      half.normal[axis] -= here[axis];
      half.offset += half.normal[axis] * half.normal[axis];
    }
    half.offset /= 2;
    polytope.cut(half, i);
  }
  polytope.join_corners();
  return polytope;
}

// On integers, where little is rounded.
TEST(PowerCells, HaveTheFacetsThatAllOtherSitesLeave) {
  for (const Case& one : generators::cases(6, 2, 60)) {
    constexpr std::array kIntegers{PointFamily::grid,        PointFamily::lattice,
                                   PointFamily::cospherical, PointFamily::coplanar,
                                   PointFamily::collinear,   PointFamily::duplicated};
    if (std::count(kIntegers.begin(), kIntegers.end(), one.family) == 0) continue;
    SCOPED_TRACE(::testing::Message() << one);
    const auto check = [&]<int D>() {
      const Cells<D> of(one);
      for (std::size_t i = 0; i < of.cells.size(); ++i) {
        const PowerCell<D>& cell = of.cells[i];
        const ConvexPolytope<D> all = cut_by_all(of, i);
        const double least = 1e-9 * std::pow(of.longest, D - 1);
        if (cell.volume == 0.0) {
          EXPECT_TRUE(cell.facets.empty());
          if (!all.is_empty()) {
            EXPECT_LT(all.volume(), least * of.longest);
          }
          continue;
        }
        EXPECT_NEAR(cell.volume, all.volume(), least * of.longest);
        std::set<SiteId> found, expected;
        for (const PowerFacet& facet : cell.facets) found.insert(facet.neighbour);
        for (const auto& facet : all.facets()) {
          if (all.area(facet) < least) continue;
          expected.insert(facet.label < 1000 ? of.cells[facet.label].row : SiteId());
        }
        EXPECT_EQ(found, expected);
      }
    };
    one.dimension == 2 ? check.template operator()<2>() : check.template operator()<3>();
    if (::testing::Test::HasFailure()) return;
  }
}

// Also of sites at the ends of the double range.
TEST(PowerCells, HaveFiniteClosedSurfacesAndSymmetricNeighbours) {
  for (const Case& one : generators::cases(3, 1, 80)) {
    SCOPED_TRACE(::testing::Message() << one);
    const auto check = [&]<int D>() {
      const auto filtration = Filtration<D>(regular_triangulation<D>(one.points()));
      const PowerNeighbours<D> neighbours(filtration, Threads(1));
      for (std::uint32_t v = 0; v < filtration.count(0); ++v) {
        const auto of = neighbours.of(VertexId(v));
        EXPECT_TRUE(std::is_sorted(of.begin(), of.end()));
        EXPECT_EQ(std::adjacent_find(of.begin(), of.end()), of.end());
        for (const VertexId other : of) {
          const auto back = neighbours.of(other);
          EXPECT_TRUE(std::binary_search(back.begin(), back.end(), VertexId(v)));
        }
      }
      Box<D> box;
      try {
        box = box_around(filtration, 0.0);
        (void)power_cells(filtration, box, kOneThread);
      } catch (const InputError&) {
        EXPECT_TRUE(generators::is_extreme(one.family) || filtration.count(0) == 0);
        return;
      }
      for (const PowerCell<D>& cell : power_cells(filtration, box, kOneThread)) {
        EXPECT_GE(cell.volume, 0.0);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (const PowerFacet& facet : cell.facets) {
          for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
            const std::uint32_t next = i + 1 < facet.end ? i + 1 : facet.begin;
            ++sides[{cell.loops[i], cell.loops[next]}];
            for (const double x : cell.corners[cell.loops[i]]) EXPECT_TRUE(std::isfinite(x));
          }
        }
        for (const auto& [side, count] : sides) {
          if (D == 3) {
            EXPECT_EQ(count, (sides[std::pair(side.second, side.first)]));
          }
        }
      }
    };
    one.dimension == 2 ? check.template operator()<2>() : check.template operator()<3>();
    if (::testing::Test::HasFailure()) return;
  }
}

// The numbers of all cells, without their rows.
template <int D>
std::vector<std::array<double, 4>> sorted_numbers(const std::vector<PowerCell<D>>& cells) {
  std::vector<std::array<double, 4>> numbers;
  for (const PowerCell<D>& cell : cells) {
    numbers.push_back({cell.volume, cell.area, cell.exposed_area, double(cell.facet_count)});
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(PowerCells, AreTheSameForAnyOrderOfRowsAndAnyThreads) {
  for_each_case([]<int D>(const Cells<D>& of) {
    const auto order = generators::random_permutation(of.points.size(), 1);
    const Filtration<D> shuffled(regular_triangulation<D>(generators::with_rows(of.points, order)));
    const auto cells = power_cells(shuffled, of.box, {.threads = Threads(3)});
    EXPECT_EQ(sorted_numbers(cells), sorted_numbers(of.cells));
    const UnionOptions with_contacts{.contacts = true, .threads = Threads(1)};
    const auto in_balls = [&](const Filtration<D>& filtration) {
      const std::uint32_t index = filtration.index(0.0);
      return sorted_numbers(power_cells_in_balls(
          filtration, union_of_balls(filtration, index, 0.0, with_contacts), kOneThread));
    };
    EXPECT_EQ(in_balls(shuffled), in_balls(of.filtration));
  });
}

// The surfaces in balls hold the volume of the parts, less what the tolerance takes.
TEST(PowerCellsInBalls, HaveSurfacesNearTheirParts) {
  for (const PointFamily family :
       {PointFamily::uniform_balls, PointFamily::protein_like, PointFamily::grid}) {
    for (const int dimension : {2, 3}) {
      const Case one{family, dimension, 60, 0};
      SCOPED_TRACE(::testing::Message() << one);
      const auto check = [&]<int D>() {
        const auto filtration = Filtration<D>(regular_triangulation<D>(one.points()));
        const double alpha2 = family == PointFamily::grid ? 0.4 : 0.0;
        const std::uint32_t index = filtration.index(alpha2);
        const UnionOfBalls balls =
            union_of_balls(filtration, index, alpha2, {.contacts = true, .threads = Threads(1)});
        const PowerCellOptions options{.tolerance = 1e-3, .threads = Threads(1)};
        const WeightedPoints points = one.points();
        for (const PowerCell<D>& cell : power_cells_in_balls(filtration, balls, options)) {
          const double radius = std::sqrt(std::max(0.0, points.weight(cell.row.row()) + alpha2));
          double inside = 0.0;
          for (const PowerFacet& facet : cell.facets) {
            const auto x = [&](std::uint32_t i, std::size_t axis) {
              return cell.corners[cell.loops[i]][axis] - cell.corners[0][axis];
            };
            if constexpr (D == 2) {
              inside += x(facet.begin, 0) * x(facet.begin + 1, 1) -
                        x(facet.begin, 1) * x(facet.begin + 1, 0);
            } else {
              for (std::uint32_t i = facet.begin + 1; i + 1 < facet.end; ++i) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                  inside += x(facet.begin, axis) * (x(i, u) * x(i + 1, v) - x(i, v) * x(i + 1, u));
                }
              }
            }
          }
          inside /= D == 2 ? 2 : 6;
          EXPECT_LE(inside, cell.volume * (1 + 1e-12) + 1e-14);
          // A shell of the depth of the tolerance over all that is exposed.
          EXPECT_GE(inside, cell.volume - 1.5e-3 * radius * cell.exposed_area - 1e-12);
        }
      };
      dimension == 2 ? check.template operator()<2>() : check.template operator()<3>();
    }
  }
}

}  // namespace
}  // namespace orthoball
