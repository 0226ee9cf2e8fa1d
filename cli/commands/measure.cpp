// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/balls.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/input_options.h"
#include "cli/measure_report.h"
#include "cli/named_outputs.h"
#include "cli/output_file.h"
#include "cli/power_cell_file.h"
#include "cli/region_files.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/output/ball_tables.h"
#include "orthoball/output/molecule.h"
#include "orthoball/output/region_tables.h"
#include "orthoball/output/row_names.h"
#include "orthoball/queries/voids.h"
#include "orthoball/topology/betti.h"

namespace {

struct MeasureOptions {
  BallsOptions balls;
  std::string output = "-";
  std::string format;  // text, json; empty: from the name of the output
  bool json = false;
  std::string voids_of = "balls";  // or shape
  std::string per_atom, per_residue, contacts, residue_contacts, voids, derivatives, pdb, mesh,
      script;
  PowerCellFile cells;

  [[nodiscard]] bool wants_contacts() const {
    return !contacts.empty() || !residue_contacts.empty() || cells.is_within_balls();
  }
};

bool is_json(const MeasureOptions& options) {
  if (options.json) return true;
  return options.format.empty() ? ending_of(options.output) == "json" : options.format == "json";
}

std::vector<NamedOutput> outputs(const MeasureOptions& options) {
  return {{"--per-atom", options.per_atom},
          {"--per-residue", options.per_residue},
          {"--contacts", options.contacts},
          {"--residue-contacts", options.residue_contacts},
          {"--voids", options.voids},
          {"--derivatives", options.derivatives},
          {"--pdb", options.pdb, OutputKind::atoms},
          {"--mesh", options.mesh, OutputKind::mesh},
          {"--script", options.script, OutputKind::script},
          {"--cells", options.cells.path, OutputKind::cells}};
}

// Those that were asked for, in the order of the options.
template <int D>
void write_tables(const MeasureOptions& options, const Loaded& input, const Measured<D>& measured,
                  MissingNumbers& missing) {
  using orthoball::ByteSink;
  using orthoball::TableFormat;
  const auto write = [&](const std::string& path, const auto& table) {
    if (!path.empty()) write_table(path, missing, table);
  };
  const orthoball::UnionOfBalls& balls = measured.balls;
  const orthoball::SiteLabels& labels = input.reading.labels;
  write(options.per_atom, [&](ByteSink& sink, TableFormat format) {
    write_balls(sink, format, balls, input.shapes.points(), labels);
  });
  write(options.per_residue,
        [&](ByteSink& sink, TableFormat format) { write_residues(sink, format, balls, labels); });
  write(options.contacts, [&](ByteSink& sink, TableFormat format) {
    write_contacts(sink, format, balls.contacts, labels);
  });
  write(options.residue_contacts, [&](ByteSink& sink, TableFormat format) {
    write_residue_contacts(sink, format, balls.contacts, balls.areas.size(), labels);
  });
  write(options.voids, [&](ByteSink& sink, TableFormat format) {
    orthoball::write_voids<D>(sink, format, measured.voids, measured.voids_of, labels);
  });
  write(options.derivatives, [&](ByteSink& sink, TableFormat format) {
    write_derivatives(sink, format, balls, D, labels);
  });
}

// The atoms with their areas, and the files that show the voids.
template <int D>
void write_pictures(const MeasureOptions& options, const Loaded& input,
                    const orthoball::Filtration<D>& filtration, const Measured<D>& measured) {
  if (!options.pdb.empty()) {
    orthoball::PdbLosses losses;
    write_output(options.pdb, "", [&](orthoball::ByteSink& sink) {
      losses = write_pdb(sink, input.shapes.points(), input.reading.labels, measured.balls.areas);
    });
    const auto warn = [&](std::size_t count, const std::string& what, const char* done) {
      if (count == 0) return;
      say(options.balls.input,
          fmt::format("warning: {} in {}", orthoball::counted(count, what), options.pdb + done));
    };
    warn(losses.values, "area", " beyond what a B-factor can be; 999.99 stands for it");
    warn(losses.labels, "label", " longer than its columns; the rest is left out");
  }
  auto regions = regions_of(input, measured.chosen, "void", options.voids_of);
  regions.all = orthoball::shown_regions<D>(measured.voids);
  write_region_mesh<D>(options.mesh, input, filtration, regions);
  if constexpr (D == 3) write_region_script(options.script, input, filtration, regions);
}

void check_residues(const MeasureOptions& options, const orthoball::Reading& reading) {
  const bool is_wanted = !options.per_residue.empty() || !options.residue_contacts.empty();
  if (!is_wanted || reading.points.size() == 0) return;
  if (orthoball::RowNames(reading.labels).has_residues()) return;
  throw UsageError((options.per_residue.empty() ? "--residue-contacts: " : "--per-residue: ") +
                   reading.file +
                   " names no residues; --per-atom and --contacts have lines for rows");
}

template <int D>
Measured<D> measure(const MeasureOptions& options, const Loaded& input,
                    const orthoball::ProbeRadius& probe,
                    const orthoball::Filtration<D>& filtration) {
  const std::uint64_t needed = union_memory({D, filtration.triangulation().site_count(),
                                             options.wants_contacts() ? filtration.count(1) : 0,
                                             !options.derivatives.empty()});
  require_memory(options.balls.input, needed, "the measures");
  const orthoball::Threads threads = threads_of(options.balls.input);
  const ChosenAlpha at = chosen_alpha(options.balls, input);
  orthoball::UnionOfBalls balls = orthoball::union_of_balls<D>(
      filtration, at.index, at.alpha2,
      {options.wants_contacts(), !options.derivatives.empty(), threads});
  const auto of =
      options.voids_of == "shape" ? orthoball::VoidsOf::shape : orthoball::VoidsOf::balls;
  Measured<D> measured{{at, probe},
                       std::move(balls),
                       orthoball::betti_numbers<D>(filtration, at.index, threads),
                       of,
                       orthoball::voids<D>(filtration, at.index, at.alpha2, of, threads),
                       {},
                       {}};
  measured.counts = ball_counts(input, filtration, measured.balls);
  if constexpr (D == 3) {
    if (probe.nearest > 0.0) {
      require_memory(options.balls.input, molecular_memory(filtration, at.index),
                     "the molecular surface");
      measured.molecular_surface =
          orthoball::molecular_surface(filtration, measured.balls, probe.nearest, threads);
    }
  }
  return measured;
}

// Molecular volume and area are differences of those of balls as large as the probe.
template <int D>
void warn_of_rounding(const InputOptions& reads, const Measured<D>& measured) {
  constexpr double kFewDigits = 1e-8;
  const auto& surface = measured.molecular_surface;
  if (!surface || !std::isfinite(measured.balls.volume)) return;
  const double of_volume = 0x1p-51 * measured.balls.volume;
  const double of_area = 0x1p-51 * measured.balls.area;
  if (!(of_volume > kFewDigits * surface->volume || of_area > kFewDigits * surface->area)) return;
  say(reads, fmt::format("warning: beside a probe this large the atoms are tiny; rounding changes "
                         "the molecular volume by up to {:.1g}, the area by up to {:.1g}",
                         of_volume, of_area));
}

void run(const MeasureOptions& options) {
  const InputOptions& reads = options.balls.input;
  check_outputs(reads, options.output, outputs(options));
  const orthoball::ProbeRadius probe = checked_probe(options.balls);
  Progress progress(reads.progress, reads.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::measuring});
  orthoball::Reading reading = read_input(reads, progress, false);
  check_residues(options, reading);
  check_script(options.script, reading);
  check_power_cells(options.cells, reading.points.dimension());
  if (!options.pdb.empty()) require_pdb_points(reading.points);
  const Loaded input = build_shapes(reads, progress, with_probe(std::move(reading), probe));
  progress.begin(Stage::measuring);
  MissingNumbers missing;
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        const Measured<D> measured = measure(options, input, probe, filtration);
        say_how(reads, {measured.chosen.at});
        if (is_json(options)) {
          std::size_t lining = 0;
          for (const orthoball::Void<D>& hole : measured.voids) lining += hole.lining.size();
          require_memory(reads, report_memory(lining, input), "the report");
        }
        // First, for it may be refused.
        write_power_cells(options.cells, reads, input, measured.chosen, filtration, measured.balls,
                          missing);
        write_tables(options, input, measured, missing);
        write_pictures(options, input, filtration, measured);
        const std::string report = is_json(options) ? json_report(input, measured, missing.nulls)
                                                    : text_report(input, measured);
        progress.end();
        write_output(options.output, "", [&](orthoball::ByteSink& sink) {
          sink.text(report);
          sink.flush();
        });
        warn_without_balls(reads, input, measured.balls.alpha2);
        warn_of_rounding(reads, measured);
      },
      input.shapes.filtration());
  warn_of_missing(reads, missing.nulls, "null");
  warn_of_missing(reads, missing.empty_fields, "an empty field");
}

void add_output_options(CLI::App& command, MeasureOptions& options) {
  const std::string group = "Output";
  add_data_options(command, {options.output, options.format, options.json},
                   {"file of the report, or - for standard output",
                    "text or json\n(default: by the name of -o, else text)",
                    {"text", "json"}});
  const auto file = [&](const std::string& name, std::string& path, const std::string& what) {
    command.add_option(name, path, what)->type_name("FILE")->group(group);
  };
  file("--per-atom", options.per_atom, "area and volume of every ball's part");
  file("--per-residue", options.per_residue, "the same summed by residue");
  file("--contacts", options.contacts, "pairs of balls with the area of their contact");
  file("--residue-contacts", options.residue_contacts, "the same summed by residues");
  file("--voids", options.voids, "voids with the balls around them");
  file("--derivatives", options.derivatives, "of area and volume by every radius and centre");
  file("--pdb", options.pdb, "the atoms with their areas as B-factors, as PDB");
  file("--mesh", options.mesh, "the boundaries of all voids, as PLY");
  file("--script", options.script,
       "shows the voids in PyMOL or ChimeraX; FILE ends in\n.pml or .cxc");
  add_power_cell_options(command, options.cells, group);
}

}  // namespace

void add_measure_command(CLI::App& app) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = app.add_subcommand(
      "measure", "Volume, area and voids of the union of balls, and every ball's part.");
  add_balls_options(*command, options->balls);
  command
      ->add_option("--voids-of", options->voids_of,
                   "balls, or shape: measure voids as what the balls leave\nfree, or as what the "
                   "alpha shape does")
      ->type_name("NAME")
      ->check(CLI::IsMember({"balls", "shape"}).description(""))
      ->capture_default_str()
      ->group("Balls");
  add_output_options(*command, *options);
  add_input_options(*command, options->balls.input);
  command->footer(
      "The balls at alpha2 have the squared radii (r + R)^2 + alpha2; imaginary ones are empty.\n"
      "In the plane volume is the area of the union, area its perimeter, and mean_curvature is\n"
      "null. A ball's part is what its power cell holds of the union; parts add up to the whole.\n"
      "Balls with no part of the surface are buried, those with no power cell hidden.\n"
      "With a probe, in space, volume and area are those that its centre goes around (solvent-\n"
      "accessible); molecular (solvent-excluded) are those of what the probe never covers. json:\n"
      "molecular_surface has volume, area, convex_area, toroidal_area and concave_area, or is "
      "null.\n\n"
      "Tables are JSON where FILE ends in .json, else CSV, with the columns below as keys. row,\n"
      "chain, residue and atom say who a ball is; points and files without names have rows alone.\n"
      "--per-atom: row, chain, residue, atom, element, radius [length] as measured, area\n"
      "[length^2], volume [length^3]. --per-residue: chain, residue, atoms, area, volume.\n"
      "--contacts: row_1, chain_1, residue_1, atom_1, row_2, ..., area of the common facet of "
      "their\n"
      "power cells inside the union, exposed_length, how much of the circle in which they meet "
      "is\n"
      "on the surface. --residue-contacts: chain_1, residue_1, chain_2, residue_2, pairs (of\n"
      "atoms), area. --voids: void, volume, area, of the balls around it atoms (rows), atom_names\n"
      "(CHAIN/RESIDUE/ATOM) and atom_areas (in it), born, dies [alpha2], between which it lives, "
      "x,\n"
      "y, z, radius of the largest ball inside. --derivatives: row, chain, residue, atom,\n"
      "area_by_radius, volume_by_radius, volume_by_x.., area_by_x...\n"
      "--pdb: a row an ATOM record, in the order of the input; rows without names are X of UNK 1.\n"
      "--mesh: triangles between the cells of every void and others, in the plane edges, with the "
      "property\n"
      "void (from 1). --script: opens INPUT and shows the space of every void as spheres, and the\n"
      "atoms around it as a selection void_N_atoms. With a probe that is the space for its "
      "centre.\n"
      "--cells: the places nearer to a ball than to any other, by distance^2 - radius^2, as\n"
      "polyhedra or polygons, or as CSV: row, chain, residue, atom, element, volume, area of the\n"
      "surface, exposed_area (of that, on the box or the sphere), facets (neighbours), is_clipped\n"
      "(1 or 0, by the box or the ball). Within balls they are the parts of the union.\n"
      "The alpha shape (triangles, edges and points between the centres) has the same voids as "
      "the\n"
      "union of balls, but larger. --voids-of shape measures those, without atom_areas and "
      "largest\n"
      "ball. --alpha2 auto is explained in shape --help.\n\n"
      "Examples:\n"
      "  orthoball measure 1ubq.pdb\n"
      "  orthoball measure 1ubq.pdb --probe 1.4 --per-residue residues.csv --json\n"
      "  orthoball measure trees.csv --columns x,y --radius-column crown");
  command->callback([options] { run(*options); });
}
