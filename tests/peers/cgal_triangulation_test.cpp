// SPDX-License-Identifier: MIT
// Our cells and hidden sites beside those of CGAL. Where sites are degenerate CGAL decides ties by
// another rule, so cells are compared in general position only; a site whose power cell is not
// empty but flat may then be hidden there and not here, never the other way round.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <type_traits>

#include "orthoball/triangulation/build.h"
#include "peers/cgal_sites.h"
#include "peers/peer_sites.h"

namespace orthoball::peers {
namespace {

using Row = std::uint32_t;

using DelaunayVertex2 = CGAL::Triangulation_vertex_base_with_info_2<Row, Kernel>;
using Delaunay2 =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<DelaunayVertex2>>;
using RegularVertex2 =
    CGAL::Triangulation_vertex_base_with_info_2<Row, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using Regular2 = CGAL::Regular_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<RegularVertex2,
                                                 CGAL::Regular_triangulation_face_base_2<Kernel>>>;
using DelaunayVertex3 = CGAL::Triangulation_vertex_base_with_info_3<Row, Kernel>;
using Delaunay3 =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<DelaunayVertex3>>;
using RegularVertex3 =
    CGAL::Triangulation_vertex_base_with_info_3<Row, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Regular3 = CGAL::Regular_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<RegularVertex3,
                                                 CGAL::Regular_triangulation_cell_base_3<Kernel>>>;

struct Seen {
  int dimension = -1;
  std::set<Rows> cells;
  std::set<Row> hidden;
};

template <int D, class Triangulation>
Seen seen_by(const WeightedPoints& points) {
  Triangulation triangulation;
  const auto sites = cgal_sites<typename Triangulation::Point>(points);
  triangulation.insert(sites.begin(), sites.end());
  Seen seen{.dimension = triangulation.dimension()};
  const auto add = [&](const auto& cell) {
    Rows rows;
    for (int corner = 0; corner <= D; ++corner) rows.push_back(cell->vertex(corner)->info());
    std::sort(rows.begin(), rows.end());
    seen.cells.insert(rows);
  };
  if (seen.dimension == D) {
    if constexpr (D == 2) {
      for (const auto cell : triangulation.finite_face_handles()) add(cell);
    } else {
      for (const auto cell : triangulation.finite_cell_handles()) add(cell);
    }
  }
  for (const auto& site : sites) seen.hidden.insert(site.second);
  for (const auto vertex : triangulation.finite_vertex_handles()) seen.hidden.erase(vertex->info());
  return seen;
}

template <int D>
Seen seen_by_cgal(const WeightedPoints& points) {
  if constexpr (D == 2) {
    return has_weights(points) ? seen_by<2, Regular2>(points) : seen_by<2, Delaunay2>(points);
  } else {
    return has_weights(points) ? seen_by<3, Regular3>(points) : seen_by<3, Delaunay3>(points);
  }
}

template <int D>
std::set<Row> hidden_rows(const RegularTriangulation<D>& triangulation) {
  std::set<Row> hidden;
  for (const SiteId row : triangulation.hidden()) hidden.insert(row.row());
  return hidden;
}

template <int D>
void expect_same_cells(std::size_t count) {
  for_each_generic_family(D, count, /*seeds=*/3, [](const WeightedPoints& points) {
    const RegularTriangulation<D> ours = regular_triangulation<D>(points);
    const Seen peer = seen_by_cgal<D>(points);
    EXPECT_TRUE(cells_by_rows(ours) == peer.cells);
    EXPECT_EQ(hidden_rows(ours), peer.hidden);
  });
}

TEST(CgalTriangulation, HasTheSameCellsInGeneralPositionInThePlane) { expect_same_cells<2>(1000); }

TEST(CgalTriangulation, HasTheSameCellsInGeneralPositionInSpace) { expect_same_cells<3>(1000); }

template <int D>
std::size_t expect_hidden(std::size_t count, std::uint64_t seeds) {
  std::size_t hidden = 0;
  for_each_family(D, count, seeds, [&](const WeightedPoints& points) {
    const RegularTriangulation<D> ours = regular_triangulation<D>(points);
    const Seen peer = seen_by_cgal<D>(points);
    const std::set<Row> rows = hidden_rows(ours);
    EXPECT_TRUE(std::includes(peer.hidden.begin(), peer.hidden.end(), rows.begin(), rows.end()));
    if (!has_weights(points)) EXPECT_TRUE(peer.hidden.empty());
    if (ours.affine_dimension() == D) EXPECT_EQ(peer.dimension, D);
    hidden += rows.size();
  });
  return hidden;
}

TEST(CgalTriangulation, HidesEverySiteThatIsHiddenHereInThePlane) {
  EXPECT_GT(expect_hidden<2>(300, 6), 1000U);
}

TEST(CgalTriangulation, HidesEverySiteThatIsHiddenHereInSpace) {
  EXPECT_GT(expect_hidden<3>(300, 6), 1000U);
}

}  // namespace
}  // namespace orthoball::peers
