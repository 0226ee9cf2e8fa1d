// SPDX-License-Identifier: MIT
//
// The finished cells are put back into the form in which they were built, closed by cells at
// infinity, so that the one conflict test of the construction checks facets inside and on the hull
// alike. The tests are exact, but the arrays are read as if anything could be wrong with them.
#include "orthoball/triangulation/verify.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "orthoball/triangulation/affine_basis.h"
#include "orthoball/triangulation/conflict_test.h"
#include "orthoball/triangulation/point_location.h"

namespace orthoball {
namespace {

constexpr std::size_t kMostFaults = 20;

class Faults {
 public:
  void add(const std::string& fault) {
    if (list_.size() < kMostFaults) list_.push_back(fault);
  }
  [[nodiscard]] bool empty() const { return list_.empty(); }
  [[nodiscard]] std::vector<std::string> list() && { return std::move(list_); }

 private:
  std::vector<std::string> list_;
};

std::string cell_name(std::size_t cell) { return "cell " + std::to_string(cell); }

bool equal_rows(const WeightedPoints& points, std::uint32_t a, std::uint32_t b) {
  const auto axes = static_cast<std::size_t>(points.dimension());
  for (std::size_t axis = 0; axis < axes; ++axis) {
    if (points.coordinates()[axes * a + axis] != points.coordinates()[axes * b + axis]) {
      return false;
    }
  }
  if (points.weight_kind() == WeightKind::none) return true;
  const auto low = points.weights_low();
  return points.weights()[a] == points.weights()[b] && (low.empty() || low[a] == low[b]);
}

template <int D>
void check_rows(const RegularTriangulation<D>& triangulation, const WeightedPoints& points,
                Faults& faults) {
  std::vector<int> uses(points.size(), 0);
  const auto use = [&](SiteId row) {
    if (row.row() < uses.size()) {
      ++uses[row.row()];
    } else {
      faults.add("row " + std::to_string(row.row()) + " does not exist");
    }
  };
  for (const SiteId row : triangulation.sites().rows()) use(row);
  for (const SiteId row : triangulation.hidden()) use(row);
  for (const Duplicate& duplicate : triangulation.duplicates()) {
    use(duplicate.row);
    if (!(duplicate.representative < duplicate.row) || duplicate.row.row() >= points.size() ||
        !equal_rows(points, duplicate.row.row(), duplicate.representative.row())) {
      faults.add("row " + std::to_string(duplicate.row.row()) + " is not a duplicate of " +
                 std::to_string(duplicate.representative.row()));
    }
  }
  for (std::size_t row = 0; row < uses.size(); ++row) {
    if (uses[row] == 1) continue;
    faults.add("row " + std::to_string(row) + " is listed " + std::to_string(uses[row]) +
               " times as vertex, hidden or duplicate");
  }
  if (!std::is_sorted(triangulation.hidden().begin(), triangulation.hidden().end())) {
    faults.add("hidden rows do not ascend");
  }
}

template <int A>
std::array<std::uint32_t, std::size_t{A + 1}> ascending(const CellRecord<A>& record) {
  auto corners = record.corners;
  std::sort(corners.begin(), corners.end());
  return corners;
}

// The numbers in the records: in range, in order, and neighbours mutual with a common facet.
template <int A>
void check_records(std::span<const CellRecord<A>> cells, std::size_t vertices, Faults& faults) {
  if (cells.empty()) faults.add("no cells");
  std::vector<bool> is_used(vertices, false);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const auto corners = ascending<A>(cells[cell]);
    if (corners[A] >= vertices ||
        std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
      faults.add(cell_name(cell) + " has corners that are no vertices or repeat");
      continue;
    }
    for (const std::uint32_t vertex : corners) is_used[vertex] = true;
    if (!std::equal(corners.begin(), corners.end() - 2, cells[cell].corners.begin())) {
      faults.add(cell_name(cell) + " has its corners out of order");
    }
    if (cell > 0 && !(ascending<A>(cells[cell - 1]) < corners)) {
      faults.add(cell_name(cell) + " is out of order");
    }
    for (std::size_t i = 0; i <= A; ++i) {
      const std::uint32_t other = cells[cell].neighbours[i];
      if (other == kOutside) continue;
      if (other / 4 >= cells.size() || other % 4 > A ||
          cells[other / 4].neighbours[other % 4] != 4 * cell + i) {
        faults.add(cell_name(cell) + ": neighbour " + std::to_string(i) + " is not mutual");
        continue;
      }
      auto mine = cells[cell].corners;
      auto theirs = cells[other / 4].corners;
      mine[i] = theirs[other % 4] = kOutside;
      std::sort(mine.begin(), mine.end());
      std::sort(theirs.begin(), theirs.end());
      if (mine != theirs) faults.add(cell_name(cell) + " shares no facet with a neighbour");
    }
  }
  if (std::find(is_used.begin(), is_used.end(), false) != is_used.end()) {
    faults.add("a vertex has no cell");
  }
}

// The records as cells under construction: positively oriented, closed at infinity. Empty where the
// hull is no closed manifold.
template <int A, int D>
CellStore<A> closed_cells(std::span<const CellRecord<A>> records, const Sites<D>& sites,
                          Faults& faults) {
  CellStore<A> cells(sites.size(), 2 * records.size());
  std::vector<bool> is_swapped(records.size(), false);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::uint32_t cell = cells.add(1);
    cells[cell] = records[i];
    const Sign side = orient<A, D>(sites, records[i].corners);
    if (side == Sign::zero || (A == D && side == Sign::negative)) {
      faults.add(cell_name(i) + (side == Sign::zero ? " is flat" : " is negatively oriented"));
    }
    is_swapped[i] = side == Sign::negative;
  }
  const auto swapped_corner = [&](std::uint32_t facet) {
    const std::uint32_t corner = facet % 4;
    return is_swapped[facet / 4] && corner < 2 ? facet / 4 * 4 + (1 - corner) : facet;
  };
  std::map<std::vector<std::uint32_t>, std::uint32_t> open;  // ridges of hull facets met once
  for (std::uint32_t cell = 0; cell < records.size(); ++cell) {
    if (is_swapped[cell]) {
      std::swap(cells[cell].corners[0], cells[cell].corners[1]);
      std::swap(cells[cell].neighbours[0], cells[cell].neighbours[1]);
    }
    for (std::uint32_t i = 0; i <= A; ++i) {
      const std::uint32_t other = cells[cell].neighbours[i];
      if (other != kOutside) {
        cells[cell].neighbours[i] = swapped_corner(other);
        continue;
      }
      const std::uint32_t behind = cells.add(1);
      auto corners = cells[cell].corners;
      corners[i] = cells.infinity();
      const std::uint32_t at = i < 2 ? 1 - i : i;
      std::swap(corners[0], corners[1]);
      cells[behind].corners = corners;
      cells.join(4 * cell + i, 4 * behind + at);
      for (std::uint32_t j = 0; j <= A; ++j) {
        if (j == at) continue;
        std::vector<std::uint32_t> ridge;
        for (std::uint32_t k = 0; k <= A; ++k) {
          if (k != j && k != at) ridge.push_back(corners[k]);
        }
        std::sort(ridge.begin(), ridge.end());
        const auto met = open.find(ridge);
        if (met == open.end()) {
          open.emplace(std::move(ridge), 4 * behind + j);
        } else {
          cells.join(met->second, 4 * behind + j);
          open.erase(met);
        }
      }
    }
  }
  if (!open.empty()) faults.add("the convex hull is not closed");
  return cells;
}

// Whether every cell is reached from the first over facets.
template <int A>
bool is_connected(const CellStore<A>& cells) {
  std::vector<bool> is_reached(cells.size(), false);
  std::vector<std::uint32_t> reached{0};
  is_reached[0] = true;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (const std::uint32_t facet : cells[reached[next]].neighbours) {
      if (is_reached[facet / 4]) continue;
      is_reached[facet / 4] = true;
      reached.push_back(facet / 4);
    }
  }
  return reached.size() == cells.size();
}

template <int A, int D>
void check_geometry(const RegularTriangulation<D>& triangulation, const WeightedPoints& points,
                    Faults& faults) {
  // One array of vertices and hidden sites, on axes where the span is not flat.
  const std::size_t vertices = triangulation.vertex_count();
  std::vector<SiteId> rows(triangulation.sites().rows().begin(),
                           triangulation.sites().rows().end());
  rows.insert(rows.end(), triangulation.hidden().begin(), triangulation.hidden().end());
  const Sites<D> in_place(points, rows);
  std::vector<std::uint32_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  const AffineBasis<D> basis = affine_basis(in_place, order);
  if (basis.affine_dimension() != A) {
    faults.add("the sites span dimension " + std::to_string(basis.affine_dimension()));
    return;
  }
  const Sites<D> sites = A == D ? in_place : in_place.with_axes(basis.axes);

  CellStore<A> cells = closed_cells<A, D>(triangulation.template cells<A>(), sites, faults);
  if (!faults.empty()) return;
  if (!is_connected(cells)) faults.add("the cells are not connected");
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    for (std::size_t i = 0; i <= A; ++i) {
      const std::uint32_t other = cells[cell].neighbours[i];
      const std::uint32_t across = cells[other / 4].corners[other % 4];
      if (across != cells.infinity() && in_conflict<A, D>(cells, sites, cell, across)) {
        faults.add((cells.is_finite(cells[cell]) ? cell_name(cell) : "the hull") +
                   " is in conflict with vertex " + std::to_string(across));
      }
    }
  }
  if (!faults.empty()) return;
  const PointLocation<A, D> location(cells, sites);
  for (auto site = static_cast<std::uint32_t>(vertices); site < sites.size(); ++site) {
    if (in_conflict<A, D>(cells, sites, location.locate(site, 0, Territory<A, D>::whole()).cell,
                          site)) {
      faults.add("row " + std::to_string(sites.row(site).row()) + " is not hidden");
    }
  }
}

}  // namespace

template <int D>
std::vector<std::string> verify(const RegularTriangulation<D>& triangulation,
                                const WeightedPoints& points) {
  Faults faults;
  check_rows(triangulation, points, faults);
  if (!faults.empty()) return std::move(faults).list();
  const auto check = [&]<int A>() {
    check_records<A>(triangulation.template cells<A>(), triangulation.vertex_count(), faults);
    if (faults.empty()) check_geometry<A, D>(triangulation, points, faults);
  };
  switch (triangulation.affine_dimension()) {
    case -1:
      if (points.size() != 0)
        faults.add("no vertex for " + std::to_string(points.size()) + " rows");
      break;
    case 0:
      if (triangulation.vertex_count() != 1) faults.add("more than one vertex at one centre");
      break;
    case 1:
      check.template operator()<1>();
      break;
    case 2:
      check.template operator()<2>();
      break;
    default:
      if constexpr (D == 3) check.template operator()<3>();
      break;
  }
  return std::move(faults).list();
}

template std::vector<std::string> verify<2>(const RegularTriangulation<2>&, const WeightedPoints&);
template std::vector<std::string> verify<3>(const RegularTriangulation<3>&, const WeightedPoints&);

}  // namespace orthoball
