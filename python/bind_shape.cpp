// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "orthoball/output/mesh.h"
#include "orthoball/output/planar_shape.h"
#include "orthoball/output/polygons.h"
#include "orthoball/output/shape_mesh.h"
#include "orthoball/queries/edited_shape.h"
#include "orthoball/queries/regions.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/one_shape.h"
#include "python/written.h"

using orthoball::AlphaComplex;
using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::Role;
using orthoball::SimplexId;
using orthoball::SiteId;

namespace {

OneShape edited(const AlphaShapes& shapes, std::uint32_t index, double alpha2,
                const orthoball::ShapeEdits& edits) {
  const nb::gil_scoped_release released;
  return std::visit(
      [&](const auto& filtration) {
        return OneShape{&shapes, alpha2, orthoball::edited_shape(filtration, index, edits)};
      },
      shapes.filtration());
}

orthoball::ShapeMesh mesh_of(const OneShape& shape) {
  return without_gil(
      shape, [&](const auto& complex) { return orthoball::shape_mesh(complex, shape.points()); });
}

std::vector<std::uint8_t> numbers(const std::vector<Role>& roles) {
  std::vector<std::uint8_t> result;
  for (const Role role : roles) result.push_back(static_cast<std::uint8_t>(role));
  return result;
}

nb::dict boundary(const OneShape& shape) {
  orthoball::ShapeMesh mesh = mesh_of(shape);
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
Array<std::uint32_t> cells(const OneShape& shape) {
  const auto width = static_cast<std::size_t>(shape.shapes->dimension()) + 1;
  auto rows = without_gil(shape, [&]<int D>(const AlphaComplex<D>& complex) {
    const auto& triangulation = complex.filtration().triangulation();
    const auto records = triangulation.template cells<D>();
    const std::uint32_t first = complex.filtration().table().first(D);
    std::vector<SiteId> in_complex;
    for (std::uint32_t cell = 0; cell < records.size(); ++cell) {
      if (!complex.contains(SimplexId(first + cell))) continue;
      for (const std::uint32_t v : records[cell].corners) {
        in_complex.push_back(triangulation.sites().row(v));
      }
    }
    return in_complex;
  });
  const std::size_t size = rows.size() / width;
  return owned<std::uint32_t>(std::move(rows), {size, width});
}

const AlphaComplex<2>& plane(const OneShape& shape) {
  if (const auto* it = std::get_if<orthoball::EditedShape<2>>(&shape.edited)) return it->complex;
  refuse("the points are in space; polygons are for points in the plane");
}

// Of each polygon its rings, of each ring its rows.
nb::list polygons(const OneShape& shape) {
  const AlphaComplex<2>& complex = plane(shape);
  std::vector<orthoball::Polygon> found;
  {
    const nb::gil_scoped_release released;
    found = orthoball::polygons(complex);
  }
  nb::list result;
  for (const orthoball::Polygon& polygon : found) {
    nb::list rings;
    for (const auto& ring : polygon.rings) {
      std::vector<SiteId> rows;
      for (const orthoball::VertexId v : ring) {
        rows.push_back(complex.filtration().triangulation().sites().row(v.row()));
      }
      rings.append(owned<std::uint32_t>(std::move(rows)));
    }
    result.append(rings);
  }
  return result;
}

// A boundary as a file of some format would hold it.
nb::bytes file_bytes(const OneShape& shape, const std::string& format, bool roles) {
  if (format == "geojson" || format == "svg") {
    const AlphaComplex<2>& complex = plane(shape);
    return written("null", [&](orthoball::ByteSink& sink) {
      const orthoball::PlanarShapeOptions options{shape.alpha2, roles};
      if (format == "geojson") write_geojson(sink, complex, shape.points(), options);
      if (format == "svg") write_shape_svg(sink, complex, shape.points(), options);
    });
  }
  const auto mesh_format = orthoball::mesh_format(format);
  if (!mesh_format) {
    refuse("\"" + format + "\" is no format of shapes; they are ply, obj, off, stl, vtu, glb, " +
           "and in the plane geojson and svg");
  }
  const orthoball::ShapeMesh mesh = mesh_of(shape);
  return written("null", [&](orthoball::ByteSink& sink) {
    write_mesh(sink, mesh, {*mesh_format, roles, shape.alpha2});
  });
}

// Volume, area and Betti numbers of the whole.
nb::tuple measures(const OneShape& shape) {
  const auto whole =
      without_gil(shape, [](const auto& complex) { return orthoball::whole_shape(complex); });
  nb::list betti;
  for (int k = 0; k < shape.shapes->dimension(); ++k) {
    betti.append(whole.betti[static_cast<std::size_t>(k)]);
  }
  return nb::make_tuple(whole.volume, whole.area, nb::tuple(betti));
}

// What was done to it.
nb::dict edits(const OneShape& shape) {
  return std::visit(
      [](const auto& edited) {
        nb::dict result;
        result["holes_filled"] = edited.holes_filled;
        result["volume_filled"] = edited.volume_filled;
        result["regions_dropped"] = edited.regions_dropped;
        result["volume_dropped"] = edited.volume_dropped;
        return result;
      },
      shape.edited);
}

}  // namespace

void bind_shape(nb::module_& module) {
  nb::class_<OneShape>(module, "OneShape", "One shape of a family; see orthoball.Shape.")
      .def_prop_ro("edits", &edits, "Numbers and volumes of holes filled and regions left out.");
  module.def(
      "edited",
      [](const AlphaShapes& shapes, std::uint32_t index, double alpha2, bool regularized,
         std::optional<double> hole_threshold, std::optional<double> region_threshold,
         std::uint32_t region) {
        return edited(shapes, index, alpha2,
                      {regularized, hole_threshold, region_threshold, region});
      },
      nb::arg("shapes"), nb::arg("index"), nb::arg("alpha2"), nb::arg("regularized"),
      nb::arg("hole_threshold").none(), nb::arg("region_threshold").none(), nb::arg("region"),
      nb::keep_alive<0, 1>(), "The shape at an index, with holes filled and regions left out.");
  module.def("boundary", &boundary, nb::arg("shape"),
             "The arrays of a boundary, numbered by the vertices that are used.");
  module.def("cells", &cells, nb::arg("shape"),
             "The cells of a shape, (k, D + 1) uint32 rows, positively oriented.");
  module.def(
      "polygons", &polygons, nb::arg("shape"),
      "In the plane: a list of polygons, each a list of rings, each the rows of its vertices.");
  module.def("file_bytes", &file_bytes, nb::arg("shape"), nb::arg("format"), nb::arg("roles"),
             "A shape as the bytes of a file.");
  module.def("measures", &measures, nb::arg("shape"),
             "Volume, area and Betti numbers of a whole shape.");
}
