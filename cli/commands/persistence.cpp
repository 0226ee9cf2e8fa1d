// SPDX-License-Identifier: MIT
#include "orthoball/topology/persistence.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/alpha_number.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/signature_picture.h"
#include "cli/usage_error.h"
#include "orthoball/output/persistence_plot.h"
#include "orthoball/output/persistence_table.h"

namespace {

struct PersistenceOptions {
  InputOptions input;
  std::optional<unsigned> dimension;
  std::string minimum_length;
  bool all = false;
  bool indices = false;
  std::string output = "-";
  std::string format;  // csv, json, gudhi; empty: from the name of the output
  bool json = false;
  std::string plot;
  std::string plot_kind = "diagram";
  std::string plot_axis = "alpha";
};

std::string format_of(const PersistenceOptions& options) {
  if (options.json) return "json";
  if (!options.format.empty()) return options.format;
  const std::string ending = ending_of(options.output);
  return ending == "json" ? "json" : ending == "pers" ? "gudhi" : "csv";
}

// Those that were asked for.
template <int D>
orthoball::PersistencePairs<D> chosen_pairs(const PersistenceOptions& options,
                                            const orthoball::Filtration<D>& filtration) {
  using orthoball::WantedPairs;
  auto pairs = orthoball::persistence_pairs(
      filtration, options.all ? WantedPairs::all : WantedPairs::lasting, threads_of(options.input));
  for (unsigned k = 0; k < D; ++k) {
    if (options.dimension && *options.dimension != k) pairs[k].clear();
  }
  if (options.minimum_length.empty()) return pairs;
  const double least = alpha2_from_text("--minimum-length", options.minimum_length);
  const auto is_short = [&](const orthoball::PersistencePair& pair) {
    if (!pair.death.exists()) return false;
    const double length = filtration.alpha2(filtration.enters(pair.death)) -
                          filtration.alpha2(filtration.enters(pair.birth));
    return length < least;
  };
  for (auto& of_dimension : pairs) std::erase_if(of_dimension, is_short);
  return pairs;
}

template <int D>
void write_plot(const PersistenceOptions& options, const Loaded& input,
                const orthoball::Filtration<D>& filtration,
                const orthoball::PersistencePairs<D>& pairs) {
  const orthoball::PlotOptions of_input = plot_options(options.input, input);
  orthoball::PersistencePlotOptions plot;
  plot.title = of_input.title;
  plot.subtitle = of_input.subtitle;
  plot.unit = of_input.unit;
  plot.axis = plot_axis(options.plot_axis);
  plot.picture = options.plot_kind == "barcode" ? orthoball::PersistencePicture::barcode
                                                : orthoball::PersistencePicture::diagram;
  write_output(options.plot, "0", [&](orthoball::ByteSink& sink) {
    write_persistence_plot<D>(sink, filtration, pairs, plot);
  });
}

void run(const PersistenceOptions& options) {
  require_other_file(options.input, options.output);
  check_plot("--plot", options.plot, options.output, options.input);
  if (!options.minimum_length.empty() &&
      !(alpha2_from_text("--minimum-length", options.minimum_length) >= 0.0)) {
    throw UsageError("--minimum-length: a length of lives is 0 or more");
  }
  const std::string format = format_of(options);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::pairing});
  const Loaded input = load(options.input, progress);
  progress.begin(Stage::pairing);
  std::size_t missing = 0;
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        if (options.dimension && *options.dimension >= D) {
          throw UsageError(fmt::format(
              "--homology-dimension {}: these points have classes of the dimensions 0 to {}",
              *options.dimension, D - 1));
        }
        require_memory(options.input, orthoball::persistence_memory(filtration.size(), options.all),
                       "the pairs");
        const auto pairs = chosen_pairs(options, filtration);
        if (!options.plot.empty()) write_plot(options, input, filtration, pairs);
        const auto values = options.indices ? orthoball::PersistenceValues::index
                                            : orthoball::PersistenceValues::alpha2;
        missing = write_output(options.output, format == "json" ? "null" : "",
                               [&](orthoball::ByteSink& sink) {
                                 if (format == "csv")
                                   write_persistence_csv<D>(sink, filtration, pairs, values);
                                 if (format == "json")
                                   write_persistence_json<D>(sink, filtration, pairs, values);
                                 if (format == "gudhi")
                                   write_persistence_gudhi<D>(sink, filtration, pairs, values);
                               });
      },
      input.shapes.filtration());
  progress.end();
  warn_of_missing(options.input, missing, format == "json" ? "null" : "an empty field");
}

void add_output_options(CLI::App& command, PersistenceOptions& options) {
  const std::string group = "Output";
  add_data_options(command, {options.output, options.format, options.json},
                   {"file, or - for standard output",
                    "csv, json or gudhi (lines \"2 dimension birth death\")\n"
                    "(default: by the name of -o, .pers for gudhi, else csv)",
                    {"csv", "json", "gudhi"}});
  auto* const plot =
      command.add_option("--plot", options.plot, "also draw them as SVG into this file")
          ->type_name("FILE")
          ->group(group);
  command.add_option("--plot-kind", options.plot_kind, "diagram or barcode")
      ->type_name("NAME")
      ->check(CLI::IsMember({"diagram", "barcode"}).description(""))
      ->capture_default_str()
      ->needs(plot)
      ->group(group);
  command
      .add_option("--plot-axis", options.plot_axis,
                  "what runs along the plot: alpha, alpha2 or index")
      ->type_name("NAME")
      ->check(CLI::IsMember({"alpha", "alpha2", "index"}).description(""))
      ->capture_default_str()
      ->needs(plot)
      ->group(group);
}

}  // namespace

void add_persistence_command(CLI::App& app) {
  auto options = std::make_shared<PersistenceOptions>();
  CLI::App* command = app.add_subcommand(
      "persistence", "Births and deaths of components, tunnels and voids, with a diagram.");
  const std::string group = "Pairs";
  command->add_option("--homology-dimension", options->dimension, "classes of this dimension only")
      ->type_name("K")
      ->check(whole_number(0, 2))
      ->group(group);
  command
      ->add_option("--minimum-length", options->minimum_length,
                   "only what lives so long: death less birth [length^2]")
      ->type_name("X")
      ->group(group);
  command
      ->add_flag("--all", options->all,
                 "also pairs whose birth and death are one index: all simplices are listed")
      ->group(group);
  command
      ->add_flag("--indices", options->indices,
                 "births and deaths as indices of the spectrum instead of alpha2")
      ->group(group);
  add_output_options(*command, *options);
  add_input_options(*command, options->input);
  command->footer(
      "Columns: dimension (0 components, 1 tunnels, in the plane holes, 2 voids); birth and death\n"
      "[length^2], alpha2 at which a class is there and is no more, death empty for never (null,\n"
      "inf in gudhi); birth_simplex and death_simplex, the rows of the simplices that close its\n"
      "first cycle and fill its last. Over Z/2, exact: equal values are one index of the "
      "spectrum.\n"
      "By dimension, then by birth. At every alpha2 as many classes live as the Betti numbers "
      "say.\n\n"
      "Examples:\n"
      "  orthoball persistence linked_tori.csv --minimum-length 0.1\n"
      "  orthoball persistence points.csv -o pairs.csv --plot diagram.svg\n"
      "  orthoball persistence 1ubq.pdb --homology-dimension 2 --plot bars.svg --plot-kind "
      "barcode\n"
      "  orthoball persistence points.csv -o diagram.pers");
  command->callback([options] { run(*options); });
}
