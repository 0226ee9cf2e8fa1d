// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/input/simplex_rows.h"
#include "orthoball/output/points_table.h"
#include "orthoball/weights/added_sites.h"
#include "orthoball/weights/enforced_weights.h"
#include "orthoball/weights/reweighted_points.h"

namespace {

struct EnforceOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string simplices;
  std::string output = "-";
  bool add_sites = false;
};

// "line 3 (0 5 7)"
std::string name_of(const orthoball::SimplexList& list, std::size_t simplex) {
  std::vector<std::uint32_t> rows;
  for (const orthoball::SiteId row : list.rows[simplex]) rows.push_back(row.row());
  return fmt::format("line {} ({})", list.line[simplex], fmt::join(rows, " "));
}

// What the weights are to hold: the simplices as they are listed, or the parts that added sites
// make of them.
struct Wanted {
  orthoball::AddedSites sites;
  double alpha2;
};

orthoball::EnforcedWeights enforced(const EnforceOptions& options,
                                    const orthoball::SimplexList& list, const Wanted& wanted) {
  const auto& [points, added, simplices, part_of] = wanted.sites;
  try {
    return orthoball::enforced_weights(points, simplices, wanted.alpha2, threads_of(options.input),
                                       added);
  } catch (const orthoball::InputError& error) {
    const std::string message = error.what();  // "simplex 0: what is wrong"
    throw orthoball::ParseError(options.simplices, list.line[part_of[error.row()]],
                                message.substr(message.find(": ") + 2));
  }
}

[[noreturn]] void refuse(const EnforceOptions& options, const orthoball::SimplexList& list,
                         const std::vector<std::size_t>& conflict) {
  std::vector<std::string> names;
  for (const std::size_t simplex : conflict) names.push_back(name_of(list, simplex));
  throw orthoball::ParseError(
      options.simplices, list.line[conflict[0]],
      fmt::format("no weights hold these simplices together: {}; leave out one of them, or "
                  "--add-sites",
                  joined(names)));
}

// Of each simplex that is held in parts for rows that are not added lie on it.
void say_cut(const EnforceOptions& options, const orthoball::SimplexList& list,
             const orthoball::AddedSites& sites) {
  std::vector<std::set<std::uint32_t>> cuts(list.rows.size());
  for (std::size_t part = 0; part < sites.simplices.size(); ++part) {
    const auto& whole = list.rows[sites.part_of[part]];
    for (const orthoball::SiteId row : sites.simplices[part]) {
      const bool is_given = row.row() < sites.points.size() - sites.added;
      if (is_given && !std::binary_search(whole.begin(), whole.end(), row)) {
        cuts[sites.part_of[part]].insert(row.row());
      }
    }
  }
  for (std::size_t simplex = 0; simplex < cuts.size(); ++simplex) {
    if (cuts[simplex].empty()) continue;
    say(options.input, fmt::format("{} is held in parts, cut at {} {}", name_of(list, simplex),
                                   orthoball::noun_of(cuts[simplex].size(), "row"),
                                   fmt::join(cuts[simplex], ", ")));
  }
}

// "12 (0.5 1) on line 1 (0 2), line 3 (1 4)" for each added row.
void say_added(const EnforceOptions& options, const orthoball::SimplexList& list,
               const orthoball::AddedSites& sites) {
  if (!options.add_sites) return;
  say(options.input, fmt::format("{} added", orthoball::counted(sites.added, "site")));
  for (std::size_t row = sites.points.size() - sites.added; row < sites.points.size(); ++row) {
    std::set<std::size_t> on;
    for (std::size_t part = 0; part < sites.simplices.size(); ++part) {
      const auto& rows = sites.simplices[part];
      const orthoball::SiteId id(static_cast<std::uint32_t>(row));
      if (std::binary_search(rows.begin(), rows.end(), id)) on.insert(sites.part_of[part]);
    }
    std::vector<std::string> names;
    for (const std::size_t simplex : on) names.push_back(name_of(list, simplex));
    std::vector<std::string> place;
    for (int axis = 0; axis < sites.points.dimension(); ++axis) {
      place.push_back(number_text(sites.points.coordinate(row, axis)));
    }
    say(options.input, fmt::format("row {} ({}) on {}", row, fmt::join(place, " "), joined(names)));
  }
}

void say_report(const EnforceOptions& options, const orthoball::SimplexList& list,
                const Wanted& wanted, const orthoball::EnforcedWeights& weights) {
  const std::size_t count = list.rows.size();
  const std::size_t given = wanted.sites.points.size() - wanted.sites.added;
  say(options.input,
      fmt::format("{} held at alpha2 {}: {} of {} changed, by {} in total",
                  count == 1 ? "1 simplex" : fmt::format("{} simplices", count),
                  number_text(wanted.alpha2), weights.changed.size(),
                  orthoball::counted(given, "weight"), number_text(weights.total_change)));
  say_added(options, list, wanted.sites);
  say_cut(options, list, wanted.sites);
  if (weights.hidden.empty()) return;
  std::vector<std::uint32_t> rows;
  for (const orthoball::SiteId row : weights.hidden) rows.push_back(row.row());
  constexpr std::size_t kMostNamed = 10;
  const std::size_t named = std::min(rows.size(), kMostNamed);
  std::string text =
      fmt::format("warning: {} hidden now: {}", rows.size() == 1 ? "this row is" : "these rows are",
                  fmt::join(std::span(rows).first(named), ", "));
  if (named < rows.size()) text += fmt::format(" and {} more", rows.size() - named);
  say(options.input, text);
}

double alpha2_of(const EnforceOptions& options, const Loaded& input) {
  const auto given = chosen_alphas(options.alpha, input);
  say_how(options.input, given);
  return given.empty() ? 0.0 : given[0].alpha2;
}

void run(const EnforceOptions& options) {
  require_other_file(options.input, options.output);
  if (options.simplices != "-" && is_same_output(options.simplices, options.output)) {
    throw UsageError(options.output +
                     ": holds the simplices, which the output would replace; name another file");
  }
  if (options.simplices == "-" && options.input.path == "-") {
    throw UsageError("enforce: standard input can be the points or the simplices, not both");
  }
  check(options.alpha, false);
  if (!options.alpha.index.empty()) {
    throw UsageError(
        "enforce --index: the spectrum changes with the weights; give --alpha2 or --alpha");
  }
  Progress progress(
      options.input.progress, options.input.quiet,
      {Stage::reading, Stage::triangulation, Stage::filtration, Stage::finding_weights});
  const Loaded input = load(options.input, progress);
  // What will be read back, so that what is verified is what is written.
  const orthoball::WeightedPoints points = orthoball::as_written(input.shapes.points());
  const orthoball::SimplexList list =
      orthoball::read_simplices(options.simplices, points.dimension(), points.size(),
                                !options.input.no_limit, memory_of(options.input));
  Wanted wanted{{points, 0, list.rows, {}}, alpha2_of(options, input)};
  for (std::size_t i = 0; i < list.rows.size(); ++i) wanted.sites.part_of.push_back(i);
  progress.begin(Stage::finding_weights);
  orthoball::EnforcedWeights weights = enforced(options, list, wanted);
  if (!weights.conflict.empty() && !options.add_sites) refuse(options, list, weights.conflict);
  if (!weights.conflict.empty()) {
    wanted.sites = orthoball::with_added_sites(points, list.rows);
    weights = enforced(options, list, wanted);
    if (!weights.conflict.empty()) {
      throw orthoball::LimitError(options.simplices +
                                  ": the added sites do not yet let weights hold "
                                  "the simplices");
    }
  }
  progress.end();
  // With a column of weights also where nothing had to change.
  const orthoball::WeightedPoints weighted = orthoball::reweighted(weights.points, 0, {});
  write_output(options.output, "",
               [&](orthoball::ByteSink& sink) { write_points_csv(sink, weighted); });
  say_report(options, list, wanted, weights);
}

}  // namespace

void add_enforce_command(CLI::App& app) {
  auto options = std::make_shared<EnforceOptions>();
  CLI::App* command = app.add_subcommand(
      "enforce", "Weights with which given simplices are in the shape at one alpha.");
  add_input_options(*command, options->input);
  command
      ->add_option("SIMPLICES", options->simplices,
                   "file of simplices, one a line: rows of INPUT, from 0, of an edge, a\n"
                   "triangle or a tetrahedron; # begins a comment")
      ->required()
      ->type_name("")
      ->option_text(" ");
  add_alpha_options(*command, options->alpha, false, "0");
  command->add_option("-o,--output", options->output, "CSV file, or - for standard output")
      ->type_name("FILE")
      ->capture_default_str()
      ->group("Output");
  command
      ->add_flag("--add-sites", options->add_sites,
                 "where simplices exclude each other, add sites on them, as few as are\n"
                 "found to do: the rows after those of INPUT; the parts between them are\n"
                 "held")
      ->group("Output");
  command->footer(
      "Writes INPUT as a table with a column of weights (of radii where the numbers are doubles "
      "and\n"
      "have some). Every command reads it exactly, with --weight-column weight (--radius-column\n"
      "radius). With these weights every simplex of SIMPLICES is in the alpha complex at that "
      "alpha,\n"
      "alone or as the face of a larger one: this is verified exactly. The total change of weights "
      "is\n"
      "about the least that does it, and coordinates stay. Points whose weight falls may become\n"
      "hidden, and those inside a given simplex must.\n\n"
      "Simplices that no weights hold together, such as edges that cross, are named (status 1), "
      "unless\n"
      "--add-sites cuts them where they meet.\n\n"
      "Examples:\n"
      "  orthoball enforce points.csv edges.txt --alpha2 0.04 -o weighted.csv\n"
      "  orthoball shape weighted.csv --weight-column weight --alpha2 0.04 -o shape.ply");
  command->callback([options] { run(*options); });
}
