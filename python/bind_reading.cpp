// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "orthoball/error.h"
#include "orthoball/input/atom_radii.h"
#include "orthoball/input/read.h"
#include "python/module.h"
#include "python/points_arrays.h"

using orthoball::Reading;

namespace {

nb::dict labels(const Reading& reading) {
  nb::dict result;
  const orthoball::SiteLabels& labels = reading.labels;
  if (!labels.line.empty()) {
    result["line"] = owned<std::uint32_t>(std::vector<std::uint32_t>(labels.line));
  }
  const auto add = [&](const char* name, const std::vector<std::string>& of_row) {
    if (!of_row.empty()) result[name] = nb::cast(of_row);
  };
  add("element", labels.element);
  add("atom", labels.atom);
  add("residue", labels.residue);
  add("residue_id", labels.residue_id);
  add("chain", labels.chain);
  return result;
}

Array<double> atom_radii(const std::vector<std::string>& elements,
                         const std::vector<std::string>& residues,
                         const std::vector<std::string>& atoms, const std::string& set) {
  const orthoball::AtomRadii radii(set, true);
  const auto text = [](const std::vector<std::string>& texts, std::size_t row) {
    return row < texts.size() ? texts[row] : std::string();
  };
  std::vector<double> result;
  for (std::size_t row = 0; row < elements.size(); ++row) {
    const auto radius = radii.radius(elements[row], text(residues, row), text(atoms, row));
    if (!radius) {
      using orthoball::InputError;
      throw InputError(InputError::Reason::wrong_argument, row,
                       "row " + std::to_string(row) + ": element \"" + elements[row] +
                           "\" has no radius in " + set + "; give radii as an array");
    }
    result.push_back(radius->radius.nearest);
  }
  return owned<double>(std::move(result));
}

std::vector<std::string> in_python(std::vector<std::string> messages) {
  for (std::string& message : messages) message = ::in_python(std::move(message));
  return messages;
}

}  // namespace

void bind_reading(nb::module_& module) {
  nb::class_<Reading>(
      module, "Reading",
      "What a file gave: weighted points exactly as its text says them, and who they "
      "are.\n\n"
      "AlphaShapes takes it as it is; `points` and `weights` are for looking at.")
      .def_prop_ro(
          "points",
          [](nb::handle self) {
            return coordinate_array(nb::cast<const Reading&>(self).points, self);
          },
          nb::rv_policy::automatic,
          nb::sig("def points(self) -> numpy.typing.NDArray[numpy.float64]"),
          "Coordinates, (n, 2) or (n, 3) float64, input units; correctly rounded.")
      .def_prop_ro(
          "weights", [](const Reading& self) { return weights_of(self.points); },
          nb::sig("def weights(self) -> numpy.typing.NDArray[numpy.float64] | None"),
          "Weights, signed squared lengths, (n,) float64; None where there are none.")
      .def_prop_ro(
          "ball_radii", [](const Reading& self) { return radii_of(self.points); },
          nb::sig("def ball_radii(self) -> numpy.typing.NDArray[numpy.float64] | None"),
          "Signed roots of the weights, lengths, (n,) float64; None where there are none.")
      .def_prop_ro(
          "decimals", [](const Reading& self) { return self.points.decimals(); },
          "k where every number is a whole number of 10^-k exactly; None where all are doubles.")
      .def_prop_ro(
          "dimension", [](const Reading& self) { return self.points.dimension(); }, "2 or 3.")
      .def_prop_ro("labels", &labels, nb::sig("def labels(self) -> dict[str, typing.Any]"),
                   "Who a row is, by kind: \"line\" (from 1), \"element\", \"atom\", \"residue\", "
                   "\"residue_id\",\n\"chain\", each with one entry a row; kinds that the format "
                   "does not tell are left out.")
      .def_ro("file", &Reading::file, "The path as given.")
      .def_ro("format", &Reading::format, "The format it was read as, one of input_formats().")
      .def_ro("radii", &Reading::radii, "Where weights come from, in words.")
      .def_ro("is_molecule", &Reading::is_molecule,
              "Whether weights are the squared radii of a molecule's atoms.")
      .def_prop_ro(
          "notes", [](const Reading& self) { return in_python(self.notes); },
          "Choices made while reading.")
      .def_prop_ro(
          "warnings", [](const Reading& self) { return in_python(self.warnings); },
          "Things to look at.")
      .def("__len__", [](const Reading& self) { return self.points.size(); })
      .def("__repr__", [](const Reading& self) {
        return "<orthoball.Reading of " + self.file + ": " + std::to_string(self.points.size()) +
               " sites, " + self.format + ", radii: " + self.radii + ">";
      });

  module.def(
      "read",
      [](const std::string& path, const std::string& format, std::optional<int> dimension,
         std::vector<std::string> columns, const std::string& radius_column,
         const std::string& weight_column, const std::string& radii,
         const std::optional<std::string>& default_radius, std::optional<int> model,
         const std::string& altloc, std::vector<std::string> chains, bool hydrogens, bool ligands,
         bool waters, bool allow_empty, bool limited) {
        const nb::gil_scoped_release released;
        orthoball::ReadOptions options{.format = format,
                                       .dimension = dimension,
                                       .columns = std::move(columns),
                                       .radius_column = radius_column,
                                       .weight_column = weight_column,
                                       .radii = radii,
                                       .default_radius = default_radius,
                                       .allow_empty = allow_empty,
                                       .limited = limited};
        options.molecule = {.model = model,
                            .altloc = altloc,
                            .hydrogens = hydrogens,
                            .ligands = ligands,
                            .waters = waters,
                            .chains = std::move(chains)};
        return orthoball::read(path, options);
      },
      nb::arg("path"), nb::kw_only(), nb::arg("format"), nb::arg("dimension").none(),
      nb::arg("columns"), nb::arg("radius_column"), nb::arg("weight_column"), nb::arg("radii"),
      nb::arg("default_radius").none(), nb::arg("model").none(), nb::arg("altloc"),
      nb::arg("chains"), nb::arg("hydrogens"), nb::arg("ligands"), nb::arg("waters"),
      nb::arg("allow_empty"), nb::arg("limited"), "See orthoball.read.");
  module.def("atom_radii", &atom_radii, nb::arg("elements"), nb::arg("residues"), nb::arg("atoms"),
             nb::arg("set"),
             "Radii [Å] of atoms by a named set or a file of radii, (n,); lists may be empty.");
  module.def("input_formats", &orthoball::input_formats, "Names of the formats that read() knows.");
}
