// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "orthoball/counted.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/signatures/notable_alphas.h"
#include "orthoball/signatures/signature.h"

namespace {

using Json = nlohmann::ordered_json;

struct SummaryOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string output = "-";
  std::string format;  // text, json; empty: from the name of the output
  bool json = false;
};

bool is_json(const SummaryOptions& options) {
  if (options.json) return true;
  return options.format.empty() ? ending_of(options.output) == "json" : options.format == "json";
}

// What both forms of the report say.
template <int D>
struct Facts {
  std::vector<std::uint32_t> simplices, attached;  // by dimension
  orthoball::Signature<D> hull;                    // of the last index
  std::vector<orthoball::NotableAlpha> notable;
  std::vector<ChosenAlpha> asked;
  std::vector<orthoball::Signature<D>> at;  // one for each that was asked for
};

template <int D>
Facts<D> facts(const orthoball::Filtration<D>& filtration, std::vector<ChosenAlpha> asked,
               orthoball::Threads threads) {
  Facts<D> facts;
  for (int d = 0; d <= D; ++d) {
    const std::uint32_t first = filtration.table().first(d);
    std::uint32_t attached = 0;
    for (std::uint32_t i = 0; i < filtration.count(d); ++i) {
      if (filtration.is_attached(orthoball::SimplexId(first + i))) ++attached;
    }
    facts.simplices.push_back(static_cast<std::uint32_t>(filtration.count(d)));
    facts.attached.push_back(attached);
  }
  std::vector<std::uint32_t> indices{filtration.spectrum_size()};
  for (const ChosenAlpha& alpha : asked) indices.push_back(alpha.index);
  facts.at = orthoball::signatures<D>(filtration, indices, threads);
  facts.hull = facts.at.front();
  facts.at.erase(facts.at.begin());
  for (std::size_t i = 0; i < asked.size(); ++i) facts.at[i].alpha2 = asked[i].alpha2;
  facts.asked = std::move(asked);
  facts.notable = orthoball::notable_alphas(filtration);
  return facts;
}

template <int D>
Json json_report(const Loaded& input, const orthoball::Filtration<D>& filtration,
                 const Facts<D>& facts, std::size_t& missing) {
  const auto& triangulation = filtration.triangulation();
  const std::uint32_t size = filtration.spectrum_size();
  const auto number = [&](double x) { return finite(x, missing); };
  Json json;
  json["input"] = input_json(input);
  json["dimension"] = D;
  json["affine_dimension"] = triangulation.affine_dimension();
  json["distinct_sites"] = triangulation.distinct_site_count();
  json["hidden"] = Json::array();
  for (const orthoball::SiteId row : triangulation.hidden()) json["hidden"].push_back(row.row());
  json["duplicates"] = Json::array();
  for (const orthoball::Duplicate& d : triangulation.duplicates()) {
    json["duplicates"].push_back({d.row.row(), d.representative.row()});
  }
  json["simplices"] = facts.simplices;
  json["attached"] = facts.attached;
  json["spectrum_size"] = size;
  json["alpha2_min"] = size == 0 ? Json() : number(filtration.alpha2(1));
  json["alpha2_max"] = size == 0 ? Json() : number(filtration.alpha2(size));
  json["hull_volume"] = number(facts.hull.volume);
  json["hull_area"] = number(facts.hull.area);
  json["notable"] = Json::array();
  for (const orthoball::NotableAlpha& notable : facts.notable) {
    Json entry{{"name", notable.name}, {"reason", notable.reason}};
    entry["index"] = notable.index ? Json(*notable.index) : Json();
    entry["alpha2"] = notable.index ? number(notable.alpha2) : Json();
    entry["alpha"] = notable.index ? number(notable.alpha) : Json();
    json["notable"].push_back(std::move(entry));
  }
  if (facts.at.empty()) return json;
  json["at"] = Json::array();
  for (std::size_t i = 0; i < facts.at.size(); ++i) {
    const auto& s = facts.at[i];
    const ChosenAlpha& asked = facts.asked[i];
    const bool has_alpha = !orthoball::is_of_empty_complex(s.index, s.alpha2);
    json["at"].push_back({{"name", asked.name.empty() ? Json() : Json(asked.name)},
                          {"index", s.index},
                          {"alpha2", has_alpha ? number(s.alpha2) : Json()},
                          {"alpha", has_alpha ? number(asked.alpha) : Json()},
                          {"betti", s.betti},
                          {"euler", s.euler},
                          {"volume", number(s.volume)},
                          {"area", number(s.area)},
                          {"length", D == 3 ? number(s.length) : Json()}});
  }
  return json;
}

// 7 of the rows at most, and how many there are.
template <class Rows, class Write>
std::string rows_text(const Rows& rows, const Write& write) {
  constexpr std::size_t kShown = 7;
  if (rows.empty()) return "none";
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(rows.size(), kShown); ++i) shown.push_back(write(rows[i]));
  return fmt::format("{} ({} {}{})", rows.size(), orthoball::noun_of(rows.size(), "row"),
                     joined(shown), rows.size() > kShown ? ", ..." : "");
}

// " CA of ALA 12 in A", as far as the file says; nothing for points.
std::string atom_text(const orthoball::SiteLabels& labels, std::size_t row) {
  const auto label = [&](const char* before, const std::vector<std::string>& of_row) {
    return row < of_row.size() && !of_row[row].empty() ? before + of_row[row] : std::string();
  };
  const std::string atom = label(" ", labels.atom);
  return (atom.empty() ? label(" ", labels.element) : atom) + label(" of ", labels.residue) +
         label(" ", labels.residue_id) + label(" in ", labels.chain);
}

// "4 vertices, 1 triangle": how many there are of each dimension.
std::string counts_text(std::span<const std::uint32_t> counts) {
  constexpr std::string_view kNouns[] = {"vertex", "edge", "triangle", "tetrahedron"};
  std::vector<std::string> words;
  for (std::size_t d = 0; d < counts.size(); ++d) {
    words.push_back(orthoball::counted(counts[d], kNouns[d]));
  }
  return joined(words);
}

std::string notable_text(const std::vector<orthoball::NotableAlpha>& notables) {
  std::string text = fmt::format("\n{:<23}{:>22} {:>22} {:>9}  {}\n", "notable alphas", "alpha2",
                                 "alpha", "index", "why");
  for (const orthoball::NotableAlpha& notable : notables) {
    const auto shown = [&](double x) { return notable.index ? number_text(x) : "-"; };
    text += fmt::format("  {:<21} {:>21} {:>22} {:>9}  {}\n", notable.name, shown(notable.alpha2),
                        shown(notable.alpha), notable.index ? std::to_string(*notable.index) : "-",
                        notable.reason);
  }
  return text;
}

template <int D>
std::string at_text(const Facts<D>& facts, const std::string& area_unit,
                    const std::string& volume_unit) {
  std::string text;
  for (std::size_t i = 0; i < facts.at.size(); ++i) {
    const auto& s = facts.at[i];
    text += "\nat " + text_of(facts.asked[i]) + "\n";
    text += report_line("  betti", betti_text(s.betti));
    text += report_line(D == 3 ? "  volume" : "  area", number_text(s.volume) + volume_unit);
    text += report_line(D == 3 ? "  area" : "  perimeter",
                        number_text(s.area) + area_unit + ", two-sided");
  }
  return text;
}

template <int D>
std::string text_report(const Loaded& input, const orthoball::Filtration<D>& filtration,
                        const Facts<D>& facts) {
  const auto& triangulation = filtration.triangulation();
  const std::uint32_t size = filtration.spectrum_size();
  const auto unit = [&](const char* power) {
    return input.reading.is_molecule ? " Å" + std::string(power) : "";
  };
  const std::string area_unit = unit(D == 3 ? "²" : ""), volume_unit = unit(D == 3 ? "³" : "²");

  std::string text = input_text(input);
  constexpr const char* kSpans[] = {"none", "a point", "a line", "a plane", "space"};
  if (triangulation.affine_dimension() < D) {
    text += report_line("the sites span", kSpans[triangulation.affine_dimension() + 1]);
  }
  text += report_line("distinct sites", fmt::format("{}", triangulation.distinct_site_count()));
  text += report_line("duplicates", rows_text(triangulation.duplicates(), [](const auto& d) {
                        return fmt::format("{} = {}", d.row.row(), d.representative.row());
                      }));
  text +=
      report_line("hidden", rows_text(triangulation.hidden(), [&](auto row) {
                    return std::to_string(row.row()) + atom_text(input.reading.labels, row.row());
                  }));
  text += report_line("simplices", counts_text(facts.simplices));
  text += report_line("attached", counts_text(std::span(facts.attached).first(D)));
  text += report_line("spectrum",
                      size == 0 ? std::string("empty: there are no sites")
                                : fmt::format("{} distinct alpha2 from {} to {}{}", size,
                                              number_text(filtration.alpha2(1)),
                                              number_text(filtration.alpha2(size)), unit("²")));
  text += report_line(D == 3 ? "hull volume" : "hull area",
                      number_text(facts.hull.volume) + volume_unit);
  text += report_line(D == 3 ? "hull area" : "hull perimeter",
                      number_text(facts.hull.area) + area_unit +
                          (triangulation.affine_dimension() < D ? ", two-sided" : ""));
  if (size > 0) text += notable_text(facts.notable);
  return text + at_text(facts, area_unit, volume_unit);
}

void run(const SummaryOptions& options) {
  require_other_file(options.input, options.output);
  check(options.alpha, true);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::signatures});
  const Loaded input = load(options.input, progress, false);
  progress.begin(Stage::signatures);
  std::size_t missing = 0;
  const std::string report = std::visit(
      [&]<int D>(const orthoball::Filtration<D>& filtration) {
        require_memory(options.input, orthoball::signature_memory(filtration.size()),
                       "the signatures");
        std::vector<ChosenAlpha> asked = chosen_alphas(options.alpha, input);
        say_how(options.input, asked);
        const Facts<D> known = facts(filtration, std::move(asked), threads_of(options.input));
        if (!is_json(options)) return text_report(input, filtration, known);
        return json_report_text(json_report(input, filtration, known, missing));
      },
      input.shapes.filtration());
  progress.end();
  write_output(options.output, "", [&](orthoball::ByteSink& sink) {
    sink.text(report);
    sink.flush();
  });
  warn_of_missing(options.input, missing, "null");
}

}  // namespace

void add_summary_command(CLI::App& app) {
  auto options = std::make_shared<SummaryOptions>();
  CLI::App* command = app.add_subcommand(
      "summary", "What was read, how many simplices there are, which alphas are notable.");
  add_alpha_options(*command, options->alpha, true, "none; with it, the shape there is measured");
  const std::string group = "Output";
  command->add_option("-o,--output", options->output, "file, or - for standard output")
      ->type_name("FILE")
      ->capture_default_str()
      ->group(group);
  auto* const format = command
                           ->add_option("--format", options->format,
                                        "text or json\n(default: by the name of -o, else text)")
                           ->type_name("NAME")
                           ->check(CLI::IsMember({"text", "json"}).description(""))
                           ->group(group);
  command->add_flag("--json", options->json, "the same as --format json")
      ->excludes(format)
      ->group(group);
  add_input_options(*command, options->input);
  command->footer(
      "Rows count from 0. Hidden sites have an empty power cell: their ball lies inside others;\n"
      "duplicates are equal to the row they name. Attached simplices enter with a coface.\n\n"
      "Examples:\n"
      "  orthoball summary 1crn.cif\n"
      "  orthoball summary 1ubq.pdb --waters keep --radii protor --json\n"
      "  orthoball summary trees.csv --columns x,y --radius-column crown");
  command->callback([options] { run(*options); });
}
