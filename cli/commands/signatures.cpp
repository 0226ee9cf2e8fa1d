// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/alpha_number.h"
#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/signature_picture.h"
#include "cli/usage_error.h"
#include "orthoball/filtration/alpha.h"
#include "orthoball/output/ball_signature_tables.h"
#include "orthoball/output/signature_table.h"
#include "orthoball/signatures/ball_signature.h"
#include "orthoball/signatures/signature.h"

namespace {

struct SignaturesOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::optional<std::uint32_t> samples;
  bool balls = false;
  std::string output = "-";
  std::string format;  // csv, json, npz; empty: from the name of the output
  bool json = false;
  std::string plot;
  std::string plot_axis = "alpha";
  std::string plot_range;
};

std::string format_of(const SignaturesOptions& options) {
  if (options.json) return "json";
  if (!options.format.empty()) return options.format;
  const std::string ending = ending_of(options.output);
  return ending == "npz" || ending == "json" ? ending : "csv";
}

orthoball::SignatureFormat signature_format(const std::string& name) {
  return name == "csv"    ? orthoball::SignatureFormat::csv
         : name == "json" ? orthoball::SignatureFormat::json
                          : orthoball::SignatureFormat::npz;
}

// The values asked for: from the options, or N indices spread evenly over the spectrum with both
// ends. None: every index.
std::vector<ChosenAlpha> asked_for(const SignaturesOptions& options, const Loaded& input,
                                   std::uint32_t spectrum_size) {
  constexpr std::uint32_t kSamplesOfBalls = 100;
  std::vector<ChosenAlpha> asked = chosen_alphas(options.alpha, input);
  const bool samples_balls = options.balls && !options.alpha.is_given();
  if (!options.samples && !samples_balls) return asked;
  const std::uint32_t count = std::min(options.samples.value_or(kSamplesOfBalls), spectrum_size);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint64_t index =
        count == 1 ? spectrum_size
                   : 1 + (std::uint64_t{i} * (spectrum_size - 1) + (count - 1) / 2) / (count - 1);
    asked.push_back(alpha_at(input, static_cast<std::uint32_t>(index)));
  }
  return asked;
}

std::optional<std::pair<double, double>> range_from_text(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto ends = CLI::detail::split(text, ',');
  if (ends.size() != 2) throw UsageError("--plot-range: two numbers FROM,TO are needed");
  const std::pair range(alpha2_from_text("--plot-range", ends[0]),
                        alpha2_from_text("--plot-range", ends[1]));
  if (range.first >= range.second) throw UsageError("--plot-range: FROM must be less than TO");
  return range;
}

orthoball::PlotOptions plot_of(const SignaturesOptions& options, const Loaded& input) {
  orthoball::PlotOptions plot = plot_options(options.input, input);
  plot.axis = plot_axis(options.plot_axis);
  plot.range = range_from_text(options.plot_range);
  return plot;
}

template <int D>
void write_table(const SignaturesOptions& options, const Loaded& input, Progress& progress,
                 const orthoball::Filtration<D>& filtration) {
  const bool is_complete = !options.alpha.is_given() && !options.samples;
  const std::vector<ChosenAlpha> asked = asked_for(options, input, filtration.spectrum_size());
  say_how(options.input, asked);
  const std::string format = format_of(options);
  if (format == "npz" && is_complete) {
    require_memory(options.input,
                   sizeof(orthoball::SignatureRow<D>) * std::uint64_t{filtration.spectrum_size()},
                   "the table");
  }
  const std::size_t missing =
      write_output(options.output, format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
        orthoball::SignatureTable<D> table(sink, signature_format(format));
        if (is_complete) {
          orthoball::scan_signatures<D>(
              filtration,
              [&](const orthoball::Signature<D>& s) {
                table.add({s, orthoball::alpha_from_alpha2(s.alpha2)});
                progress.reach(s.index, filtration.spectrum_size());
              },
              threads_of(options.input));
        } else {
          std::vector<std::uint32_t> indices;
          for (const ChosenAlpha& alpha : asked) indices.push_back(alpha.index);
          auto signatures =
              orthoball::signatures<D>(filtration, indices, threads_of(options.input));
          for (std::size_t i = 0; i < asked.size(); ++i) {
            signatures[i].alpha2 = asked[i].alpha2;
            table.add({signatures[i], asked[i].alpha});
          }
        }
        table.finish();
      });
  warn_of_missing(options.input, missing, format == "json" ? "null" : "an empty field");
}

// Unions of balls take as long as their boundaries are large, each: some alphas are wanted, not
// all.
template <int D>
void write_balls_table(const SignaturesOptions& options, const Loaded& input,
                       const orthoball::Filtration<D>& filtration) {
  const std::vector<ChosenAlpha> asked = asked_for(options, input, filtration.spectrum_size());
  say_how(options.input, asked);
  std::vector<orthoball::BallAlpha> alphas;
  for (const ChosenAlpha& alpha : asked) alphas.push_back({alpha.index, alpha.alpha2});
  const auto signatures =
      orthoball::ball_signatures<D>(filtration, alphas, threads_of(options.input));
  std::vector<orthoball::BallSignatureRow<D>> rows;
  for (std::size_t i = 0; i < asked.size(); ++i) rows.push_back({signatures[i], asked[i].alpha});
  const std::string format = format_of(options);
  const std::size_t missing =
      write_output(options.output, format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
        if (format == "csv") write_ball_signatures_csv(sink, rows);
        if (format == "json") write_ball_signatures_json(sink, rows);
        if (format == "npz") write_ball_signatures_npz(sink, rows);
      });
  warn_of_missing(options.input, missing, format == "json" ? "null" : "an empty field");
}

void run(const SignaturesOptions& options) {
  if (options.samples && options.alpha.is_given()) {
    throw UsageError(
        "--samples spreads values over the spectrum; it excludes --alpha2, --alpha, "
        "--inverse-alpha and --index");
  }
  if (options.balls && !options.plot.empty()) {
    throw UsageError("--balls excludes --plot, which draws the signatures of the alpha shapes");
  }
  check_plot("--plot", options.plot, options.output, options.input);
  require_other_file(options.input, options.output);
  check(options.alpha, true);
  (void)range_from_text(options.plot_range);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::signatures});
  const Loaded input = load(options.input, progress);
  progress.begin(Stage::signatures);
  std::visit(
      [&](const auto& filtration) {
        require_memory(options.input, orthoball::signature_memory(filtration.size()),
                       "the signatures");
        if (options.balls) return write_balls_table(options, input, filtration);
        if (!options.plot.empty()) {
          write_signature_picture(options.plot, options.input, filtration, plot_of(options, input));
        }
        write_table(options, input, progress, filtration);
      },
      input.shapes.filtration());
  progress.end();
}

void add_output_options(CLI::App& command, SignaturesOptions& options) {
  const std::string group = "Output";
  add_data_options(command, {options.output, options.format, options.json},
                   {"file, or - for standard output",
                    "csv, json or npz (NumPy)\n"
                    "(default: by the name of -o, else csv)",
                    {"csv", "json", "npz"}});
  auto* const plot = add_plot_option(command, options.plot, "all signatures");
  add_plot_axis_option(command, options.plot_axis, plot);
  command
      .add_option("--plot-range", options.plot_range,
                  "ends of that axis (default: every change of the topology, but at most 15\n"
                  "times the stretch in which 4/5 of the triangles or tetrahedra enter)")
      ->type_name("FROM,TO")
      ->needs(plot)
      ->group(group);
}

}  // namespace

void add_signatures_command(CLI::App& app) {
  auto options = std::make_shared<SignaturesOptions>();
  CLI::App* command = app.add_subcommand(
      "signatures", "Betti numbers, counts by role, volume, area and length at every alpha.");
  add_alpha_options(*command, options->alpha, true, "every index of the spectrum");
  command
      ->add_option("--samples", options->samples,
                   "N indices spread evenly over the spectrum, with both ends")
      ->type_name("N")
      ->check(whole_number(1, std::numeric_limits<std::uint32_t>::max()))
      ->group("Alpha");
  command
      ->add_flag("--balls", options->balls,
                 "of unions of balls of squared radius weight + alpha2 instead of shapes:\n"
                 "volume, area, Betti and Euler numbers; without any alpha at 100 samples")
      ->group("Balls");
  add_output_options(*command, *options);
  add_input_options(*command, options->input);
  command->footer(
      "Columns: index; alpha2 [length^2]; alpha [length]; betti_0.. (components, tunnels, voids);\n"
      "euler; exterior_k, singular_k, regular_k, interior_k: simplices of dimension k by role;\n"
      "volume [length^3]; area_singular, area_regular, one-sided, and area, two-sided [length^2];\n"
      "length [length]: 4 pi times the mean width. In the plane volume is the area of the\n"
      "triangles, area the two-sided perimeter, and length is empty. An alpha2 counts as\n"
      "reached: the complex at the index of the last entry that is not greater.\n"
      "With --balls: index, alpha2, alpha, betti_0.., euler, volume and area (in the plane area "
      "and\n"
      "perimeter) of the union.\n\n"
      "Examples:\n"
      "  orthoball signatures 1ubq.pdb -o ubiquitin.csv --plot ubiquitin.svg\n"
      "  orthoball signatures points.csv --alpha2 0.5,1,2 --json\n"
      "  orthoball signatures bunny.off --samples 200 -o bunny.npz\n"
      "  orthoball signatures 1ubq.pdb --balls --alpha2 0,1,2,4");
  command->callback([options] { run(*options); });
}
