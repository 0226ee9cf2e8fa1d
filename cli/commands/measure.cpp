// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/balls.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/named_outputs.h"
#include "cli/output_file.h"
#include "cli/region_files.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/output/ball_tables.h"
#include "orthoball/output/molecule.h"
#include "orthoball/output/void_table.h"
#include "orthoball/queries/voids.h"
#include "orthoball/topology/betti.h"

namespace {

using Json = nlohmann::ordered_json;

struct MeasureOptions {
  BallsOptions balls;
  std::string output = "-";
  std::string format;  // text, json; empty: from the name of the output
  bool json = false;
  std::string per_atom, per_residue, contacts, residue_contacts, voids, derivatives, pdb, mesh,
      script;

  [[nodiscard]] bool wants_contacts() const {
    return !contacts.empty() || !residue_contacts.empty();
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
          {"--script", options.script, OutputKind::script}};
}

// What happened to the rows: each is counted once.
struct BallCounts {
  std::size_t exposed = 0;     // have a part of the surface
  std::size_t buried = 0;      // have none: other balls cover it
  std::size_t hidden = 0;      // have no power cell
  std::size_t duplicates = 0;  // of an earlier row
  std::size_t empty = 0;       // have no radius above 0
};

template <int D>
BallCounts ball_counts(const Loaded& input, const orthoball::Filtration<D>& filtration,
                       const orthoball::UnionOfBalls& balls) {
  const auto& triangulation = filtration.triangulation();
  BallCounts counts;
  std::vector<bool> has_cell(balls.areas.size(), true);
  for (const orthoball::SiteId row : triangulation.hidden()) has_cell[row.row()] = false;
  for (const orthoball::Duplicate& d : triangulation.duplicates()) has_cell[d.row.row()] = false;
  counts.duplicates = triangulation.duplicates().size();
  counts.hidden = triangulation.hidden().size();
  for (std::size_t row = 0; row < has_cell.size(); ++row) {
    const bool has_inside =
        orthoball::ball_radius(input.shapes.points(), row, balls.alpha2).value_or(0.0) > 0.0;
    if (!has_cell[row]) continue;
    ++(balls.areas[row] > 0.0 ? counts.exposed : has_inside ? counts.buried : counts.empty);
  }
  return counts;
}

// What both forms of the report say.
template <int D>
struct Measured {
  ChosenBalls chosen;
  orthoball::UnionOfBalls balls;
  orthoball::BettiNumbers<D> betti;
  std::vector<orthoball::Void<D>> voids;
  BallCounts counts;
};

template <int D>
Json json_of(const orthoball::Void<D>& hole, std::size_t& missing) {
  const auto number = [&](double x) { return finite(x, missing); };
  Json atoms = Json::array(), atom_areas = Json::array(), centre = Json::array();
  for (const orthoball::LiningBall& ball : hole.lining) {
    atoms.push_back(ball.row.row());
    atom_areas.push_back(number(ball.area));
  }
  for (const double x : hole.largest_ball_centre) centre.push_back(number(x));
  Json json;
  json["volume"] = number(hole.volume);
  json["area"] = number(hole.area);
  json["atoms"] = std::move(atoms);
  json["atom_areas"] = std::move(atom_areas);
  json["born"] = number(hole.born_alpha2);
  json["dies"] = number(hole.dies_alpha2);
  json["largest_ball"] = nullptr;
  if (hole.largest_ball_radius > 0.0) {
    json["largest_ball"] = {{"centre", std::move(centre)},
                            {"radius", number(hole.largest_ball_radius)}};
  }
  return json;
}

template <int D>
Json json_report(const Loaded& input, const Measured<D>& measured, std::size_t& missing) {
  const auto number = [&](double x) { return finite(x, missing); };
  const orthoball::UnionOfBalls& balls = measured.balls;
  const BallCounts& counts = measured.counts;
  Json json = balls_json(input, measured.chosen, missing);
  json["volume"] = number(balls.volume);
  json["area"] = number(balls.area);
  json["mean_curvature"] = D == 3 ? number(balls.mean_curvature) : Json();
  json["euler"] = balls.euler;
  json["betti"] = measured.betti;
  json["balls"] = {{"exposed", counts.exposed},
                   {"buried", counts.buried},
                   {"hidden", counts.hidden},
                   {"duplicates", counts.duplicates},
                   {"empty", counts.empty}};
  json["void_count"] = measured.voids.size();
  json["voids"] = Json::array();
  for (const orthoball::Void<D>& hole : measured.voids) {
    json["voids"].push_back(json_of(hole, missing));
  }
  return json;
}

// "486 exposed, 12 buried": those that there are, exposed ones always.
std::string counts_text(const BallCounts& counts) {
  std::vector<std::string> words{fmt::format("{} exposed", counts.exposed)};
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count > 0) words.push_back(fmt::format("{} {}", count, what));
  };
  add(counts.buried, "buried by others");
  add(counts.hidden, "hidden inside others");
  add(counts.duplicates, orthoball::noun_of(counts.duplicates, "duplicate"));
  add(counts.empty, "empty");
  return joined(words);
}

// The first of the voids, a line each.
template <int D>
std::string voids_text(const std::vector<orthoball::Void<D>>& voids, const std::string& unit) {
  if (voids.empty()) return {};
  constexpr std::size_t kShown = 7;
  const auto head = [&](const std::string& what, const char* power) {
    return unit.empty() ? what : fmt::format("{} [{}{}]", what, unit, power);
  };
  const auto row = [](const auto& first, const std::string& volume, const std::string& area,
                      const auto& balls, const std::string& radius) {
    return fmt::format("{:<7}{:>22} {:>22} {:>6} {:>26}\n", first, volume, area, balls, radius);
  };
  std::string text = "\n" + (D == 3 ? row("voids", head("volume", "³"), head("area", "²"), "balls",
                                          head("largest ball inside", ""))
                                    : row("holes", head("area", "²"), head("perimeter", ""),
                                          "disks", head("largest disk inside", "")));
  for (std::size_t i = 0; i < std::min(voids.size(), kShown); ++i) {
    const orthoball::Void<D>& hole = voids[i];
    text += row(fmt::format("  {}", i + 1), number_text(hole.volume), number_text(hole.area),
                hole.lining.size(), number_text(hole.largest_ball_radius));
  }
  if (voids.size() > kShown) {
    text += fmt::format("  and {} smaller; --voids FILE lists all\n", voids.size() - kShown);
  }
  return text;
}

template <int D>
std::string text_report(const Loaded& input, const Measured<D>& measured) {
  const auto unit = [&](const char* power) {
    return input.reading.is_molecule ? " Å" + std::string(power) : std::string();
  };
  const orthoball::UnionOfBalls& balls = measured.balls;
  std::string text = balls_text(input, measured.chosen);
  text += report_line(input.reading.is_molecule ? "atoms"
                      : D == 3                  ? "balls"
                                                : "disks",
                      counts_text(measured.counts));
  text +=
      report_line(D == 3 ? "volume" : "area", number_text(balls.volume) + unit(D == 3 ? "³" : "²"));
  text +=
      report_line(D == 3 ? "area" : "perimeter", number_text(balls.area) + unit(D == 3 ? "²" : ""));
  if (D == 3) text += report_line("mean curvature", number_text(balls.mean_curvature) + unit(""));
  text += report_line("euler", fmt::format("{}", balls.euler));
  text += report_line("betti", betti_text(measured.betti));
  return text + voids_text(measured.voids, input.unit());
}

template <int D>
void write_tables(const MeasureOptions& options, const Loaded& input, const Measured<D>& measured,
                  std::size_t& missing) {
  const auto write = [&](const std::string& path, const auto& table) {
    if (!path.empty()) missing += write_output(path, "", table);
  };
  const orthoball::UnionOfBalls& balls = measured.balls;
  const orthoball::SiteLabels& labels = input.reading.labels;
  write(options.per_atom, [&](orthoball::ByteSink& sink) {
    write_balls_csv(sink, balls, input.shapes.points(), labels);
  });
  write(options.per_residue,
        [&](orthoball::ByteSink& sink) { write_residues_csv(sink, balls, labels); });
  write(options.contacts,
        [&](orthoball::ByteSink& sink) { write_contacts_csv(sink, balls.contacts); });
  write(options.residue_contacts, [&](orthoball::ByteSink& sink) {
    write_residue_contacts_csv(sink, balls.contacts, balls.areas.size(), labels);
  });
  write(options.voids,
        [&](orthoball::ByteSink& sink) { orthoball::write_voids_csv<D>(sink, measured.voids); });
  write(options.derivatives,
        [&](orthoball::ByteSink& sink) { write_derivatives_csv(sink, balls, D); });
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
  Regions regions{"void"};
  for (const orthoball::Void<D>& hole : measured.voids) {
    Region& region = regions.all.emplace_back(
        Region{"void", hole.volume, hole.area, hole.cells, hole.lining, {}});
    if constexpr (D == 3) {
      region.largest = {hole.largest_ball_centre, hole.largest_ball_radius};
    }
  }
  write_region_mesh<D>(options.mesh, input, measured.chosen, filtration, regions);
  if constexpr (D == 3) {
    write_region_script(options.script, input, measured.chosen, filtration, regions);
  }
}

void check_residues(const MeasureOptions& options, const orthoball::Reading& reading) {
  const orthoball::SiteLabels& labels = reading.labels;
  const bool is_wanted = !options.per_residue.empty() || !options.residue_contacts.empty();
  if (!is_wanted || reading.points.size() == 0) return;
  if (!labels.residue.empty() || !labels.residue_id.empty() || !labels.chain.empty()) return;
  throw UsageError((options.per_residue.empty() ? "--residue-contacts: " : "--per-residue: ") +
                   reading.file +
                   " names no residues; --per-atom and --contacts have lines for rows");
}

template <int D>
Measured<D> measure(const MeasureOptions& options, const Loaded& input,
                    const orthoball::ProbeRadius& probe,
                    const orthoball::Filtration<D>& filtration) {
  const std::uint64_t sites = filtration.triangulation().site_count();
  const std::uint64_t of_derivatives =
      options.derivatives.empty() ? 0 : 8 * std::uint64_t{4 * D + 2} * sites;
  const std::uint64_t of_contacts =
      options.wants_contacts() ? 2 * sizeof(orthoball::Contact) * filtration.count(1) : 0;
  require_memory(options.balls.input, 400 * sites + of_derivatives + of_contacts, "the measures");
  const orthoball::Threads threads = threads_of(options.balls.input);
  const ChosenAlpha at = chosen_alpha(options.balls, input);
  orthoball::UnionOfBalls balls = orthoball::union_of_balls<D>(
      filtration, at.index, at.alpha2,
      {options.wants_contacts(), !options.derivatives.empty(), threads});
  const BallCounts counts = ball_counts(input, filtration, balls);
  return {{at, probe},
          std::move(balls),
          orthoball::betti_numbers<D>(filtration, at.index, threads),
          orthoball::voids<D>(filtration, at.index, at.alpha2, orthoball::VoidsOf::balls, threads),
          counts};
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
  if (!options.pdb.empty()) require_pdb_points(reading.points);
  const Loaded input = build_shapes(reads, progress, with_probe(std::move(reading), probe));
  progress.begin(Stage::measuring);
  std::size_t missing = 0, missing_in_tables = 0;
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        const Measured<D> measured = measure(options, input, probe, filtration);
        say_how(reads, {measured.chosen.at});
        write_tables(options, input, measured, missing_in_tables);
        write_pictures(options, input, filtration, measured);
        const std::string report = is_json(options)
                                       ? json_report_text(json_report(input, measured, missing))
                                       : text_report(input, measured);
        progress.end();
        write_output(options.output, "", [&](orthoball::ByteSink& sink) {
          sink.text(report);
          sink.flush();
        });
        warn_without_balls(reads, input, measured.balls.alpha2);
      },
      input.shapes.filtration());
  warn_of_missing(reads, missing, "null");
  warn_of_missing(reads, missing_in_tables, "an empty field");
}

void add_output_options(CLI::App& command, MeasureOptions& options) {
  const std::string group = "Output";
  command.add_option("-o,--output", options.output, "file of the report, or - for standard output")
      ->type_name("FILE")
      ->capture_default_str()
      ->group(group);
  auto* const format = command
                           .add_option("--format", options.format,
                                       "text or json\n(default: by the name of -o, else text)")
                           ->type_name("NAME")
                           ->check(CLI::IsMember({"text", "json"}).description(""))
                           ->group(group);
  command.add_flag("--json", options.json, "the same as --format json")
      ->excludes(format)
      ->group(group);
  const auto file = [&](const std::string& name, std::string& path, const std::string& what) {
    command.add_option(name, path, what)->type_name("FILE")->group(group);
  };
  file("--per-atom", options.per_atom, "area and volume of every ball's part, as CSV");
  file("--per-residue", options.per_residue, "the same summed by residue, as CSV");
  file("--contacts", options.contacts, "pairs of balls with the area of their contact, as CSV");
  file("--residue-contacts", options.residue_contacts, "the same summed by residues, as CSV");
  file("--voids", options.voids, "voids with the balls around them, as CSV");
  file("--derivatives", options.derivatives,
       "of area and volume by every radius and centre, as CSV");
  file("--pdb", options.pdb, "the atoms with their areas as B-factors, as PDB");
  file("--mesh", options.mesh, "the boundaries of all voids, as PLY");
  file("--script", options.script,
       "shows the voids in PyMOL or ChimeraX; FILE ends in\n.pml or .cxc");
}

}  // namespace

void add_measure_command(CLI::App& app) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = app.add_subcommand(
      "measure", "Volume, area and voids of the union of balls, and every ball's part.");
  add_balls_options(*command, options->balls);
  add_output_options(*command, *options);
  add_input_options(*command, options->balls.input);
  command->footer(
      "The balls at alpha2 have the squared radii (r + R)^2 + alpha2; imaginary ones are empty. "
      "In\n"
      "the plane volume is the area of the union, area its perimeter, and mean_curvature is null.\n"
      "A ball's part is what its power cell holds of the union; parts add up to the whole. Balls\n"
      "with no part of the surface are buried, those with no power cell hidden.\n\n"
      "--per-atom: row, chain, residue, atom, element, radius [length] as measured, area\n"
      "[length^2], volume [length^3]. --per-residue: chain, residue, atoms, area, volume.\n"
      "--contacts: row_1, row_2, area of the common facet of their power cells inside the union,\n"
      "exposed [length], how much of the circle in which they meet is on the surface.\n"
      "--residue-contacts: chain_1, residue_1, chain_2, residue_2, pairs (of atoms), area.\n"
      "--voids: void, volume, area, atoms (the rows of the balls around it), atom_areas (in it),\n"
      "born, dies [alpha2], between which it lives, x, y, z, radius of the largest ball inside.\n"
      "--derivatives: row, area_by_radius, volume_by_radius, volume_by_x.., area_by_x...\n"
      "--pdb: a row an ATOM record, in the order of the input; rows without names are X of UNK 1.\n"
      "--mesh: triangles that bound the cells of every void, in the plane edges, with the "
      "property\n"
      "void (from 1). --script: opens INPUT and shows the space of every void as spheres, and the\n"
      "atoms around it as a selection void_N_atoms. With a probe that is the space for its "
      "centre.\n"
      "--alpha2 auto is explained in shape --help.\n\n"
      "Examples:\n"
      "  orthoball measure 1ubq.pdb\n"
      "  orthoball measure 1ubq.pdb --probe 1.4 --per-residue residues.csv --json\n"
      "  orthoball measure trees.csv --columns x,y --radius-column crown");
  command->callback([options] { run(*options); });
}
