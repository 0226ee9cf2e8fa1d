// SPDX-License-Identifier: MIT
#include <nanobind/stl/string.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/filtration/alpha_complex.h"
#include "orthoball/output/mesh.h"
#include "orthoball/output/planar_shape.h"
#include "orthoball/output/polygons.h"
#include "orthoball/output/shape_mesh.h"
#include "python/arrays.h"
#include "python/module.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::Role;
using orthoball::SimplexId;
using orthoball::SiteId;

namespace {

orthoball::ShapeMesh mesh_of(const AlphaShapes& shapes, std::uint32_t index, bool regularized) {
  return without_gil(shapes, [&](const auto& filtration) {
    return orthoball::shape_mesh(filtration, shapes.points(), index, regularized);
  });
}

std::vector<std::uint8_t> numbers(const std::vector<Role>& roles) {
  std::vector<std::uint8_t> result;
  for (const Role role : roles) result.push_back(static_cast<std::uint8_t>(role));
  return result;
}

nb::dict boundary(const AlphaShapes& shapes, std::uint32_t index, bool regularized) {
  orthoball::ShapeMesh mesh = mesh_of(shapes, index, regularized);
  const std::size_t vertices = mesh.rows.size(), triangles = mesh.triangles.size(),
                    edges = mesh.edges.size();
  nb::dict result;
  result["coordinates"] = owned<double>(std::move(mesh.coordinates), {vertices, 3});
  result["rows"] = owned<std::uint32_t>(std::move(mesh.rows));
  result["triangles"] = owned<std::uint32_t>(std::move(mesh.triangles), {triangles, 3});
  result["triangle_roles"] = owned<std::uint8_t>(numbers(mesh.triangle_roles));
  result["edges"] = owned<std::uint32_t>(std::move(mesh.edges), {edges, 2});
  result["edge_roles"] = owned<std::uint8_t>(numbers(mesh.edge_roles));
  result["vertices"] = owned<std::uint32_t>(std::move(mesh.isolated));
  return result;
}

// The D-simplices of the complex, positively oriented, as rows.
Array<std::uint32_t> cells(const AlphaShapes& shapes, std::uint32_t index) {
  const auto width = static_cast<std::size_t>(shapes.dimension()) + 1;
  auto rows = without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    const auto& triangulation = filtration.triangulation();
    const auto records = triangulation.template cells<D>();
    const std::uint32_t first = filtration.table().first(D);
    std::vector<SiteId> in_complex;
    for (std::uint32_t cell = 0; cell < records.size(); ++cell) {
      if (filtration.enters(SimplexId(first + cell)) > index) continue;
      for (const std::uint32_t v : records[cell].corners) {
        in_complex.push_back(triangulation.sites().row(v));
      }
    }
    return in_complex;
  });
  const std::size_t size = rows.size() / width;
  return owned<std::uint32_t>(std::move(rows), {size, width});
}

const Filtration<2>& plane(const AlphaShapes& shapes) {
  if (shapes.dimension() == 2) return std::get<Filtration<2>>(shapes.filtration());
  using orthoball::InputError;
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                   "the points are in space; polygons are for points in the plane");
}

// Of each polygon its rings, of each ring its rows.
nb::list polygons(const AlphaShapes& shapes, std::uint32_t index) {
  const Filtration<2>& filtration = plane(shapes);
  std::vector<orthoball::Polygon> found;
  {
    const nb::gil_scoped_release released;
    found = orthoball::polygons(filtration, index);
  }
  nb::list result;
  for (const orthoball::Polygon& polygon : found) {
    nb::list rings;
    for (const auto& ring : polygon.rings) {
      std::vector<SiteId> rows;
      for (const orthoball::VertexId v : ring) {
        rows.push_back(filtration.triangulation().sites().row(v.row()));
      }
      rings.append(owned<std::uint32_t>(std::move(rows)));
    }
    result.append(rings);
  }
  return result;
}

nb::bytes as_bytes(const std::ostringstream& stream) {
  const std::string text = stream.str();
  return nb::bytes(text.data(), text.size());
}

// A boundary as a file of some format would hold it.
nb::bytes file_bytes(const AlphaShapes& shapes, std::uint32_t index, double alpha2,
                     bool regularized, const std::string& format, bool roles) {
  std::ostringstream stream;
  orthoball::ByteSink sink(stream, "null");
  if (format == "geojson" || format == "svg") {
    const Filtration<2>& filtration = plane(shapes);
    const nb::gil_scoped_release released;
    const orthoball::PlanarShapeOptions options{index, alpha2, regularized, roles};
    if (format == "geojson") write_geojson(sink, filtration, shapes.points(), options);
    if (format == "svg") write_shape_svg(sink, filtration, shapes.points(), options);
  } else if (const auto mesh_format = orthoball::mesh_format(format)) {
    write_mesh(sink, mesh_of(shapes, index, regularized), {*mesh_format, roles, alpha2});
  } else {
    using orthoball::InputError;
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "\"" + format +
                         "\" is no format of shapes; they are ply, obj, off, stl, vtu, " +
                         "glb, and in the plane geojson and svg");
  }
  sink.flush();
  return as_bytes(stream);
}

}  // namespace

void bind_shape(nb::module_& module) {
  module.def("boundary", &boundary, nb::arg("shapes"), nb::arg("index"), nb::arg("regularized"),
             "The arrays of the boundary at an index, numbered by the vertices that are used.");
  module.def("cells", &cells, nb::arg("shapes"), nb::arg("index"),
             "The cells of the complex at an index, (k, D + 1) uint32 rows, positively oriented.");
  module.def(
      "polygons", &polygons, nb::arg("shapes"), nb::arg("index"),
      "In the plane: a list of polygons, each a list of rings, each the rows of its vertices.");
  module.def("file_bytes", &file_bytes, nb::arg("shapes"), nb::arg("index"), nb::arg("alpha2"),
             nb::arg("regularized"), nb::arg("format"), nb::arg("roles"),
             "The shape at an index as the bytes of a file.");
}
