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
#include "orthoball/queries/locate.h"
#include "orthoball/queries/nearest.h"
#include "orthoball/queries/regions.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/one_shape.h"

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

nb::list listed(const OneShape& shape, std::vector<orthoball::Region> regions) {
  const auto dimension = static_cast<std::size_t>(shape.shapes->dimension());
  nb::list result;
  for (orthoball::Region& region : regions) {
    std::vector<SiteId> cells;
    std::visit(
        [&](const auto& filtration) {
          for (const SimplexId cell : region.cells) {
            const auto rows = filtration.rows(cell);
            cells.insert(cells.end(), rows.begin(), rows.end());
          }
        },
        shape.shapes->filtration());
    nb::dict one;
    one["volume"] = region.volume;
    one["area"] = region.area;
    one["rows"] = owned<std::uint32_t>(std::move(region.rows));
    one["cells"] = owned<std::uint32_t>(std::move(cells), {region.cells.size(), dimension + 1});
    nb::list betti;
    for (std::size_t k = 0; k < dimension; ++k) betti.append(region.betti[k]);
    one["betti"] = nb::tuple(betti);
    result.append(one);
  }
  return result;
}

nb::list regions(const OneShape& shape, const std::string& name) {
  const orthoball::JoinedBy by = joined_by(name);
  return listed(shape, without_gil(shape, [&](const auto& complex) {
                  return orthoball::regions(complex, by);
                }));
}

nb::list holes(const OneShape& shape) {
  return listed(shape,
                without_gil(shape, [](const auto& complex) { return orthoball::holes(complex); }));
}

// The rows of some simplices, `width` each, filled up with none.
template <int D>
void add_rows(const Filtration<D>& filtration, SimplexId simplex, std::size_t width,
              std::vector<SiteId>& rows) {
  const std::size_t end = rows.size() + width;
  if (simplex.exists()) {
    for (const SiteId row : filtration.rows(simplex)) rows.push_back(row);
  }
  rows.resize(end);
}

// (n,): the number of the region each point is in, from 1; 0 outside. (n, D + 1): the rows of the
// simplex that it is in. Then of the nearest point of the boundary: where, how far, on what.
nb::tuple locate(const OneShape& shape, const Given<double, 2>& points,
                 std::optional<unsigned> threads) {
  std::vector<std::uint32_t> numbers;
  std::vector<double> coordinates, distances;
  std::vector<SiteId> simplices, nearest;
  without_gil(shape, [&]<int D>(const orthoball::AlphaComplex<D>& complex) {
    const WeightedPoints queries = query_points(*shape.shapes, points);
    for (const auto& one : orthoball::locate(complex, queries, threads_of(threads))) {
      numbers.push_back(one.region);
      add_rows(complex.filtration(), one.simplex, std::size_t{D} + 1, simplices);
      coordinates.insert(coordinates.end(), one.nearest.point.begin(), one.nearest.point.end());
      distances.push_back(one.nearest.distance);
      add_rows(complex.filtration(), one.nearest.simplex, std::size_t{D}, nearest);
    }
  });
  const std::size_t size = numbers.size();
  const auto axes = static_cast<std::size_t>(shape.shapes->dimension());
  return nb::make_tuple(owned<std::uint32_t>(std::move(numbers)),
                        owned<std::uint32_t>(std::move(simplices), {size, axes + 1}),
                        owned<double>(std::move(coordinates), {size, axes}),
                        owned<double>(std::move(distances)),
                        owned<std::uint32_t>(std::move(nearest), {size, axes}));
}

Array<bool> contains(const OneShape& shape, const Given<double, 2>& points,
                     std::optional<unsigned> threads) {
  auto inside = without_gil(shape, [&](const auto& complex) {
    const WeightedPoints queries = query_points(*shape.shapes, points);
    std::vector<std::uint8_t> result;
    for (const SimplexId simplex :
         orthoball::simplices_at(complex.filtration(), queries, threads_of(threads))) {
      result.push_back(simplex.exists() && complex.contains(simplex) ? 1 : 0);
    }
    return result;
  });
  return owned<bool>(std::move(inside));
}

// Points, distances and the rows of the simplices, D each, filled up with none.
nb::tuple nearest(const OneShape& shape, const Given<double, 2>& points,
                  std::optional<unsigned> threads) {
  std::vector<double> coordinates, distances;
  std::vector<SiteId> rows;
  without_gil(shape, [&]<int D>(const orthoball::AlphaComplex<D>& complex) {
    // Refuses what is not finite, naming the row.
    const WeightedPoints checked(static_cast<int>(points.shape(1)),
                                 std::vector<double>(points.data(), points.data() + points.size()),
                                 orthoball::WeightKind::none, {});
    for (const auto& one : orthoball::nearest_on_boundary(complex, checked, threads_of(threads))) {
      coordinates.insert(coordinates.end(), one.point.begin(), one.point.end());
      distances.push_back(one.distance);
      add_rows(complex.filtration(), one.simplex, std::size_t{D}, rows);
    }
  });
  const std::size_t size = distances.size();
  const auto axes = static_cast<std::size_t>(shape.shapes->dimension());
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
  module.def("contains", &contains, nb::arg("shape"), nb::arg("points"), nb::arg("threads").none(),
             "(n,) whether points are in a shape.");
  module.def("locate", &locate, nb::arg("shape"), nb::arg("points"), nb::arg("threads").none(),
             "Regions (n,), simplices (n, D + 1), and as `nearest`.");
  module.def("nearest", &nearest, nb::arg("shape"), nb::arg("points"), nb::arg("threads").none(),
             "The nearest points of the boundary (n, D), their distances (n,), the rows of their\n"
             "simplices (n, D) uint32.");
  module.def("regions", &regions, nb::arg("shape"), nb::arg("joined_by"),
             "The regions of a shape, a dict each.");
  module.def("holes", &holes, nb::arg("shape"), "The holes of a shape, a dict each.");
}
