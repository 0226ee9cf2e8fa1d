// SPDX-License-Identifier: MIT
#include "cli/input_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "orthoball/error.h"

namespace {

const std::map<std::string, ProgressMode> kProgressModes{{"auto", ProgressMode::automatic},
                                                         {"never", ProgressMode::never},
                                                         {"always", ProgressMode::always}};

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

void add_table_options(CLI::App& command, InputOptions& options) {
  const std::string group = "Tables";
  command
      .add_option("--columns", options.columns,
                  "coordinate columns, A,B[,C]: numbers from 1 or names\n"
                  "(default: headers x,y[,z], lon,lat, longitude,latitude; else the first)")
      ->type_name("LIST")
      ->group(group);
  auto* const radius =
      command
          .add_option("--radius-column", options.read.radius_column,
                      "column of radii r [length]; -r is an imaginary ball of weight -r^2")
          ->type_name("COLUMN")
          ->group(group);
  command
      .add_option("--weight-column", options.read.weight_column,
                  "column of weights [length^2], signed squared radii")
      ->type_name("COLUMN")
      ->excludes(radius)
      ->group(group);
}

void add_molecule_options(CLI::App& command, InputOptions& options) {
  const std::string group = "Molecules";
  const auto keep_or_drop = [&](const std::string& name, std::string& value,
                                const std::string& what) {
    command.add_option(name, value, what)
        ->type_name("keep|drop")
        ->check(CLI::IsMember({"keep", "drop"}).description(""))
        ->capture_default_str()
        ->group(group);
  };
  command
      .add_option("--radii", options.read.radii,
                  "radii of the atoms [Å]: bondi, alvarez, protor, none, or a file of\n"
                  "\"ELEMENT radius\" and \"RESIDUE ATOM radius\" lines\n"
                  "(default: the radii in the file if it has them, else bondi)")
      ->type_name("SET|FILE")
      ->group(group);
  command
      .add_option("--default-radius", options.default_radius,
                  "radius of elements that the set does not have [Å]")
      ->type_name("R")
      ->group(group);
  command
      .add_option("--model", options.read.molecule.model,
                  "the model with this number (default: the first)")
      ->type_name("N")
      ->group(group);
  command
      .add_option("--altloc", options.read.molecule.altloc,
                  "this alternate location (default: the highest occupancy)")
      ->type_name("LETTER")
      ->group(group);
  command.add_option("--chain", options.chains, "these chains only, A[,B...] (default: all)")
      ->type_name("LIST")
      ->group(group);
  keep_or_drop("--hydrogens", options.hydrogens, "hydrogen and deuterium atoms");
  keep_or_drop("--ligands", options.ligands, "hetero atoms other than water");
  keep_or_drop("--waters", options.waters, "water molecules");
}

}  // namespace

void add_input_options(CLI::App& command, InputOptions& options) {
  command
      .add_option("INPUT", options.path,
                  "points, balls or a molecule; the format is told by the name, .gz put\n"
                  "aside; - for standard input")
      ->required()
      ->type_name("")
      ->option_text(" ");
  const std::string group = "Input";
  command
      .add_option("--input-format", options.read.format,
                  "read INPUT as one of " + joined(orthoball::input_formats()))
      ->type_name("NAME")
      ->check(CLI::IsMember(orthoball::input_formats()).description(""))
      ->group(group);
  command
      .add_option("--dimension", options.read.dimension, "of space (default: as the file suggests)")
      ->type_name("2|3")
      ->check(CLI::IsMember({2, 3}).description(""))
      ->group(group);
  command
      .add_flag("--allow-empty", options.read.allow_empty,
                "a file in which no site is found is no error")
      ->group(group);
  command
      .add_flag("--no-limit", options.no_limit,
                "also inputs over 1 GiB, or compressed by more than 200")
      ->group(group);
  command.add_option("--threads", options.threads, "at most N threads; this version uses one")
      ->type_name("N")
      ->check(CLI::PositiveNumber.description(""))
      ->group(group);
  add_table_options(command, options);
  add_molecule_options(command, options);
  command.add_flag("--quiet", options.quiet, "no notes, warnings or progress on standard error")
      ->group("Messages");
  command
      .add_option("--progress", options.progress,
                  "stages on standard error (default auto: on a terminal)")
      ->type_name("auto|never|always")
      ->transform(CLI::CheckedTransformer(kProgressModes).description(""))
      ->group("Messages");
}

Loaded load(const InputOptions& options, Progress& progress, bool says_notes) {
  orthoball::ReadOptions read = options.read;
  if (!options.columns.empty()) read.columns = CLI::detail::split(options.columns, ',');
  if (!options.chains.empty()) read.molecule.chains = CLI::detail::split(options.chains, ',');
  if (!options.default_radius.empty()) read.default_radius = options.default_radius;
  read.molecule.hydrogens = options.hydrogens == "keep";
  read.molecule.ligands = options.ligands == "keep";
  read.molecule.waters = options.waters == "keep";
  read.limited = !options.no_limit;

  progress.begin("reading");
  orthoball::Reading reading = orthoball::read(options.path, read);
  progress.end();
  if (says_notes) {
    if (reading.points.weight_kind() != orthoball::WeightKind::none) {
      say(options, "radii: " + reading.radii);
    }
    for (const std::string& note : reading.notes) say(options, note);
  }
  for (const std::string& warning : reading.warnings) say(options, "warning: " + warning);

  orthoball::WeightedPoints points = std::move(reading.points);
  reading.points = orthoball::WeightedPoints(points.dimension());
  orthoball::AlphaShapes shapes(std::move(points), [&](orthoball::BuildStage stage) {
    progress.begin(stage == orthoball::BuildStage::triangulation ? "triangulation" : "filtration");
  });
  progress.end();
  return {std::move(reading), std::move(shapes)};
}

void say(const InputOptions& options, const std::string& text) {
  if (!options.quiet) fmt::print(stderr, "orthoball: {}\n", text);
}

void warn_of_missing(const InputOptions& options, std::size_t count, const std::string& shown) {
  if (count == 0) return;
  say(options, fmt::format("warning: {} number{} beyond the range of a double; shown as {}", count,
                           count == 1 ? " is" : "s are", shown));
}
