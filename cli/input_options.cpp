// SPDX-License-Identifier: MIT
#include "cli/input_options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/input/atom_radii.h"
#include "orthoball/input/decimal.h"
#include "orthoball/points/density_weights.h"

namespace {

const std::map<std::string, ProgressMode> kProgressModes{{"auto", ProgressMode::automatic},
                                                         {"never", ProgressMode::never},
                                                         {"always", ProgressMode::always}};

constexpr unsigned kMostThreads = 1024;

// The words with commas between them, in lines of the width that help has.
std::string listed(const std::vector<std::string>& words) {
  constexpr std::size_t kWidth = 70;
  std::string text;
  std::size_t begin = 0;  // of the line
  for (const std::string& word : words) {
    if (!text.empty()) text += ", ";
    if (text.size() + word.size() - begin > kWidth) {
      text.back() = '\n';
      begin = text.size();
    }
    text += word;
  }
  return text;
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

// "density:K", K a whole number from 1, as K.
const CLI::Validator kAsDensity(
    [](std::string& text) -> std::string {
      constexpr std::string_view kName = "density:";
      const std::string neighbours = text.starts_with(kName) ? text.substr(kName.size()) : "";
      const CLI::Validator number = whole_number(1, std::numeric_limits<std::uint32_t>::max());
      std::string copy = neighbours;
      if (!number(copy).empty()) {
        return "\"" + text.substr(0, 40) +
               "\" is no way to make weights; density:K is, K neighbours from 1, such as density:8";
      }
      text = neighbours;
      return {};
    },
    "");

void add_weight_options(CLI::App& command, InputOptions& options) {
  auto* const weights =
      command
          .add_option("--weights", options.density_neighbours,
                      "density:K: weights from the density of the sites instead of those of\n"
                      "INPUT: half the mean square distance to the K nearest others, so that\n"
                      "one alpha2, 0 at first, serves sparse and dense parts")
          ->type_name("density:K")
          ->transform(kAsDensity)
          ->group("Input");
  for (const char* const other : {"--radius-column", "--weight-column", "--radii"}) {
    weights->excludes(command.get_option(other));
  }
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
      ->check(whole_number(0, std::numeric_limits<int>::max()))
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

// "1.5G", "500 MB", "3000KiB" or "1000" as a number of bytes: 1 K is 1024.
const CLI::Validator kAsBytes(
    [](std::string& text) -> std::string {
      const std::size_t behind = std::min(text.find_first_not_of("0123456789."), text.size());
      const orthoball::DecimalParse number = orthoball::parse_decimal(text.substr(0, behind));
      std::string unit = text.substr(std::min(text.find_first_not_of(' ', behind), text.size()));
      for (char& c : unit) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      constexpr std::string_view kUnits = "BKMGT";
      const std::size_t power = unit.empty() ? 0 : kUnits.find(unit[0]);
      const bool has_end = unit.size() <= 1 || unit.substr(1) == "B" || unit.substr(1) == "IB";
      const double bytes = number.number.nearest * std::exp2(10.0 * static_cast<double>(power));
      if (number.fault != orthoball::DecimalFault::none || power == std::string_view::npos ||
          !has_end || !(bytes < 0x1p63)) {
        return "\"" + text + "\" is no size; 500M or 16G are";
      }
      text = fmt::format("{}", static_cast<std::uint64_t>(bytes));
      return {};
    },
    "");

// With the weights of --weights, if it was given.
orthoball::Reading weighted(orthoball::Reading reading, const InputOptions& options) {
  if (!options.density_neighbours) return reading;
  const std::size_t neighbours = *options.density_neighbours;
  require_memory(
      options, orthoball::density_weights_memory(reading.points.dimension(), reading.points.size()),
      "the weights from density");
  try {
    reading.points =
        orthoball::with_density_weights(reading.points, neighbours, threads_of(options));
  } catch (const orthoball::InputError& error) {
    const auto& lines = reading.labels.line;
    const std::size_t line = error.row() < lines.size() ? lines[error.row()] : 0;
    throw orthoball::ParseError(reading.file, line, error.what());
  }
  reading.radii =
      fmt::format("density, half the mean square distance to the {} nearest", neighbours);
  reading.is_molecule = false;
  return reading;
}

// What `work` gives; says at what the memory ran out.
template <class Work>
auto within_memory(const std::string& path, const Progress& progress, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw orthoball::LimitError(path + ": out of memory during " + progress.stage());
  }
}

}  // namespace

CLI::Validator whole_number(std::uint32_t least, std::uint32_t most) {
  const auto check = [=](const std::string& text) -> std::string {
    std::uint32_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && number >= least && number <= most) return {};
    return fmt::format("\"{}\" is no whole number from {} to {}", text.substr(0, 40), least, most);
  };
  return CLI::Validator(check, "");
}

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
                  "read INPUT as one of\n" + listed(orthoball::input_formats()))
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
  command
      .add_option("--threads", options.threads,
                  "at most N threads (default: one for each core);\nresults do not depend on it")
      ->type_name("N")
      ->check(whole_number(1, kMostThreads))
      ->group(group);
  command
      .add_option("--memory-limit", options.memory_limit,
                  "most memory to take, such as 500M or 16G (default: what the system has);\n"
                  "more is refused before it is taken, by an estimate")
      ->type_name("SIZE")
      ->transform(kAsBytes)
      ->group(group);
  add_table_options(command, options);
  add_molecule_options(command, options);
  add_weight_options(command, options);
  command.add_flag("--quiet", options.quiet, "no notes, warnings or progress on standard error")
      ->group("Messages");
  command
      .add_option_function<std::string>(
          "--progress",
          [&options](const std::string& mode) { options.progress = kProgressModes.at(mode); },
          "stages on standard error (default auto: on a terminal)")
      ->type_name("auto|never|always")
      ->check(CLI::IsMember({"auto", "never", "always"}).description(""))
      ->group("Messages");
}

orthoball::Reading read_input(const InputOptions& options, Progress& progress, bool says_notes) {
  orthoball::ReadOptions read = options.read;
  if (!options.columns.empty()) read.columns = CLI::detail::split(options.columns, ',');
  if (!options.chains.empty()) read.molecule.chains = CLI::detail::split(options.chains, ',');
  if (!options.default_radius.empty()) read.default_radius = options.default_radius;
  read.molecule.hydrogens = options.hydrogens == "keep";
  read.molecule.ligands = options.ligands == "keep";
  read.molecule.waters = options.waters == "keep";
  read.limited = !options.no_limit;

  read.memory = memory_of(options);

  progress.expect_file(options.path);
  progress.begin(Stage::reading);
  orthoball::Reading reading = within_memory(options.path, progress, [&] {
    return weighted(orthoball::read(options.path, read), options);
  });
  progress.end();
  progress.expect_sites(reading.points.size(), reading.points.dimension());
  if (says_notes) {
    if (reading.points.weight_kind() != orthoball::WeightKind::none) {
      say(options, "radii: " + reading.radii);
    }
    for (const std::string& note : reading.notes) say(options, note);
  }
  for (const std::string& warning : reading.warnings) say(options, "warning: " + warning);
  return reading;
}

Loaded build_shapes(const InputOptions& options, Progress& progress, orthoball::Reading reading) {
  orthoball::WeightedPoints points = std::move(reading.points);
  reading.points = orthoball::WeightedPoints(points.dimension());
  const orthoball::BuildOptions build{
      .threads = threads_of(options),
      .on_stage =
          [&](orthoball::BuildStage stage) {
            progress.begin(stage == orthoball::BuildStage::triangulation ? Stage::triangulation
                                                                         : Stage::filtration);
          },
      .memory = memory_of(options)};
  orthoball::AlphaShapes shapes = within_memory(
      options.path, progress, [&] { return orthoball::AlphaShapes(std::move(points), build); });
  progress.end();
  return {std::move(reading), std::move(shapes), build.threads, memory_of(options)};
}

Loaded load(const InputOptions& options, Progress& progress, bool says_notes) {
  return build_shapes(options, progress, read_input(options, progress, says_notes));
}

void require_other_file(const InputOptions& options, const std::string& output) {
  std::error_code none;  // where one of them is not there
  if (output == "-" || !std::filesystem::is_regular_file(output, none)) return;
  const auto is_output = [&](const std::string& path) {
    return std::filesystem::equivalent(path, output, none);
  };
  const auto refuse = [&](const std::string& what) {
    throw UsageError(output + ": " + what + ", which the output would replace; name another file");
  };
  const std::string& radii = options.read.radii;
  if (options.path != "-" && is_output(options.path)) refuse("is the input");
  const bool is_set = radii.empty() || radii == "none" || orthoball::AtomRadii::is_named(radii);
  if (!is_set && is_output(radii)) refuse("holds the radii");
}

orthoball::Threads threads_of(const InputOptions& options) {
  return options.threads ? orthoball::Threads(*options.threads) : orthoball::Threads();
}

orthoball::MemoryBudget memory_of(const InputOptions& options) {
  return options.memory_limit ? orthoball::MemoryBudget(*options.memory_limit)
                              : orthoball::MemoryBudget();
}

void require_memory(const InputOptions& options, std::uint64_t bytes, const std::string& work) {
  memory_of(options).require(bytes, options.path + ": " + work);
}

void say(const InputOptions& options, const std::string& text) {
  if (options.quiet) return;
  // A line of progress may stand where this one begins.
  const bool is_terminal =
      options.progress == ProgressMode::automatic && isatty(STDERR_FILENO) == 1;
  fmt::print(stderr, "{}orthoball: {}\n", is_terminal ? "\r\033[K" : "", text);
}

void warn_of_missing(const InputOptions& options, std::size_t count, const std::string& shown) {
  if (count == 0) return;
  say(options, fmt::format("warning: {} {} beyond the range of a double; shown as {}",
                           orthoball::counted(count, "number"), count == 1 ? "is" : "are", shown));
}
