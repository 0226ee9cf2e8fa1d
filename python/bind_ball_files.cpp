// SPDX-License-Identifier: MIT
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/output/ball_tables.h"
#include "orthoball/output/molecule.h"
#include "orthoball/output/power_cell_files.h"
#include "orthoball/output/region_files.h"
#include "orthoball/output/region_tables.h"
#include "orthoball/output/row_names.h"
#include "orthoball/queries/power_cells.h"
#include "python/arrays.h"
#include "python/box.h"
#include "python/module.h"
#include "python/written.h"

using orthoball::AlphaShapes;
using orthoball::Filtration;
using orthoball::Reading;
using orthoball::UnionOfBalls;

namespace {

using MaybeThreads = std::optional<unsigned>;

std::string source_of(const Reading* reading) {
  return reading ? std::filesystem::path(reading->file).filename().string() : "points";
}

// A table of the balls: what it holds is named as the options of `orthoball measure` are.
nb::bytes ball_file(const AlphaShapes& shapes, const UnionOfBalls& balls, const Reading* reading,
                    const std::string& what, const std::string& format) {
  const orthoball::SiteLabels& labels = labels_of(reading);
  const bool of_residues = what == "per_residue" || what == "residue_contacts";
  if (of_residues && !orthoball::RowNames(labels).has_residues() && shapes.points().size() > 0) {
    refuse("the points name no residues; \"per_atom\" and \"contacts\" have lines for rows");
  }
  return written_table(format, [&](orthoball::ByteSink& sink, orthoball::TableFormat table) {
    if (what == "per_atom") write_balls(sink, table, balls, shapes.points(), labels);
    if (what == "per_residue") write_residues(sink, table, balls, labels);
    if (what == "contacts") write_contacts(sink, table, balls.contacts, labels);
    if (what == "residue_contacts") {
      write_residue_contacts(sink, table, balls.contacts, balls.areas.size(), labels);
    }
    if (what == "derivatives") write_derivatives(sink, table, balls, shapes.dimension(), labels);
  });
}

// How voids or pockets are written.
struct RegionFile {
  std::string name;    // "void" or "pocket"
  std::string format;  // csv, json, ply, pml or cxc
  double probe;
  std::string molecule;  // of scripts: the file from the folder of the script
};

orthoball::ShownRegions shown(const RegionFile& file, const UnionOfBalls& balls,
                              const Reading* reading) {
  return {file.name, "balls", source_of(reading), file.probe, balls.index, balls.alpha2, {}};
}

// `all` as a table by `table(sink, format)`, or as what shows them.
template <int D, class All, class Table>
nb::bytes region_file(const AlphaShapes& shapes, const All& all, orthoball::ShownRegions regions,
                      const RegionFile& file, const Reading* reading, const Table& table) {
  if (file.format == "csv" || file.format == "json") return written_table(file.format, table);
  const auto& filtration = std::get<Filtration<D>>(shapes.filtration());
  regions.all = orthoball::shown_regions(std::span(all));
  if (file.format == "ply") {
    return written("", [&](orthoball::ByteSink& sink) {
      orthoball::write_regions_mesh<D>(sink, filtration, shapes.points(), regions);
    });
  }
  const auto viewer = orthoball::viewer_of(file.format);
  if (!viewer) refuse_format(file.format, "csv, json, ply, and for molecules pml and cxc");
  if constexpr (D == 3) {
    return written("", [&](orthoball::ByteSink& sink) {
      orthoball::write_regions_script(sink, *viewer, filtration, regions, file.molecule,
                                      labels_of(reading));
    });
  }
  refuse("the points are in the plane; a script is of molecules in space");
}

nb::bytes voids_file(const AlphaShapes& shapes, const UnionOfBalls& balls, const Reading* reading,
                     const RegionFile& file, MaybeThreads threads) {
  return std::visit(
      [&]<int D>(const Filtration<D>& filtration) {
        std::vector<orthoball::Void<D>> voids;
        {
          const nb::gil_scoped_release released;
          voids = orthoball::voids<D>(filtration, balls.index, balls.alpha2,
                                      orthoball::VoidsOf::balls, threads_of(threads));
        }
        return region_file<D>(
            shapes, std::as_const(voids), shown(file, balls, reading), file, reading,
            [&](orthoball::ByteSink& sink, orthoball::TableFormat table) {
              orthoball::write_voids<D>(sink, table, voids, orthoball::VoidsOf::balls,
                                        labels_of(reading));
            });
      },
      shapes.filtration());
}

nb::bytes pockets_file(const AlphaShapes& shapes, const UnionOfBalls& balls, const Reading* reading,
                       const RegionFile& file, MaybeThreads threads) {
  return std::visit(
      [&]<int D>(const Filtration<D>& filtration) {
        std::vector<orthoball::Pocket> pockets;
        {
          const nb::gil_scoped_release released;
          pockets =
              orthoball::pockets<D>(filtration, balls.index, balls.alpha2, threads_of(threads));
        }
        return region_file<D>(shapes, std::as_const(pockets), shown(file, balls, reading), file,
                              reading,
                              [&](orthoball::ByteSink& sink, orthoball::TableFormat table) {
                                write_pockets(sink, table, pockets, labels_of(reading));
                              });
      },
      shapes.filtration());
}

// Cut by their balls, or by a box where there are none.
nb::bytes power_cell_file(const AlphaShapes& shapes, const UnionOfBalls* balls, const MaybeBox& box,
                          double tolerance, const Reading* reading, const std::string& format,
                          MaybeThreads threads) {
  const bool is_table = format == "csv" || format == "json";
  if (!is_table && format != "vtu" && format != "obj") {
    refuse_format(format, "csv, json, vtu and obj");
  }
  return std::visit(
      [&]<int D>(const Filtration<D>& filtration) {
        const orthoball::PowerCellOptions options{!is_table, tolerance, threads_of(threads)};
        std::vector<orthoball::PowerCell<D>> cells;
        {
          const nb::gil_scoped_release released;
          cells = balls
                      ? orthoball::power_cells_in_balls<D>(filtration, *balls, options)
                      : orthoball::power_cells<D>(filtration, box_of<D>(filtration, box), options);
        }
        const std::span<const orthoball::PowerCell<D>> all(cells);
        if (is_table) {
          return written_table(format,
                               [&](orthoball::ByteSink& sink, orthoball::TableFormat table) {
                                 orthoball::write_power_cells<D>(
                                     sink, table, all, shapes.points().size(), labels_of(reading));
                               });
        }
        return written("", [&](orthoball::ByteSink& sink) {
          if (format == "vtu") return orthoball::write_power_cells_vtu<D>(sink, all);
          orthoball::write_power_cells_obj<D>(sink, all, "power cells of " + source_of(reading));
        });
      },
      shapes.filtration());
}

// The bytes, and how many values and labels do not fit into their columns.
nb::tuple pdb_file(const AlphaShapes& shapes, const Given<double, 1>& values,
                   const Reading* reading) {
  orthoball::PdbLosses losses;
  const nb::bytes bytes = written("", [&](orthoball::ByteSink& sink) {
    orthoball::require_pdb_points(shapes.points());
    losses = write_pdb(sink, shapes.points(), labels_of(reading),
                       std::span(values.data(), values.size()));
  });
  return nb::make_tuple(bytes, losses.values, losses.labels);
}

}  // namespace

void bind_ball_files(nb::module_& module) {
  module.def("ball_file", &ball_file, nb::arg("shapes"), nb::arg("balls"),
             nb::arg("reading").none(), nb::arg("what"), nb::arg("format"),
             "A table of balls: csv or json.");
  const auto of_regions = [](const char* name, const auto& file) {
    return [=](const AlphaShapes& shapes, const UnionOfBalls& balls, const Reading* reading,
               const std::string& format, double probe, const std::string& molecule,
               MaybeThreads threads) {
      return file(shapes, balls, reading, RegionFile{name, format, probe, molecule}, threads);
    };
  };
  module.def("voids_file", of_regions("void", &voids_file), nb::arg("shapes"), nb::arg("balls"),
             nb::arg("reading").none(), nb::arg("format"), nb::arg("probe"), nb::arg("molecule"),
             nb::arg("threads").none(), "Voids of balls: csv, json, ply, pml or cxc.");
  module.def("pockets_file", of_regions("pocket", &pockets_file), nb::arg("shapes"),
             nb::arg("balls"), nb::arg("reading").none(), nb::arg("format"), nb::arg("probe"),
             nb::arg("molecule"), nb::arg("threads").none(),
             "Pockets of balls: csv, json, ply, pml or cxc.");
  module.def("power_cell_file", &power_cell_file, nb::arg("shapes"), nb::arg("balls").none(),
             nb::arg("box").none(), nb::arg("tolerance"), nb::arg("reading").none(),
             nb::arg("format"), nb::arg("threads").none(),
             "Power cells in balls or a box: csv, json, vtu or obj.");
  module.def("pdb_file", &pdb_file, nb::arg("shapes"), nb::arg("values"), nb::arg("reading").none(),
             "A PDB file with a value a row, how many values were cut, and how many labels.");
}
