// SPDX-License-Identifier: MIT
#include "orthoball/filtration/alpha.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/data_options.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/query_memory.h"
#include "cli/report.h"
#include "orthoball/output/alpha_table.h"
#include "orthoball/queries/alpha_candidates.h"

namespace {

struct CandidateOptions {
  InputOptions input;
  unsigned resamples = 0;
  unsigned seed = 1;
  std::string output = "-";
  std::string format;  // text, csv, json; empty: from the name of the output
  bool json = false;
};

std::string format_of(const CandidateOptions& options) {
  if (options.json) return "json";
  if (!options.format.empty()) return options.format;
  const std::string ending = ending_of(options.output);
  return ending == "json" || ending == "csv" ? ending : "text";
}

template <int D>
std::string text_of_candidates(const orthoball::Filtration<D>& filtration,
                               const std::vector<orthoball::AlphaCandidate<D>>& candidates,
                               const std::vector<orthoball::AlphaSpread>& spreads,
                               unsigned resamples) {
  if (filtration.spectrum_size() == 0) return "there are no sites, and no alpha\n";
  const auto until = [&](std::uint32_t index) {
    return index == 0 || index >= filtration.never()
               ? std::string("the end")
               : number_text(orthoball::alpha_from_alpha2(filtration.alpha2(index)));
  };
  std::string text;
  std::size_t rank = 0;
  for (const auto& candidate : candidates) {
    const orthoball::NotableAlpha& alpha = candidate.alpha;
    ++rank;
    if (!alpha.index) {
      text += fmt::format("{:>2}  {}: none; {}\n", rank, alpha.name, alpha.reason);
      continue;
    }
    text += fmt::format("{:>2}  {}: {}\n", rank, alpha.name, alpha.reason);
    const std::string inverse =
        alpha.alpha != 0.0 ? ", 1/alpha " + number_text(1 / alpha.alpha) : "";
    text += report_line("    at",
                        fmt::format("alpha2 {}, alpha {}{}, index {}", number_text(alpha.alpha2),
                                    number_text(alpha.alpha), inverse, *alpha.index));
    text += report_line("    shape",
                        fmt::format("{}; {} {}, {} {}", betti_text(candidate.at.betti),
                                    D == 3 ? "volume" : "area", number_text(candidate.at.volume),
                                    D == 3 ? "area" : "perimeter", number_text(candidate.at.area)));
    if (candidate.stable_from > 0) {
      text +=
          report_line("    stable", fmt::format("from alpha {} to {}", until(candidate.stable_from),
                                                until(candidate.stable_to)));
    }
    if (spreads.empty()) continue;
    const orthoball::AlphaSpread& spread = spreads[rank - 1];
    text += report_line(
        "    resamples",
        spread.found == 0
            ? fmt::format("0 of {}", resamples)
            : fmt::format("{} of {}, {} with these numbers; alpha {}, half of them {} to {}",
                          spread.found, resamples, spread.same_betti, number_text(spread.median),
                          number_text(spread.low), number_text(spread.high)));
  }
  return text;
}

void run(const CandidateOptions& options) {
  require_other_file(options.input, options.output);
  const std::string format = format_of(options);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::signatures});
  const Loaded input = load(options.input, progress);
  progress.begin(Stage::signatures);
  std::size_t missing = 0;
  std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        require_memory(options.input, candidates_memory(D, filtration.size()),
                       "the candidates for alpha");
        const auto weights = meaning_of_weights(input);
        const auto threads = threads_of(options.input);
        const auto candidates = orthoball::alpha_candidates<D>(filtration, weights, threads);
        std::vector<orthoball::AlphaSpread> spreads;
        if (options.resamples > 0) {
          require_memory(
              options.input,
              resamples_memory(D, filtration.triangulation().site_count(), filtration.size()),
              "a resample");
          orthoball::ResampleOptions resampling;
          resampling.count = options.resamples;
          resampling.seed = options.seed;
          spreads = orthoball::alpha_spreads<D>(input.shapes.points(), candidates, weights,
                                                resampling, threads);
        }
        missing = write_output(
            options.output, format == "json" ? "null" : "", [&](orthoball::ByteSink& sink) {
              if (format == "text") {
                sink.text(
                    text_of_candidates<D>(filtration, candidates, spreads, options.resamples));
                return sink.flush();
              }
              const auto table =
                  format == "json" ? orthoball::TableFormat::json : orthoball::TableFormat::csv;
              write_alpha_candidates<D>(sink, table, filtration, candidates, spreads);
            });
      },
      input.shapes.filtration());
  progress.end();
  warn_of_missing(options.input, missing, format == "json" ? "null" : "an empty field");
}

}  // namespace

void add_alpha_command(CLI::App& app) {
  auto options = std::make_shared<CandidateOptions>();
  CLI::App* command =
      app.add_subcommand("alpha", "Which alpha to take: candidates, the most stable first.");
  const std::string group = "Candidates";
  command
      ->add_option("--resamples", options->resamples,
                   "find all again in so many random parts of 4/5 of the sites")
      ->type_name("N")
      ->check(whole_number(0, 100000))
      ->group(group);
  command->add_option("--seed", options->seed, "of these parts")
      ->type_name("N")
      ->check(whole_number(0, 4294967295U))
      ->capture_default_str()
      ->group(group);
  add_data_options(*command, {options->output, options->format, options->json},
                   {"file, or - for standard output",
                    "text, csv or json\n(default: by the name of -o, else text)",
                    {"text", "csv", "json"}});
  add_input_options(*command, options->input);
  command->footer(
      "Candidates are the notable alphas of summary, and these:\n"
      "  signature          the Betti numbers, taken together, that last longest, with all\n"
      "                     points in and no more components than half of them\n"
      "  plateau_1 to _3    the volume grows by no more than 5 % around it\n"
      "  spectrum_gap       no simplex enters for longest\n"
      "  manifold           first closed manifold with every vertex in cells, nothing singular\n"
      "  dual_complex, probe  of molecules: alpha2 0, and alpha 1.4, a water molecule's radius\n"
      "Every command takes them by name: --alpha2 auto:signature.\n\n"
      "Ranks are by stability: by which ratio the radius of the largest ball grows while the\n"
      "Betti numbers stay as they are; 2 for a stretch without an end. With --resamples, in how\n"
      "many parts there is such an alpha, in how many with the same Betti numbers, and the\n"
      "quartiles of alpha there.\n\n"
      "Examples:\n"
      "  orthoball alpha linked_tori.csv\n"
      "  orthoball alpha scan.ply --resamples 20 -o candidates.csv\n"
      "  orthoball shape linked_tori.csv --alpha2 auto:signature -o tori.ply");
  command->callback([options] { run(*options); });
}
