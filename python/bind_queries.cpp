// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/decimal.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/queries/containment.h"
#include "orthoball/queries/nearest.h"
#include "orthoball/queries/regions.h"
#include "python/arrays.h"
#include "python/module.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::SimplexId;
using orthoball::SiteId;
using orthoball::WeightedPoints;

namespace {

// Points as the numbers they are, or beside sites that are decimals as the shortest decimals that
// are these doubles, so that 0.1 is the site at one tenth: all of them, where all fit.
WeightedPoints query_points(const AlphaShapes& shapes, const Given<double, 2>& points) {
  using orthoball::WeightKind;
  const auto dimension = static_cast<int>(points.shape(1));
  WeightedPoints doubles(dimension,
                         std::vector<double>(points.data(), points.data() + points.size()),
                         WeightKind::none, {});
  if (!shapes.points().decimals()) return doubles;
  orthoball::DecimalRows rows(dimension, WeightKind::none);
  std::array<orthoball::DecimalNumber, 3> row;
  for (std::size_t i = 0; i < points.size(); i += points.shape(1)) {
    for (std::size_t axis = 0; axis < points.shape(1); ++axis) {
      const std::string text = orthoball::shortest_text(points.data()[i + axis]);
      row[axis] = orthoball::parse_decimal(text).number;
    }
    rows.add(std::span(row).first(points.shape(1)));
    if (!rows.is_fixed()) return doubles;
  }
  return std::move(rows).points();
}

// The index at which each point becomes part of the shape; never outside the hull.
Array<std::uint32_t> enters_at(const AlphaShapes& shapes, const Given<double, 2>& points,
                               std::optional<unsigned> threads) {
  auto indices = without_gil(shapes, [&](const auto& filtration) {
    const WeightedPoints queries = query_points(shapes, points);
    const auto simplices = orthoball::simplices_at(filtration, queries, threads_of(threads));
    std::vector<std::uint32_t> result;
    for (const SimplexId simplex : simplices) {
      result.push_back(simplex.exists() ? filtration.enters(simplex) : filtration.never());
    }
    return result;
  });
  return owned<std::uint32_t>(std::move(indices));
}

orthoball::JoinedBy joined_by(const std::string& name) {
  if (name == "vertices") return orthoball::JoinedBy::vertices;
  if (name == "cells") return orthoball::JoinedBy::cells;
  if (name == "facets") return orthoball::JoinedBy::facets;
  using orthoball::InputError;
  throw InputError(
      InputError::Reason::wrong_argument, InputError::kNoRow,
      "regions are joined by \"" + name + "\"; it must be \"vertices\", \"cells\" or \"facets\"");
}

nb::list regions(const AlphaShapes& shapes, std::uint32_t index, const std::string& name) {
  const orthoball::JoinedBy by = joined_by(name);
  return std::visit(
      [&]<int D>(const Filtration<D>& filtration) {
        auto found = [&] {
          const nb::gil_scoped_release released;
          return orthoball::regions<D>(filtration, index, by);
        }();
        nb::list result;
        for (orthoball::Region& region : found) {
          std::vector<SiteId> cells;
          for (const SimplexId cell : region.cells) {
            const auto rows = filtration.rows(cell);
            cells.insert(cells.end(), rows.begin(), rows.end());
          }
          nb::dict one;
          one["volume"] = region.volume;
          one["area"] = region.area;
          one["rows"] = owned<std::uint32_t>(std::move(region.rows));
          one["cells"] =
              owned<std::uint32_t>(std::move(cells), {region.cells.size(), std::size_t{D} + 1});
          result.append(one);
        }
        return result;
      },
      shapes.filtration());
}

// Points, distances and the rows of the simplices, D each, filled up with none.
nb::tuple nearest(const AlphaShapes& shapes, std::uint32_t index, const Given<double, 2>& points,
                  bool regularized, std::optional<unsigned> threads) {
  std::vector<double> coordinates, distances;
  std::vector<SiteId> rows;
  without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    // Refuses what is not finite, naming the row.
    const WeightedPoints checked(static_cast<int>(points.shape(1)),
                                 std::vector<double>(points.data(), points.data() + points.size()),
                                 orthoball::WeightKind::none, {});
    const auto found = orthoball::nearest_on_boundary<D>(filtration, index, checked, regularized,
                                                         threads_of(threads));
    for (const orthoball::BoundaryPoint<D>& one : found) {
      coordinates.insert(coordinates.end(), one.point.begin(), one.point.end());
      distances.push_back(one.distance);
      std::size_t count = 0;
      if (one.simplex.exists()) {
        for (const SiteId row : filtration.rows(one.simplex)) {
          rows.push_back(row);
          ++count;
        }
      }
      rows.resize(rows.size() + std::size_t{D} - count);
    }
  });
  const std::size_t size = distances.size();
  const auto axes = static_cast<std::size_t>(shapes.dimension());
  return nb::make_tuple(owned<double>(std::move(coordinates), {size, axes}),
                        owned<double>(std::move(distances)),
                        owned<std::uint32_t>(std::move(rows), {size, axes}));
}

}  // namespace

void bind_queries(nb::module_& module) {
  module.def(
      "enters_at", &enters_at, nb::arg("shapes"), nb::arg("points"), nb::arg("threads").none(),
      "The index at which each point becomes part of the shape, (n,) uint32; the spectrum's\n"
      "size plus 1 outside the convex hull.");
  module.def("nearest", &nearest, nb::arg("shapes"), nb::arg("index"), nb::arg("points"),
             nb::arg("regularized"), nb::arg("threads").none(),
             "The nearest points of the boundary (n, D), their distances (n,), the rows of their\n"
             "simplices (n, D) uint32.");
  module.def("regions", &regions, nb::arg("shapes"), nb::arg("index"), nb::arg("joined_by"),
             "The regions of the shape at an index, a dict each.");
}
