// SPDX-License-Identifier: MIT
#include "orthoball/queries/pockets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/balls.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/named_outputs.h"
#include "cli/output_file.h"
#include "cli/region_files.h"
#include "cli/report.h"
#include "orthoball/counted.h"
#include "orthoball/output/region_tables.h"

namespace {

using Json = nlohmann::ordered_json;
using Pockets = std::vector<orthoball::Pocket>;

struct PocketsOptions {
  BallsOptions balls;
  std::string output = "-";
  std::string format;  // text, json, csv; empty: from the name of the output
  bool json = false;
  std::string mesh, script;
};

std::string format_of(const PocketsOptions& options) {
  if (options.json) return "json";
  if (!options.format.empty()) return options.format;
  const std::string ending = ending_of(options.output);
  return ending == "json" || ending == "csv" ? ending : "text";
}

constexpr std::array<const char*, 3> kKinds{"void", "pocket", "channel"};

std::array<std::size_t, 3> counts_of(const Pockets& pockets) {
  std::array<std::size_t, 3> counts{};
  for (const orthoball::Pocket& pocket : pockets)
    ++counts[std::min<std::size_t>(2, pocket.mouths.size())];
  return counts;
}

Json json_of(const Loaded& input, const orthoball::Pocket& pocket, std::size_t& missing) {
  const auto number = [&](double x) { return finite(x, missing); };
  Json mouths = Json::array();
  for (const orthoball::Mouth& mouth : pocket.mouths) {
    Json rim = Json::array();
    for (const orthoball::SiteId row : mouth.rim) rim.push_back(row.row());
    mouths.push_back({{"area", number(mouth.area)},
                      {"rim", std::move(rim)},
                      {"rim_names", names_json(mouth.rim, input)}});
  }
  Json json;
  json["kind"] = pocket_kind(pocket);
  json["volume"] = number(pocket.volume);
  json["area"] = number(pocket.area);
  json["depth"] = pocket.depth ? number(*pocket.depth) : Json();
  add_lining(json, pocket.lining, true, input, missing);
  json["mouths"] = std::move(mouths);
  return json;
}

std::string json_report(const Loaded& input, const ChosenBalls& balls, const Pockets& pockets,
                        std::size_t& missing) {
  Json json = balls_json(input, balls, missing);
  const auto counts = counts_of(pockets);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    json[fmt::format("{}_count", kKinds[i])] = counts[i];
  }
  json["pockets"] = Json::array();
  for (const orthoball::Pocket& pocket : pockets)
    json["pockets"].push_back(json_of(input, pocket, missing));
  return json_report_text(json);
}

// The areas of the largest mouths: "2: 31.5 8.25".
std::string mouths_text(const orthoball::Pocket& pocket) {
  constexpr std::size_t kShown = 3;
  if (pocket.mouths.empty()) return "0";
  std::string text = fmt::format("{}:", pocket.mouths.size());
  for (std::size_t i = 0; i < std::min(kShown, pocket.mouths.size()); ++i) {
    text += " " + number_text(pocket.mouths[i].area);
  }
  return pocket.mouths.size() > kShown ? text + " ..." : text;
}

// The first pockets, a line each.
std::string pockets_text(const Loaded& input, const Pockets& pockets) {
  if (pockets.empty()) return {};
  constexpr std::size_t kShown = 10;
  const bool is_space = input.shapes.points().dimension() == 3;
  const auto head = [&](const std::string& what, const char* power) {
    return input.unit().empty() ? what : fmt::format("{} [{}{}]", what, input.unit(), power);
  };
  const auto row = [](const auto& first, const std::string& kind, const std::string& volume,
                      const std::string& area, const auto& balls, const std::string& depth,
                      const std::string& mouths) {
    return fmt::format("{:<9}{:<7} {:>22} {:>22} {:>6} {:>22}  {}\n", first, kind, volume, area,
                       balls, depth, mouths);
  };
  std::string text =
      "\n" + (is_space ? row("pockets", "kind", head("volume", "³"), head("area", "²"), "balls",
                             head("depth", "²"), head("mouths", "²"))
                       : row("pockets", "kind", head("area", "²"), head("perimeter", ""), "disks",
                             head("depth", "²"), head("mouths", "")));
  for (std::size_t i = 0; i < std::min(pockets.size(), kShown); ++i) {
    const orthoball::Pocket& pocket = pockets[i];
    text += row(fmt::format("  {}", i + 1), std::string(pocket_kind(pocket)),
                number_text(pocket.volume), number_text(pocket.area), pocket.lining.size(),
                pocket.depth ? number_text(*pocket.depth) : "", mouths_text(pocket));
  }
  if (pockets.size() > kShown) {
    text += fmt::format("  and {} smaller; --format csv lists all\n", pockets.size() - kShown);
  }
  return text;
}

std::string text_report(const Loaded& input, const ChosenBalls& balls, const Pockets& pockets) {
  std::vector<std::string> words;
  const auto counts = counts_of(pockets);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    words.push_back(orthoball::counted(counts[i], kKinds[i]));
  }
  return balls_text(input, balls) + report_line("found", joined(words)) +
         pockets_text(input, pockets);
}

// The balls that JSON lists, around pockets and mouths.
std::size_t listed(const Pockets& pockets) {
  std::size_t balls = 0;
  for (const orthoball::Pocket& pocket : pockets) {
    balls += pocket.lining.size();
    for (const orthoball::Mouth& mouth : pocket.mouths) balls += mouth.rim.size();
  }
  return balls;
}

void run(const PocketsOptions& options) {
  const InputOptions& reads = options.balls.input;
  check_outputs(reads, options.output,
                {{"--mesh", options.mesh, OutputKind::mesh},
                 {"--script", options.script, OutputKind::script}});
  const orthoball::ProbeRadius probe = checked_probe(options.balls);
  const std::string format = format_of(options);
  Progress progress(reads.progress, reads.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::measuring});
  orthoball::Reading reading = read_input(reads, progress, format == "csv");
  check_script(options.script, reading);
  const Loaded input = build_shapes(reads, progress, with_probe(std::move(reading), probe));
  progress.begin(Stage::measuring);
  std::size_t missing = 0;
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        const ChosenBalls balls{chosen_alpha(options.balls, input), probe};
        require_memory(reads, pockets_memory(D, filtration.count(D)), "the pockets");
        const Pockets pockets =
            orthoball::pockets<D>(filtration, balls.at.index, balls.at.alpha2, threads_of(reads));
        if (format == "json")
          require_memory(reads, report_memory(listed(pockets), input), "the report");
        say_how(reads, {balls.at});
        auto regions = regions_of(input, balls, "pocket", "balls");
        regions.all = orthoball::shown_regions(pockets);
        write_region_mesh<D>(options.mesh, input, filtration, regions);
        if constexpr (D == 3) write_region_script(options.script, input, filtration, regions);
        progress.end();
        missing += write_output(options.output, "", [&](orthoball::ByteSink& sink) {
          if (format == "csv") {
            return write_pockets(sink, orthoball::TableFormat::csv, pockets, input.reading.labels);
          }
          sink.text(format == "json" ? json_report(input, balls, pockets, missing)
                                     : text_report(input, balls, pockets));
          sink.flush();
        });
        warn_without_balls(reads, input, balls.at.alpha2);
      },
      input.shapes.filtration());
  warn_of_missing(reads, missing, format == "csv" ? "an empty field" : "null");
}

void add_output_options(CLI::App& command, PocketsOptions& options) {
  const std::string group = "Output";
  add_data_options(command, {options.output, options.format, options.json},
                   {"file to write, or - for standard output",
                    "text, json or csv\n(default: by the name of -o, else text)",
                    {"text", "json", "csv"}});
  const auto file = [&](const std::string& name, std::string& path, const std::string& what) {
    command.add_option(name, path, what)->type_name("FILE")->group(group);
  };
  file("--mesh", options.mesh, "the boundaries of all pockets, as PLY");
  file("--script", options.script, "shows them in PyMOL or ChimeraX; FILE ends in .pml\nor .cxc");
}

}  // namespace

void add_pockets_command(CLI::App& app) {
  auto options = std::make_shared<PocketsOptions>();
  CLI::App* command = app.add_subcommand(
      "pockets", "Voids, pockets and channels of the union of balls, with their mouths.");
  add_balls_options(*command, options->balls);
  add_output_options(*command, *options);
  add_input_options(*command, options->balls.input);
  command->footer(
      "The balls at alpha2 have the squared radii (r + R)^2 + alpha2; imaginary ones are empty.\n"
      "A pocket is a part of the space outside that widens before it comes out: balls that grow\n"
      "close its mouths before they fill it. By the number of its mouths it is a void (none, with\n"
      "no way out), a pocket (one) or a channel (two or more). Space that only widens on its way\n"
      "out is no pocket. A hole right through, a tunnel, is a cycle that betti 1 counts (summary,\n"
      "measure); it may but need not be a channel.\n\n"
      "Which balls and mouths are whose is exact. Volume [length^3] and area [length^2] of voids\n"
      "are exact but for rounding; those of pockets with mouths include parts of balls that reach\n"
      "through a mouth, usually below 3 %, but far more, even below 0, where depth is near 0. In\n"
      "the plane volume is the area, area the perimeter, and a mouth's area its width.\n"
      "depth [length^2]: by how much alpha2 grows from the closing of the mouths to the filling "
      "of\n"
      "the pocket; none for voids.\n\n"
      "csv: pocket, kind, volume, area, depth, of the balls around it atoms (rows), atom_names\n"
      "(CHAIN/RESIDUE/ATOM) and atom_areas (in it), mouths (their number), mouth_areas. json: "
      "also\n"
      "the rim of every mouth (rows and names). Largest volume first. --alpha2 auto is explained "
      "in\n"
      "shape --help.\n"
      "--mesh: triangles that bound the cells of every pocket, in the plane edges, with the\n"
      "properties pocket (from 1) and mouth (1 where it is open). --script: opens INPUT and shows\n"
      "the space of every pocket as spheres, and the atoms around as a selection pocket_N_atoms.\n"
      "With a probe that is the space for its centre.\n\n"
      "Examples:\n"
      "  orthoball pockets 1fmo.pdb --probe 1.4\n"
      "  orthoball pockets 1fmo.pdb --probe 1.4 -o pockets.csv --script pockets.pml\n"
      "  orthoball pockets trees.csv --columns x,y --radius-column crown --json");
  command->callback([options] { run(*options); });
}
