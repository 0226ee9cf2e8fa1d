// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/alpha_number.h"
#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/input/decimal.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/output/ball_tables.h"
#include "orthoball/output/void_table.h"
#include "orthoball/points/probe.h"
#include "orthoball/queries/voids.h"
#include "orthoball/topology/betti.h"

namespace {

using Json = nlohmann::ordered_json;

struct MeasureOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string probe = "0";
  std::string output = "-";
  std::string format;  // text, json; empty: from the name of the output
  bool json = false;
  std::string per_atom, per_residue, contacts, voids, derivatives;
};

bool is_json(const MeasureOptions& options) {
  if (options.json) return true;
  return options.format.empty() ? ending_of(options.output) == "json" : options.format == "json";
}

// An output beside the report, and the option that names it.
using Output = std::pair<std::string, std::string>;

std::vector<Output> tables(const MeasureOptions& options) {
  std::vector<Output> tables;
  const auto add = [&](const std::string& option, const std::string& path) {
    if (!path.empty()) tables.emplace_back(option, path);
  };
  add("--per-atom", options.per_atom);
  add("--per-residue", options.per_residue);
  add("--contacts", options.contacts);
  add("--voids", options.voids);
  add("--derivatives", options.derivatives);
  return tables;
}

// Every output needs a place of its own, and tables are CSV.
void check_outputs(const MeasureOptions& options) {
  require_other_file(options.input, options.output);
  std::vector<Output> seen{{"-o", options.output}};
  for (const Output& table : tables(options)) {
    const auto& [option, path] = table;
    require_other_file(options.input, path);
    for (const Output& other : seen) {
      if (!is_same_output(path, other.second)) continue;
      throw UsageError(path == "-" && other.first == "-o"
                           ? option + " -: the report goes to standard output; it needs -o FILE"
                           : other.first + " and " + option +
                                 " name the same file; each needs one of its own");
    }
    const std::string ending = path == "-" ? "" : ending_of(path);
    if (!ending.empty() && ending != "csv") {
      throw UsageError(
          fmt::format("{} {}: the table is CSV; the name must end in .csv", option, path));
    }
    seen.push_back(table);
  }
}

orthoball::ProbeRadius probe_from_text(const std::string& text) {
  orthoball::ProbeRadius probe{alpha2_from_text("--probe", text), {}, 0};
  if (probe.nearest < 0.0) {
    throw UsageError(fmt::format("--probe: \"{}\" is below 0; the radius of a probe is 0 or more",
                                 text.substr(0, 40)));
  }
  const orthoball::DecimalNumber number = orthoball::parse_decimal(text).number;
  constexpr orthoball::Int128 kLargest = orthoball::Int128{1} << 53;
  constexpr int kMostDecimals = 400;
  orthoball::Int128 digits = number.digits;
  int exponent = number.exponent;
  for (; exponent > 0 && digits <= kLargest; --exponent) digits *= 10;
  if (number.is_exact && exponent <= 0 && exponent >= -kMostDecimals && digits <= kLargest) {
    probe.digits = static_cast<std::int64_t>(digits);
    probe.decimals = -exponent;
  }
  return probe;
}

// What was read, as the balls that the probe's centre rolls around.
orthoball::Reading with_probe(orthoball::Reading reading, const orthoball::ProbeRadius& probe) {
  try {
    reading.points = orthoball::with_probe(reading.points, probe);
  } catch (const orthoball::InputError& error) {
    const auto& lines = reading.labels.line;
    const std::size_t line = error.row() < lines.size() ? lines[error.row()] : 0;
    throw orthoball::ParseError(reading.file, line, error.what());
  }
  return reading;
}

// What happened to the rows: each is counted once.
struct BallCounts {
  std::size_t exposed = 0;     // have a part of the surface
  std::size_t buried = 0;      // have none: other balls cover it
  std::size_t hidden = 0;      // have no power cell
  std::size_t duplicates = 0;  // of an earlier row
  std::size_t empty = 0;       // have no radius above 0
  bool has_radius = false;     // one is above 0
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
    counts.has_radius = counts.has_radius || has_inside;
    if (!has_cell[row]) continue;
    ++(balls.areas[row] > 0.0 ? counts.exposed : has_inside ? counts.buried : counts.empty);
  }
  return counts;
}

// What both forms of the report say.
template <int D>
struct Measured {
  ChosenAlpha at;
  orthoball::ProbeRadius probe;
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
  json["largest_ball"]["centre"] = std::move(centre);
  json["largest_ball"]["radius"] = number(hole.largest_ball_radius);
  return json;
}

template <int D>
Json json_report(const Loaded& input, const Measured<D>& measured, std::size_t& missing) {
  const auto number = [&](double x) { return finite(x, missing); };
  const orthoball::UnionOfBalls& balls = measured.balls;
  const BallCounts& counts = measured.counts;
  const bool has_alpha = !orthoball::is_of_empty_complex(balls.index, balls.alpha2);
  Json json;
  json["input"] = input_json(input);
  json["dimension"] = D;
  json["name"] = measured.at.name.empty() ? Json() : Json(measured.at.name);
  json["alpha2"] = has_alpha ? number(balls.alpha2) : Json();
  json["alpha"] = has_alpha ? number(measured.at.alpha) : Json();
  json["index"] = balls.index;
  json["probe"] = measured.probe.nearest;
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
  std::string text = input_text(input);
  if (measured.probe.nearest > 0.0) {
    text += report_line("probe", number_text(measured.probe.nearest) + unit(""));
  }
  text += report_line("at", text_of(measured.at));
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
  write(options.voids,
        [&](orthoball::ByteSink& sink) { orthoball::write_voids_csv<D>(sink, measured.voids); });
  write(options.derivatives,
        [&](orthoball::ByteSink& sink) { write_derivatives_csv(sink, balls, D); });
}

void check_residues(const MeasureOptions& options, const orthoball::Reading& reading) {
  const orthoball::SiteLabels& labels = reading.labels;
  if (options.per_residue.empty() || reading.points.size() == 0) return;
  if (!labels.residue.empty() || !labels.residue_id.empty() || !labels.chain.empty()) return;
  throw UsageError("--per-residue: " + reading.file +
                   " names no residues; --per-atom gives a line for every row");
}

void warn_of_points(const MeasureOptions& options, const Loaded& input, const BallCounts& counts) {
  if (counts.has_radius || input.shapes.points().size() == 0) return;
  const bool has_weights = input.shapes.points().weight_kind() != orthoball::WeightKind::none;
  say(options.input,
      fmt::format("warning: no ball has a radius above 0 at this alpha2; give {}--probe R or a "
                  "larger --alpha2",
                  has_weights ? "" : "radii (--radii, --radius-column), "));
}

// One alpha: that which was asked for, otherwise the balls as they are.
ChosenAlpha chosen_alpha(const MeasureOptions& options, const Loaded& input) {
  AlphaOptions alpha = options.alpha;
  if (!alpha.is_given()) alpha.alpha2 = "0";
  return chosen_alphas(alpha, input).front();
}

template <int D>
Measured<D> measure(const MeasureOptions& options, const Loaded& input,
                    const orthoball::ProbeRadius& probe,
                    const orthoball::Filtration<D>& filtration) {
  const std::uint64_t sites = filtration.triangulation().site_count();
  const std::uint64_t of_derivatives =
      options.derivatives.empty() ? 0 : 8 * std::uint64_t{4 * D + 2} * sites;
  const std::uint64_t of_contacts =
      options.contacts.empty() ? 0 : 2 * sizeof(orthoball::Contact) * filtration.count(1);
  require_memory(options.input, 100 * sites + of_derivatives + of_contacts, "the measures");
  const orthoball::Threads threads = threads_of(options.input);
  const ChosenAlpha at = chosen_alpha(options, input);
  orthoball::UnionOfBalls balls = orthoball::union_of_balls<D>(
      filtration, at.index, at.alpha2,
      {!options.contacts.empty(), !options.derivatives.empty(), threads});
  const BallCounts counts = ball_counts(input, filtration, balls);
  return {at,
          probe,
          std::move(balls),
          orthoball::betti_numbers<D>(filtration, at.index, threads),
          orthoball::voids<D>(filtration, at.index, at.alpha2, orthoball::VoidsOf::balls, threads),
          counts};
}

void run(const MeasureOptions& options) {
  check_outputs(options);
  check(options.alpha, false);
  const orthoball::ProbeRadius probe = probe_from_text(options.probe);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::measuring});
  orthoball::Reading reading = read_input(options.input, progress, false);
  check_residues(options, reading);
  const Loaded input = build_shapes(options.input, progress, with_probe(std::move(reading), probe));
  progress.begin(Stage::measuring);
  std::size_t missing = 0, missing_in_tables = 0;
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        const Measured<D> measured = measure(options, input, probe, filtration);
        say_how(options.input, {measured.at});
        write_tables(options, input, measured, missing_in_tables);
        const std::string report = is_json(options)
                                       ? json_report_text(json_report(input, measured, missing))
                                       : text_report(input, measured);
        progress.end();
        write_output(options.output, "", [&](orthoball::ByteSink& sink) {
          sink.text(report);
          sink.flush();
        });
        warn_of_points(options, input, measured.counts);
      },
      input.shapes.filtration());
  warn_of_missing(options.input, missing, "null");
  warn_of_missing(options.input, missing_in_tables, "an empty field");
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
  const auto table = [&](const std::string& name, std::string& path, const std::string& what) {
    command.add_option(name, path, what)->type_name("FILE")->group(group);
  };
  table("--per-atom", options.per_atom, "area and volume of every ball's part, as CSV");
  table("--per-residue", options.per_residue, "the same summed by residue, as CSV");
  table("--contacts", options.contacts, "pairs of balls with the area of their contact, as CSV");
  table("--voids", options.voids, "voids with the balls around them, as CSV");
  table("--derivatives", options.derivatives,
        "of area and volume by every radius and centre, as CSV");
}

}  // namespace

void add_measure_command(CLI::App& app) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = app.add_subcommand(
      "measure", "Volume, area and voids of the union of balls, and every ball's part.");
  command
      ->add_option("--probe", options->probe,
                   "radius R of a probe [length]: every radius r becomes r + R")
      ->type_name("R")
      ->capture_default_str()
      ->group("Balls");
  add_alpha_options(*command, options->alpha, false, "0, the balls as they are");
  add_output_options(*command, *options);
  add_input_options(*command, options->input);
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
      "--voids: void, volume, area, atoms (the rows of the balls around it), born, dies [alpha2],\n"
      "x, y, z and radius of the largest ball inside. A void lives from alpha2 born to dies.\n"
      "--derivatives: row, area_by_radius, volume_by_radius, volume_by_x.., area_by_x...\n"
      "--alpha2 auto is explained in shape --help.\n\n"
      "Examples:\n"
      "  orthoball measure 1ubq.pdb\n"
      "  orthoball measure 1ubq.pdb --probe 1.4 --per-residue residues.csv --json\n"
      "  orthoball measure trees.csv --columns x,y --radius-column crown");
  command->callback([options] { run(*options); });
}
