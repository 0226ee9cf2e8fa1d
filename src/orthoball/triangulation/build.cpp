// SPDX-License-Identifier: MIT
#include "orthoball/triangulation/build.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/exact/orient.h"
#include "orthoball/large_blocks.h"
#include "orthoball/triangulation/affine_basis.h"
#include "orthoball/triangulation/canonical_cells.h"
#include "orthoball/triangulation/insertion.h"
#include "orthoball/triangulation/insertion_order.h"

namespace orthoball {
namespace {

// The cell of the first A + 1 sites, number 0, and the A + 1 cells at infinity around it.
template <int A, int D>
void start_cells(CellStore<A>& cells, const Sites<D>& sites, std::span<const std::uint32_t> basis) {
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
}

// The cells over sites that span A axes, the first A; marks hidden sites.
template <int A, int D>
CellArray<A> cells_over(const Sites<D>& sites, InsertionOrder order,
                        std::span<const std::uint32_t> basis, std::vector<bool>& is_hidden,
                        Threads threads) {
  constexpr std::size_t kCellsPerSite = A == 3 ? 7 : 2;  // what uniform points need
  CellStore<A> cells(sites.size(), kCellsPerSite * sites.size() + sites.size() / 4 + 4096);
  start_cells<A, D>(cells, sites, basis);
  for (const std::uint32_t site : insert_sites<A, D>(cells, sites, order, basis, threads)) {
    is_hidden[site] = true;
  }
  order = InsertionOrder();
  return canonical_cells<A>(std::move(cells), is_hidden, A == D, threads);
}

template <int A, int D>
CellArray<A> cells_in_span(const Sites<D>& sites, const AffineBasis<D>& basis, InsertionOrder order,
                           std::vector<bool>& is_hidden, Threads threads) {
  if constexpr (A == D)
    return cells_over<A, D>(sites, std::move(order), basis.sites, is_hidden, threads);
  else
    return cells_over<A, D>(sites.with_axes(basis.axes), std::move(order), basis.sites, is_hidden,
                            threads);
}

}  // namespace

template <int D>
RegularTriangulation<D> regular_triangulation(const WeightedPoints& points, Threads threads) {
  if (points.dimension() != D) {
    throw InputError(InputError::Reason::wrong_size, InputError::kNoRow,
                     "points of dimension " + std::to_string(points.dimension()) +
                         " for a triangulation of dimension " + std::to_string(D));
  }
  const LargeBlockReuse reuse;
  typename RegularTriangulation<D>::Parts parts;
  CurveOrder curve = curve_order<D>(points, threads);
  parts.duplicates = std::move(curve.duplicates);
  Sites<D> sites(points, std::move(curve.rows), threads);
  InsertionOrder order = insertion_order(sites.size());
  const AffineBasis<D> basis = affine_basis(sites, order);

  std::vector<bool> is_hidden(sites.size(), false);
  parts.affine_dimension = basis.affine_dimension();
  switch (parts.affine_dimension) {
    case 0:  // one centre: the heaviest site, which is the last along the curve, hides the others
      std::fill(is_hidden.begin(), is_hidden.end() - 1, true);
      break;
    case 1:
      parts.segments = cells_in_span<1>(sites, basis, std::move(order), is_hidden, threads);
      break;
    case 2:
      parts.triangles = cells_in_span<2>(sites, basis, std::move(order), is_hidden, threads);
      break;
    case 3:
      if constexpr (D == 3)
        parts.tetrahedra = cells_in_span<3>(sites, basis, std::move(order), is_hidden, threads);
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

template RegularTriangulation<2> regular_triangulation<2>(const WeightedPoints&, Threads);
template RegularTriangulation<3> regular_triangulation<3>(const WeightedPoints&, Threads);

}  // namespace orthoball
