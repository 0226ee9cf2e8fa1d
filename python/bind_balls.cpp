// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>

#include <span>
#include <variant>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/measures/molecular_surface.h"
#include "orthoball/measures/union_of_balls.h"
#include "python/arrays.h"
#include "python/module.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::UnionOfBalls;

namespace {

UnionOfBalls union_of_balls(const AlphaShapes& shapes, std::uint32_t index, double alpha2,
                            bool contacts, bool derivatives, std::optional<unsigned> threads) {
  return without_gil(shapes, [&]<int D>(const Filtration<D>& filtration) {
    return orthoball::union_of_balls<D>(filtration, index, alpha2,
                                        {contacts, derivatives, threads_of(threads)});
  });
}

nb::tuple contacts(const UnionOfBalls& self) {
  std::vector<orthoball::SiteId> rows;
  std::vector<double> area, exposed_length;
  for (const orthoball::Contact& contact : self.contacts) {
    rows.insert(rows.end(), contact.rows.begin(), contact.rows.end());
    area.push_back(contact.area);
    exposed_length.push_back(contact.exposed_length);
  }
  return nb::make_tuple(owned<std::uint32_t>(std::move(rows), {self.contacts.size(), 2}),
                        owned<double>(std::move(area)), owned<double>(std::move(exposed_length)));
}

nb::tuple derivatives(nb::handle self) {
  const auto& balls = nb::cast<const UnionOfBalls&>(self);
  const orthoball::UnionDerivatives& all = balls.derivatives;
  const std::size_t size = all.area_by_radius.size();
  const std::size_t axes = size == 0 ? 0 : all.volume_by_centre.size() / size;
  return nb::make_tuple(view<double>(std::span(all.area_by_radius), self, {size}),
                        view<double>(std::span(all.volume_by_centre), self, {size, axes}),
                        view<double>(std::span(all.area_by_centre), self, {size, axes}));
}

nb::dict molecular_surface(const AlphaShapes& shapes, const UnionOfBalls& balls, double probe,
                           std::optional<unsigned> threads) {
  using orthoball::InputError;
  if (shapes.dimension() != 3) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "the points are in the plane; a molecular surface is of balls in space");
  }
  orthoball::MolecularSurface surface;
  {
    const nb::gil_scoped_release released;
    surface = orthoball::molecular_surface(std::get<Filtration<3>>(shapes.filtration()), balls,
                                           probe, threads_of(threads));
  }
  nb::dict result;
  result["probe"] = surface.probe;
  result["volume"] = surface.volume;
  result["area"] = surface.area;
  result["convex_area"] = surface.convex_area;
  result["toroidal_area"] = surface.toroidal_area;
  result["concave_area"] = surface.concave_area;
  return result;
}

}  // namespace

void bind_balls(nb::module_& module) {
  const auto part = [](const std::vector<double> UnionOfBalls::*of_all) {
    return [of_all](nb::handle self) {
      const auto& values = nb::cast<const UnionOfBalls&>(self).*of_all;
      return view<double>(std::span(values), self, {values.size()});
    };
  };
  nb::class_<UnionOfBalls>(module, "UnionOfBalls",
                           "The measures of a union of balls; see orthoball.Balls.")
      .def_ro("index", &UnionOfBalls::index, "Of the dual complex.")
      .def_ro("alpha2", &UnionOfBalls::alpha2, "length^2.")
      .def_ro("volume", &UnionOfBalls::volume, "length^D.")
      .def_ro("area", &UnionOfBalls::area, "length^(D-1).")
      .def_ro("mean_curvature", &UnionOfBalls::mean_curvature, "length; 0 in the plane.")
      .def_ro("euler", &UnionOfBalls::euler, "Euler number.")
      .def_prop_ro("volumes", part(&UnionOfBalls::volumes),
                   nb::sig("def volumes(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "(n,) by row.")
      .def_prop_ro("areas", part(&UnionOfBalls::areas),
                   nb::sig("def areas(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "(n,) by row.")
      .def("contacts", &contacts, "rows (k, 2) uint32, area (k,), exposed_length (k,).")
      .def("derivatives", &derivatives,
           "area_by_radius (n,), volume_by_centre (n, D), area_by_centre (n, D).");
  module.def("union_of_balls", &union_of_balls, nb::arg("shapes"), nb::arg("index"),
             nb::arg("alpha2"), nb::arg("contacts"), nb::arg("derivatives"),
             nb::arg("threads").none(),
             "The union of the balls whose dual complex is at an index.");
  module.def("molecular_surface", &molecular_surface, nb::arg("shapes"), nb::arg("balls"),
             nb::arg("probe"), nb::arg("threads").none(),
             "Measures of the molecular surface, by name.");
}
