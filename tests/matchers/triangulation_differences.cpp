// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "matchers/agrees_with_brute_force.h"
#include "matchers/describe.h"

namespace orthoball::matchers {

namespace {

template <int D, int A>
std::vector<std::vector<std::uint32_t>> cell_rows(const RegularTriangulation<D>& triangulation) {
  std::vector<std::vector<std::uint32_t>> cells;
  for (const CellRecord<A>& cell : triangulation.template cells<A>()) {
    auto& rows = cells.emplace_back();
    for (const std::uint32_t corner : cell.corners) {
      rows.push_back(triangulation.sites().row(corner).row());
    }
    std::sort(rows.begin(), rows.end());
  }
  return cells;
}

// The cells as ascending rows, sorted.
template <int D>
std::vector<std::vector<std::uint32_t>> all_cells(const RegularTriangulation<D>& triangulation) {
  std::vector<std::vector<std::uint32_t>> cells;
  switch (triangulation.affine_dimension()) {
    case 0:
      for (std::size_t vertex = 0; vertex < triangulation.vertex_count(); ++vertex) {
        cells.push_back({triangulation.sites().row(vertex).row()});
      }
      break;
    case 1:
      cells = cell_rows<D, 1>(triangulation);
      break;
    case 2:
      cells = cell_rows<D, 2>(triangulation);
      break;
    case 3:
      if constexpr (D == 3) cells = cell_rows<D, 3>(triangulation);
      break;
    default:
      break;
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace

template <int D>
std::vector<std::string> differences(const RegularTriangulation<D>& triangulation,
                                     const oracles::BruteForce& expected) {
  std::vector<std::string> found;
  Comparison compare(found);
  compare("affine dimension", triangulation.affine_dimension(), expected.affine_dimension);

  std::vector<std::vector<std::uint32_t>> cells;
  std::vector<std::uint32_t> vertices;
  for (const oracles::BruteSimplex& simplex : expected.simplices) {
    if (simplex.dimension() == expected.affine_dimension) cells.push_back(simplex.rows);
    if (simplex.dimension() == 0) vertices.push_back(simplex.rows[0]);
  }
  std::sort(cells.begin(), cells.end());
  std::sort(vertices.begin(), vertices.end());
  compare("cells", all_cells(triangulation), cells);
  compare("cell count", triangulation.cell_count(), cells.size());

  std::vector<std::uint32_t> rows;
  for (const SiteId row : triangulation.sites().rows()) rows.push_back(row.row());
  std::sort(rows.begin(), rows.end());
  compare("vertices", rows, vertices);
  rows.clear();
  for (const SiteId row : triangulation.hidden()) rows.push_back(row.row());
  compare("hidden rows", rows, expected.hidden);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates;
  for (const Duplicate& duplicate : triangulation.duplicates()) {
    duplicates.emplace_back(duplicate.row.row(), duplicate.representative.row());
  }
  compare("duplicates", duplicates, expected.duplicates);
  return found;
}

template std::vector<std::string> differences(const RegularTriangulation<2>&,
                                              const oracles::BruteForce&);
template std::vector<std::string> differences(const RegularTriangulation<3>&,
                                              const oracles::BruteForce&);

}  // namespace orthoball::matchers
