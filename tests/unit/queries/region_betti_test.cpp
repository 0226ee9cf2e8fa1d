// SPDX-License-Identifier: MIT
#include "orthoball/queries/region_betti.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "generators/point_families.h"
#include "orthoball/queries/regions.h"
#include "unit/queries/filtration_of.h"

namespace orthoball {
namespace {

using Betti = std::array<std::uint32_t, 3>;

// By the ranks of boundary matrices over Z/2.
template <int D>
Betti betti_by_ranks(const Filtration<D>& filtration, const std::vector<SimplexId>& simplices) {
  std::array<std::int64_t, 5> count{}, rank{};
  std::map<SimplexId, std::set<SimplexId>> reduced;  // by the last simplex of the column
  for (const SimplexId simplex : simplices) {
    const auto dimension = static_cast<std::size_t>(filtration.dimension(simplex));
    ++count[dimension];
    std::set<SimplexId> column;
    for (const SimplexId facet : filtration.facets(simplex)) column.insert(facet);
    while (!column.empty() && reduced.count(*column.rbegin()) > 0) {
      for (const SimplexId row : reduced[*column.rbegin()]) {
        if (!column.insert(row).second) column.erase(row);
      }
    }
    if (column.empty()) continue;
    ++rank[dimension];
    reduced.emplace(*column.rbegin(), column);
  }
  Betti betti{};
  for (std::size_t k = 0; k < D; ++k) {
    betti[k] = static_cast<std::uint32_t>(count[k] - rank[k] - rank[k + 1]);
  }
  return betti;
}

template <int D>
std::vector<SimplexId> closure(const Filtration<D>& filtration, const Region& region, JoinedBy by) {
  std::set<SimplexId> all(region.cells.begin(), region.cells.end());
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    for (const SimplexId facet : filtration.facets(*it)) all.insert(facet);
  }
  if (by == JoinedBy::vertices) return {};
  return {all.begin(), all.end()};
}

template <int D>
void expect_ranks(const WeightedPoints& points) {
  const auto filtration = filtration_of<D>(points);
  for (const std::uint32_t part : {3U, 5U, 6U, 7U}) {
    const std::uint32_t index = filtration.spectrum_size() * part / 8;
    const AlphaComplex<D> complex(filtration, index);
    for (const JoinedBy by : {JoinedBy::vertices, JoinedBy::cells, JoinedBy::facets}) {
      for (const Region& region : regions(complex, by)) {
        std::vector<SimplexId> simplices = closure(filtration, region, by);
        for (std::uint32_t i = 0; by == JoinedBy::vertices && i < filtration.size(); ++i) {
          const SiteId row = filtration.rows(SimplexId(i))[0];
          if (complex.contains(SimplexId(i)) &&
              std::binary_search(region.rows.begin(), region.rows.end(), row)) {
            simplices.emplace_back(i);
          }
        }
        ASSERT_EQ(region.betti, betti_by_ranks(filtration, simplices)) << index;
      }
    }
  }
}

TEST(RegionBetti, AreWhatRanksOfBoundaryMatricesSay) {
  for (const auto family : generators::point_families()) {
    SCOPED_TRACE(generators::name(family));
    expect_ranks<2>(generators::points_of(family, 2, 40, 1));
    expect_ranks<3>(generators::points_of(family, 3, 30, 2));
  }
}

// Integer points of a cube of size n, with the middles of the cells that are kept: full exactly
// there at alpha2 from 9/16 to 3/4.
template <class IsKept>
WeightedPoints blocks(int n, const IsKept& is_kept) {
  std::set<std::array<int, 3>> corners;
  std::vector<double> coordinates;
  for (int i = 0; i < n * n * n; ++i) {
    const std::array<int, 3> cell{i % n, i / n % n, i / n / n};
    if (!is_kept(cell)) continue;
    for (const int axis : {0, 1, 2})
      coordinates.push_back(cell[static_cast<std::size_t>(axis)] + 0.5);
    for (int k = 0; k < 8; ++k) {
      corners.insert({cell[0] + k % 2, cell[1] + k / 2 % 2, cell[2] + k / 4});
    }
  }
  for (const auto& corner : corners) {
    for (const int x : corner) coordinates.push_back(x);
  }
  return {3, coordinates, WeightKind::none, {}};
}

TEST(RegionBetti, OfAShellARingAndWhatIsInsideAreApart) {
  // A hollow cube of 5 cells a side with a single cell in the middle; the shell is pierced by
  // nothing, the ring beside it by one hole.
  const auto filtration = filtration_of<3>(blocks(20, [](const std::array<int, 3>& c) {
    const auto [x, y, z] = c;
    const bool in_cube = x < 5 && y < 5 && z < 5;
    const bool is_shell = in_cube && (x % 4 == 0 || y % 4 == 0 || z % 4 == 0);
    const bool is_core = x == 2 && y == 2 && z == 2;
    const bool is_ring = x >= 10 && x < 13 && y < 3 && z == 0 && !(x == 11 && y == 1);
    return is_shell || is_core || is_ring;
  }));
  const AlphaComplex<3> complex(filtration, filtration.index(0.6));
  const auto found = regions(complex, JoinedBy::facets);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].volume, 98.0);
  EXPECT_EQ(found[0].betti, (Betti{1, 0, 1}));
  EXPECT_EQ(found[1].volume, 8.0);
  EXPECT_EQ(found[1].betti, (Betti{1, 1, 0}));
  EXPECT_EQ(found[2].volume, 1.0);
  EXPECT_EQ(found[2].betti, (Betti{1, 0, 0}));
}

}  // namespace
}  // namespace orthoball
