// SPDX-License-Identifier: MIT
//
// Sites are inserted one by one. Each is located by a walk from the last cell made; if the cell
// found is not in conflict with it, the site is hidden, now and for ever; otherwise the cells in
// conflict are replaced by cells at the site. Between insertions the cells are the regular
// triangulation of the sites so far, with one vertex at infinity.
//
// Bowyer. Computing Dirichlet tessellations. The Computer Journal 24 (1981).
// Edelsbrunner, Shah. Incremental topological flipping works for regular triangulations.
//   Algorithmica 15 (1996). We replace the whole conflict region instead of flipping through it.
// Amenta, Choi, Rote. Incremental constructions con BRIO. SoCG 2003: the order of insertion.
#include "orthoball/triangulation/build.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/exact/orient.h"
#include "orthoball/triangulation/affine_basis.h"
#include "orthoball/triangulation/canonical_cells.h"
#include "orthoball/triangulation/conflict_region.h"
#include "orthoball/triangulation/insertion_order.h"
#include "orthoball/triangulation/point_location.h"

namespace orthoball {
namespace {

// The cell of the first A + 1 sites and the A + 1 cells at infinity around it. Returns the first.
template <int A, int D>
std::uint32_t start_cells(CellStore<A>& cells, const Sites<D>& sites,
                          std::span<const std::uint32_t> basis) {
  Corners<A> corners;
  std::copy(basis.begin(), basis.end(), corners.begin());
  if (orient<A, D>(sites, corners) == Sign::negative) std::swap(corners[0], corners[1]);

  const std::uint32_t first = cells.add(A + 2);
  cells[first].corners = corners;
  std::array<std::uint32_t, std::size_t{A + 1}> behind;  // [i] cell at infinity opposite corner i
  for (std::uint32_t i = 0; i <= A; ++i) {
    behind[i] = first + 1 + i;
    auto& record = cells[behind[i]];
    record.corners = corners;
    record.corners[i] = cells.infinity();
    std::swap(record.corners[0], record.corners[1]);
  }
  const auto corner_of = [&](std::uint32_t cell, std::uint32_t vertex) {
    const auto& all = cells[cell].corners;
    return static_cast<std::uint32_t>(std::find(all.begin(), all.end(), vertex) - all.begin());
  };
  for (std::size_t i = 0; i <= A; ++i) {
    cells.join(4 * first + static_cast<std::uint32_t>(i),
               4 * behind[i] + corner_of(behind[i], cells.infinity()));
    for (std::size_t j = 0; j < i; ++j) {
      cells.join(4 * behind[i] + corner_of(behind[i], corners[j]),
                 4 * behind[j] + corner_of(behind[j], corners[i]));
    }
  }
  return first;
}

// The cells over sites that span A axes, the first A; marks hidden sites.
template <int A, int D>
CellStore<A> inserted_cells(const Sites<D>& sites, std::span<const std::uint32_t> order,
                            std::span<const std::uint32_t> basis, std::vector<bool>& is_hidden) {
  constexpr std::size_t kCellsPerSite = A == 3 ? 7 : 2;  // what uniform points need
  CellStore<A> cells(sites.size(), kCellsPerSite * sites.size() + sites.size() / 4 + 4096);
  std::uint32_t cell = start_cells<A, D>(cells, sites, basis);

  const Territory whole{0, cells.infinity(), cells.infinity()};
  const PointLocation<A, D> location(cells, sites);
  ConflictRegion<A, D> region(cells, sites);
  using Outcome = typename ConflictRegion<A, D>::Outcome;
  std::vector<std::uint32_t> hidden;
  for (const std::uint32_t site : order) {
    if (std::find(basis.begin(), basis.end(), site) != basis.end()) continue;
    cell = location.locate(site, cell, whole).cell;
    if (region.insert(site, cell, whole, true, hidden) == Outcome::inserted) {
      cell = region.new_cell();
    }
  }
  for (const std::uint32_t vertex : hidden) is_hidden[vertex] = true;
  region.supply().close();
  return cells;
}

template <int A, int D>
std::vector<CellRecord<A>> cells_in_span(const Sites<D>& sites, const AffineBasis<D>& basis,
                                         std::span<const std::uint32_t> order,
                                         std::vector<bool>& is_hidden) {
  if constexpr (A == D) {
    return canonical_cells<A>(inserted_cells<A, D>(sites, order, basis.sites, is_hidden), is_hidden,
                              true);
  } else {
    const Sites<D> projected = sites.with_axes(basis.axes);
    return canonical_cells<A>(inserted_cells<A, D>(projected, order, basis.sites, is_hidden),
                              is_hidden, false);
  }
}

}  // namespace

template <int D>
RegularTriangulation<D> regular_triangulation(const WeightedPoints& points) {
  if (points.dimension() != D) {
    throw InputError(InputError::Reason::wrong_size, InputError::kNoRow,
                     "points of dimension " + std::to_string(points.dimension()) +
                         " for a triangulation of dimension " + std::to_string(D));
  }
  typename RegularTriangulation<D>::Parts parts;
  CurveOrder curve = curve_order<D>(points);
  parts.duplicates = std::move(curve.duplicates);
  Sites<D> sites(points, std::move(curve.rows));
  const std::vector<std::uint32_t> order = insertion_order(sites.size());
  const AffineBasis<D> basis = affine_basis(sites, order);

  std::vector<bool> is_hidden(sites.size(), false);
  parts.affine_dimension = basis.affine_dimension();
  switch (parts.affine_dimension) {
    case 0:  // one centre: the heaviest site, which is the last along the curve, hides the others
      std::fill(is_hidden.begin(), is_hidden.end() - 1, true);
      break;
    case 1:
      parts.segments = cells_in_span<1>(sites, basis, order, is_hidden);
      break;
    case 2:
      parts.triangles = cells_in_span<2>(sites, basis, order, is_hidden);
      break;
    case 3:
      if constexpr (D == 3) parts.tetrahedra = cells_in_span<3>(sites, basis, order, is_hidden);
      break;
    default:
      break;
  }

  for (std::uint32_t site = 0; site < sites.size(); ++site) {
    if (is_hidden[site]) parts.hidden.push_back(sites.row(site));
  }
  std::sort(parts.hidden.begin(), parts.hidden.end());
  if (!parts.hidden.empty()) sites.drop(is_hidden);
  parts.sites = std::move(sites);
  return RegularTriangulation<D>(std::move(parts));
}

template RegularTriangulation<2> regular_triangulation<2>(const WeightedPoints&);
template RegularTriangulation<3> regular_triangulation<3>(const WeightedPoints&);

}  // namespace orthoball
