// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <variant>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/usage_error.h"
#include "orthoball/output/tables.h"

namespace {

struct FilterOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string output = "-";
  std::string format;  // csv, json, npz; empty: from the name of the output
  bool json = false;
};

std::string format_of(const FilterOptions& options) {
  if (options.json) return "json";
  if (!options.format.empty()) return options.format;
  const std::string ending = ending_of(options.output);
  if (ending == "npz") return "npz";
  return ending == "json" || ending == "jsonl" ? "json" : "csv";
}

void run(const FilterOptions& options) {
  require_other_file(options.input, options.output);
  check(options.alpha, false);
  Progress progress(
      options.input.progress, options.input.quiet,
      {Stage::reading, Stage::triangulation, Stage::filtration, Stage::writing_filter});
  const Loaded input = load(options.input, progress);
  const auto chosen = chosen_alphas(options.alpha, input);
  say_how(options.input, chosen);
  const std::string format = format_of(options);
  progress.begin(Stage::writing_filter);
  const std::size_t missing =
      write_output(options.output, format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
        std::visit(
            [&]<int D>(const orthoball::Filtration<D>& filtration) {
              require_memory(options.input, orthoball::filter_memory(filtration.size()),
                             "the order of the simplices");
              const orthoball::Filter<D> filter(filtration, threads_of(options.input));
              const std::size_t count =
                  chosen.empty() ? filtration.size() : filter.complex_size(chosen[0].index);
              // The order by rows, and the longest arrays of an archive.
              require_memory(options.input, (format == "npz" ? 32 : 8) * std::uint64_t{count},
                             "the table");
              if (format == "csv") write_filter_csv(sink, filter, count);
              if (format == "json") write_filter_json_lines(sink, filter, count);
              if (format == "npz") write_filter_npz(sink, filter, count);
            },
            input.shapes.filtration());
      });
  progress.end();
  warn_of_missing(options.input, missing, format == "json" ? "null" : "an empty field");
}

}  // namespace

void add_filter_command(CLI::App& app) {
  auto options = std::make_shared<FilterOptions>();
  CLI::App* command = app.add_subcommand(
      "filter", "Every simplex in the order of its alpha2, with the indices of its roles.");
  add_alpha_options(*command, options->alpha, false, "every simplex");
  add_data_options(*command, {options->output, options->format, options->json},
                   {"file, or - for standard output",
                    "csv, json (one object a line) or npz (NumPy)\n"
                    "(default: by the name of -o, else csv)",
                    {"csv", "json", "npz"}});
  add_input_options(*command, options->input);
  command->footer(
      "Columns: position from 1; dimension; vertices, the rows of INPUT from 0; alpha2 "
      "[length^2];\n"
      "enters, regular, interior: indices of the spectrum at which the simplex joins the complex,\n"
      "gets a coface in it, and is inside the shape; empty for never (null, 0 in npz). With an\n"
      "alpha only the simplices of that complex.\n\n"
      "Examples:\n"
      "  orthoball filter points.csv -o filter.csv\n"
      "  orthoball filter 1ubq.pdb --alpha2 0 --json      the dual complex of the atoms");
  command->callback([options] { run(*options); });
}
