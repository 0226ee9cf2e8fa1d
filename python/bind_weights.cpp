// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "orthoball/input/read.h"
#include "orthoball/input/simplex_rows.h"
#include "orthoball/output/points_table.h"
#include "orthoball/points/density_weights.h"
#include "orthoball/weights/added_sites.h"
#include "orthoball/weights/enforced_weights.h"
#include "orthoball/weights/linear_program.h"
#include "orthoball/weights/simplex_presence.h"
#include "python/module.h"
#include "python/points_arrays.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::InputError;
using orthoball::SimplexRows;
using orthoball::SiteId;
using orthoball::WeightedPoints;

namespace {

using MaybeThreads = std::optional<unsigned>;
using RowLists = std::vector<std::vector<std::uint32_t>>;

Array<double> density_weights(const Given<double, 2>& points, std::size_t neighbours,
                              MaybeThreads threads) {
  std::vector<double> weights(points.shape(0));
  {
    const nb::gil_scoped_release released;
    const WeightedPoints plain(static_cast<int>(points.shape(1)),
                               std::vector<double>(points.data(), points.data() + points.size()),
                               orthoball::WeightKind::none, {});
    const WeightedPoints found =
        orthoball::with_density_weights(plain, neighbours, threads_of(threads));
    weights.assign(found.weights().begin(), found.weights().end());
  }
  return owned<double>(std::move(weights));
}

orthoball::Reading with_density_weights(const orthoball::Reading& reading, std::size_t neighbours,
                                        MaybeThreads threads) {
  const nb::gil_scoped_release released;
  orthoball::Reading weighted = reading;
  weighted.points =
      orthoball::with_density_weights(reading.points, neighbours, threads_of(threads));
  weighted.radii =
      fmt::format("density, half the mean square distance to the {} nearest", neighbours);
  weighted.is_molecule = false;
  return weighted;
}

std::vector<SimplexRows> simplices_of(const RowLists& lists) {
  std::vector<SimplexRows> simplices;
  for (const auto& rows : lists) simplices.emplace_back(rows.begin(), rows.end());
  return simplices;
}

// Weights that hold simplices, and the sites that were added for them; or why there are none.
struct Enforced {
  orthoball::EnforcedWeights weights;
  orthoball::AddedSites sites;
};

Enforced enforced_weights(const AlphaShapes& shapes, const RowLists& lists, double alpha2,
                          bool add_sites, MaybeThreads threads) {
  const nb::gil_scoped_release released;
  orthoball::AddedSites sites{shapes.points(), 0, simplices_of(lists), {}};
  for (std::size_t i = 0; i < lists.size(); ++i) sites.part_of.push_back(i);
  auto weights =
      orthoball::enforced_weights(sites.points, sites.simplices, alpha2, threads_of(threads));
  if (weights.conflict.empty() || !add_sites) return {std::move(weights), std::move(sites)};
  sites = orthoball::with_added_sites(shapes.points(), sites.simplices);
  weights = orthoball::enforced_weights(sites.points, sites.simplices, alpha2, threads_of(threads),
                                        sites.added);
  if (!weights.conflict.empty()) {
    throw orthoball::LimitError("the added sites do not yet let weights hold the simplices");
  }
  return {std::move(weights), std::move(sites)};
}

Array<bool> are_present(const AlphaShapes& shapes, const RowLists& lists, std::uint32_t index) {
  const std::vector<SimplexRows> simplices = simplices_of(lists);
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    for (const SiteId row : simplices[i]) {
      if (row.row() < shapes.points().size()) continue;
      throw InputError(InputError::Reason::wrong_argument, i,
                       fmt::format("simplex {}: row {} of {}; rows are counted from 0", i,
                                   row.row(), shapes.points().size()));
    }
  }
  const auto found = without_gil(shapes, [&](const auto& filtration) {
    return orthoball::are_present(filtration, index, std::span<const SimplexRows>(simplices));
  });
  return owned<bool>(std::vector<std::uint8_t>(found.begin(), found.end()));
}

RowLists read_simplices(const std::string& path, const AlphaShapes& shapes) {
  RowLists lists;
  for (const auto& rows :
       orthoball::read_simplices(path, shapes.dimension(), shapes.points().size()).rows) {
    auto& list = lists.emplace_back();
    for (const SiteId row : rows) list.push_back(row.row());
  }
  return lists;
}

}  // namespace

void bind_weights(nb::module_& module) {
  module.def("density_weights", &density_weights, nb::arg("points"), nb::arg("neighbours"),
             nb::arg("threads").none(), "Weights from density of points, (n,) float64.");
  module.def("with_density_weights", &with_density_weights, nb::arg("reading"),
             nb::arg("neighbours"), nb::arg("threads").none(),
             "A reading with weights from density instead of its own.");

  nb::class_<Enforced>(module, "Enforced", "See orthoball.EnforcedWeights.")
      .def_prop_ro(
          "points",
          [](nb::handle self) {
            return coordinate_array(nb::cast<const Enforced&>(self).weights.points, self);
          },
          nb::rv_policy::automatic,
          nb::sig("def points(self) -> numpy.typing.NDArray[numpy.float64]"), "(n, D) float64.")
      .def_prop_ro(
          "weights", [](const Enforced& self) { return weights_of(self.weights.points); },
          nb::sig("def weights(self) -> numpy.typing.NDArray[numpy.float64] | None"),
          "(n,) float64; None where none was needed.")
      .def_prop_ro(
          "changed",
          [](const Enforced& self) {
            return owned<std::uint32_t>(std::vector<SiteId>(self.weights.changed));
          },
          nb::rv_policy::automatic,
          nb::sig("def changed(self) -> numpy.typing.NDArray[numpy.uint32]"), "(k,) rows.")
      .def_prop_ro(
          "hidden",
          [](const Enforced& self) {
            return owned<std::uint32_t>(std::vector<SiteId>(self.weights.hidden));
          },
          nb::rv_policy::automatic,
          nb::sig("def hidden(self) -> numpy.typing.NDArray[numpy.uint32]"), "(k,) rows.")
      .def_prop_ro(
          "total_change", [](const Enforced& self) { return self.weights.total_change; },
          "length^2.")
      .def_prop_ro(
          "conflict", [](const Enforced& self) { return self.weights.conflict; },
          "Numbers of simplices that exclude each other.")
      .def_prop_ro(
          "added", [](const Enforced& self) { return self.sites.added; },
          "How many rows were added.")
      .def_prop_ro(
          "parts",
          [](const Enforced& self) {
            RowLists lists;
            for (const SimplexRows& rows : self.sites.simplices) {
              auto& list = lists.emplace_back();
              for (const SiteId row : rows) list.push_back(row.row());
            }
            return lists;
          },
          "The simplices that are held, as rows.")
      .def_prop_ro(
          "part_of", [](const Enforced& self) { return self.sites.part_of; },
          "Of each the number of the simplex that it is a part of.")
      .def(
          "shapes",
          [](const Enforced& self, MaybeThreads threads) {
            const nb::gil_scoped_release released;
            return AlphaShapes(self.weights.points, {.threads = threads_of(threads)});
          },
          nb::arg("threads").none(), "The shapes of the points.")
      .def(
          "file",
          [](const Enforced& self) {
            return written("", [&](orthoball::ByteSink& sink) {
              write_points_csv(sink, self.weights.points);
            });
          },
          "The points as CSV.");
  module.def("enforced_weights", &enforced_weights, nb::arg("shapes"), nb::arg("simplices"),
             nb::arg("alpha2"), nb::arg("add_sites"), nb::arg("threads").none(),
             "Weights with which simplices are in the shape.");
  module.def("are_present", &are_present, nb::arg("shapes"), nb::arg("simplices"), nb::arg("index"),
             nb::sig("def are_present(shapes: AlphaShapes, simplices: Sequence["
                     "Sequence[int]], index: int) -> "
                     "numpy.typing.NDArray[numpy.bool_]"),
             "Whether simplices are in a complex.");
  module.def("read_simplices", &read_simplices, nb::arg("path"), nb::arg("shapes"),
             "Rows of the simplices that a file lists.");
  module.def("has_linear_solver", &orthoball::has_linear_solver,
             "Whether the solver of linear programs, COIN-OR CLP, can be loaded, which\n"
             "`AlphaShapes.enforce` needs: the package loads it where it is installed (Debian's\n"
             "coinor-libclp1), and does not contain it.");
}
