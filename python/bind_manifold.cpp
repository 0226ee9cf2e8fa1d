// SPDX-License-Identifier: MIT
#include <nanobind/stl/string.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "orthoball/output/solid_table.h"
#include "orthoball/queries/manifold_solid.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/one_shape.h"
#include "python/written.h"

using orthoball::AlphaComplex;
using orthoball::EditedShape;
using orthoball::ManifoldSolid;
using orthoball::SiteId;

namespace {

// A solid near to a shape that outlives it, and the shape that it is.
struct OneSolid {
  const OneShape* of;
  OneShape shape;
  std::variant<ManifoldSolid<2>, ManifoldSolid<3>> solid;
};

OneSolid manifold_solid(const OneShape& shape) {
  const nb::gil_scoped_release released;
  return std::visit(
      [&]<int D>(const EditedShape<D>& edited) {
        ManifoldSolid<D> solid = orthoball::manifold_solid(edited.complex);
        EditedShape<D> closed = edited;
        closed.complex = complex_of(solid, edited.complex);
        return OneSolid{&shape, {shape.shapes, shape.alpha2, std::move(closed)}, std::move(solid)};
      },
      shape.edited);
}

template <int D>
nb::tuple changes(const ManifoldSolid<D>& solid) {
  nb::list result;
  for (const orthoball::SolidChange<D>& change : solid.changes) {
    nb::dict one;
    one["is_added"] = change.is_added;
    one["cell_count"] = change.cells.size();
    one["volume"] = change.volume;
    one["centre"] = owned<double>(std::vector<double>(change.centre.begin(), change.centre.end()));
    one["rows"] = owned<std::uint32_t>(std::vector<SiteId>(change.rows));
    result.append(one);
  }
  return nb::tuple(result);
}

// Singular simplices of the shape, by dimension.
template <int D>
nb::tuple dropped(const AlphaComplex<D>& complex) {
  nb::list counts;
  for (int k = 0; k < D; ++k) {
    counts.append(complex.simplices(k, orthoball::Role::singular).size());
  }
  return nb::tuple(counts);
}

nb::dict facts(const OneSolid& self) {
  nb::dict result;
  std::visit(
      [&]<int D>(const ManifoldSolid<D>& solid) {
        result["surface_count"] = solid.surface_count;
        result["euler"] = solid.euler;
        result["added"] = solid.added;
        result["removed"] = solid.removed;
        result["changes"] = changes(solid);
        result["offending"] = owned<std::uint32_t>(std::vector<SiteId>(solid.offending));
        result["offending_edges"] = solid.offending_edges;
        result["dropped"] = dropped(std::get<EditedShape<D>>(self.of->edited).complex);
      },
      self.solid);
  return result;
}

nb::bytes file(const OneSolid& self, const std::string& format) {
  return written_table(format, [&](orthoball::ByteSink& sink, orthoball::TableFormat of_table) {
    std::visit(
        [&]<int D>(const ManifoldSolid<D>& solid) {
          const auto& of = std::get<EditedShape<D>>(self.of->edited);
          orthoball::write_solid_changes<D>(sink, of_table, of.complex, solid);
        },
        self.solid);
  });
}

}  // namespace

void bind_manifold(nb::module_& module) {
  nb::class_<OneSolid>(module, "OneSolid", "The solid near to a shape; see orthoball.Solid.")
      .def_prop_ro(
          "shape", [](const OneSolid& self) -> const OneShape& { return self.shape; },
          nb::rv_policy::reference_internal, "The shape that it is.")
      .def_prop_ro("facts", &facts, "What it is, and what was changed.")
      .def("file", &file, nb::arg("format"), "What was changed, as a table, csv or json.");
  module.def("manifold_solid", &manifold_solid, nb::arg("shape"), nb::keep_alive<0, 1>(),
             "The solid nearest to a shape whose boundary is a closed manifold.");
}
