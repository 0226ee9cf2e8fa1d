// SPDX-License-Identifier: MIT
#include "orthoball/queries/locate.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/edit_options.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/query_memory.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/output/location_table.h"

namespace {

struct LocateOptions {
  InputOptions input;
  AlphaOptions alpha;
  EditOptions edits;
  std::string query, query_format, query_columns;
  std::string output = "-";
  std::string format;  // csv, json; empty: from the name of the output
  bool json = false;
};

// Reads QUERY. Messages of readers name the options of INPUT; here they are to name its own.
orthoball::Reading read_as_query(const std::string& query, const orthoball::ReadOptions& options) {
  const auto renamed = [](std::string message) {
    for (const auto& [name, own] :
         {std::pair<std::string, std::string>{"--input-format", "--query-format"},
          {"--columns", "--query-columns"}}) {
      const std::size_t at = message.find(name);
      if (at != std::string::npos) message.replace(at, name.size(), own);
    }
    return message;
  };
  try {
    return orthoball::read(query, options);
  } catch (const orthoball::ParseError& error) {
    const std::string at = orthoball::ParseError(error.file(), error.line(), "").what();
    throw orthoball::ParseError(error.file(), error.line(),
                                renamed(error.what()).substr(at.size()));
  } catch (const orthoball::InputError& error) {
    throw orthoball::InputError(error.reason(), error.row(), renamed(error.what()));
  }
}

// The points that are asked about; their weights do not matter.
orthoball::WeightedPoints read_query(const LocateOptions& options, int dimension) {
  orthoball::ReadOptions read;
  read.format = options.query_format;
  read.dimension = options.input.read.dimension;
  read.only_points = true;
  read.allow_empty = options.input.read.allow_empty;
  read.limited = !options.input.no_limit;
  read.memory = memory_of(options.input);
  if (!options.query_columns.empty()) {
    read.columns = CLI::detail::split(options.query_columns, ',');
  }
  orthoball::Reading reading = read_as_query(options.query, read);
  for (const std::string& warning : reading.warnings) say(options.input, "warning: " + warning);
  if (reading.points.dimension() == dimension) return std::move(reading.points);
  throw orthoball::ParseError(
      options.query, 0,
      fmt::format("the points have {} coordinates; those of {} have {}", reading.points.dimension(),
                  options.input.path, dimension));
}

template <int D>
void say_report(const LocateOptions& options, const ChosenAlpha& alpha,
                const orthoball::EditedShape<D>& shape,
                const std::vector<orthoball::Location<D>>& locations) {
  if (options.edits.are_given()) say(options.input, text_of(shape, options.edits));
  const auto inside = static_cast<std::size_t>(std::count_if(
      locations.begin(), locations.end(), [](const auto& one) { return one.region > 0; }));
  say(options.input, fmt::format("{}: {}, {} inside", text_of(alpha),
                                 orthoball::counted(locations.size(), "point"), inside));
}

void run(const LocateOptions& options) {
  require_other_file(options.input, options.output);
  if (options.input.path == "-" && options.query == "-") {
    throw UsageError("locate: INPUT and QUERY cannot both be standard input");
  }
  if (options.query != "-" && is_same_output(options.query, options.output)) {
    throw UsageError(options.output +
                     ": holds the query, which the output would replace; name another file");
  }
  check(options.alpha, false);
  const orthoball::ShapeEdits wanted = edits(options.edits);
  const bool is_json = options.json || (options.format.empty() ? ending_of(options.output) == "json"
                                                               : options.format == "json");
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::locating});
  const Loaded input = load(options.input, progress);
  const orthoball::WeightedPoints query = read_query(options, input.shapes.dimension());
  const auto given = chosen_alphas(options.alpha, input);
  const ChosenAlpha alpha = given.empty() ? automatic_alpha(input) : given[0];
  say_how(options.input, {alpha});
  std::size_t missing = 0;
  progress.begin(Stage::locating);
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        require_memory(options.input, locate_memory(D, filtration.size(), query.size()),
                       "locating " + orthoball::counted(query.size(), "point"));
        const orthoball::EditedShape<D> shape = edited_shape(filtration, alpha.index, wanted);
        const std::vector<orthoball::Location<D>> locations =
            locate(shape.complex, query, threads_of(options.input));
        missing =
            write_output(options.output, is_json ? "null" : "", [&](orthoball::ByteSink& sink) {
              using orthoball::TableFormat;
              write_locations<D>(sink, is_json ? TableFormat::json : TableFormat::csv, filtration,
                                 locations);
            });
        progress.end();
        say_report(options, alpha, shape, locations);
      },
      input.shapes.filtration());
  warn_of_missing(options.input, missing, is_json ? "null" : "an empty field");
}

}  // namespace

void add_locate_command(CLI::App& app) {
  auto options = std::make_shared<LocateOptions>();
  CLI::App* command = app.add_subcommand(
      "locate", "Which points are in the shape, in which region, how near its boundary.");
  add_alpha_options(*command, options->alpha, false, "auto");
  add_edit_options(*command, options->edits);
  add_data_options(*command, {options->output, options->format, options->json},
                   {"file, or - for standard output",
                    "csv or json\n(default: by the name of -o, else csv)",
                    {"csv", "json"}});
  add_input_options(*command, options->input);
  command
      ->add_option("QUERY", options->query,
                   "the points that are asked about, in any format that INPUT can have")
      ->required()
      ->type_name("")
      ->option_text(" ");
  const std::string group = "Query";
  command->add_option("--query-format", options->query_format, "read QUERY as one of the formats")
      ->type_name("NAME")
      ->check(CLI::IsMember(orthoball::input_formats()).description(""))
      ->group(group);
  command
      ->add_option("--query-columns", options->query_columns,
                   "coordinate columns of QUERY, as --columns of INPUT")
      ->type_name("LIST")
      ->group(group);
  command->footer(
      "Columns: row of the point, from 0; inside, 1 or 0, boundary included; region, the number "
      "of\n"
      "the component that it is in, 1 being the largest, empty outside; distance [length] to the\n"
      "nearest point x, y[, z] of the boundary, inside and outside; nearest, the rows of the\n"
      "simplex which that is on; simplex, the rows of the simplex of the triangulation that holds\n"
      "the point, whether in the shape or not, empty outside the convex hull of INPUT.\n"
      "inside, region and simplex are exact, distances rounded. Options of tables and molecules\n"
      "concern INPUT.\n\n"
      "Examples:\n"
      "  orthoball locate bunny.off probes.csv --alpha 0.01 -o inside.csv\n"
      "  orthoball locate 1ubq.pdb waters.pdb --alpha2 0 --json");
  command->callback([options] { run(*options); });
}
