// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "cli/alpha_options.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/output_file.h"
#include "cli/signature_picture.h"
#include "cli/usage_error.h"
#include "orthoball/output/union_figure.h"

namespace {

struct FigureOptions {
  InputOptions input;
  AlphaOptions alpha;
  std::string output = "-";
  std::string panels = "disks,cells,complex";
  std::string style = "colour";
  std::string title;  // empty: the name of the input
  unsigned width = 400;
  bool no_legend = false;
  std::string plot;
};

constexpr std::array<const char*, 3> kPanels{"disks", "cells", "complex"};

std::vector<orthoball::FigurePanel> panels_of(const std::string& text) {
  std::vector<orthoball::FigurePanel> panels;
  for (const std::string& name : CLI::detail::split(text, ',')) {
    const auto* const found = std::find(kPanels.begin(), kPanels.end(), name);
    if (found == kPanels.end()) {
      throw UsageError(fmt::format(
          "--panels: there is no panel \"{}\"; there are disks, cells and complex, with commas "
          "between them",
          name));
    }
    panels.push_back(static_cast<orthoball::FigurePanel>(found - kPanels.begin()));
  }
  return panels;
}

// Disks as they are where the points have weights, else the alpha that is worth looking at first.
ChosenAlpha chosen_alpha(const FigureOptions& options, const Loaded& input) {
  const auto given = chosen_alphas(options.alpha, input);
  if (!given.empty()) return given[0];
  if (input.shapes.points().weight_kind() == orthoball::WeightKind::none) {
    return automatic_alpha(input);
  }
  AlphaOptions zero;
  zero.alpha2 = "0";
  return chosen_alphas(zero, input)[0];
}

void run(const FigureOptions& options) {
  const auto panels = panels_of(options.panels);
  require_other_file(options.input, options.output);
  require_svg("-o", options.output);
  check_plot("--plot", options.plot, options.output, options.input);
  check(options.alpha, false);
  Progress progress(options.input.progress, options.input.quiet,
                    {Stage::reading, Stage::triangulation, Stage::filtration, Stage::signatures});
  const Loaded input = load(options.input, progress);
  const auto* const plane = std::get_if<orthoball::Filtration<2>>(&input.shapes.filtration());
  if (plane == nullptr) {
    throw UsageError(
        "figure draws disks in the plane, and these points are in space; \"orthoball shape\" "
        "writes "
        "their surface, \"orthoball signatures --plot\" draws their signatures");
  }
  const ChosenAlpha alpha = chosen_alpha(options, input);
  say_how(options.input, {alpha});
  progress.begin(Stage::signatures);
  if (!options.plot.empty()) {
    orthoball::PlotOptions plot = plot_options(options.input, input);
    plot.marks.push_back({"figure", alpha.index, alpha.alpha2});
    write_signature_picture<2>(options.plot, options.input, *plane, std::move(plot));
  }
  orthoball::UnionFigureOptions figure;
  figure.index = alpha.index;
  figure.alpha2 = alpha.alpha2;
  figure.panels = panels;
  figure.style =
      options.style == "print" ? orthoball::FigureStyle::print : orthoball::FigureStyle::colour;
  figure.panel_width = options.width;
  figure.legend = !options.no_legend;
  figure.title = options.title.empty() ? name_of(options.input) : options.title;
  figure.unit = input.unit();
  write_output(options.output, "0", [&](orthoball::ByteSink& sink) {
    write_union_figure(sink, *plane, input.shapes.points(), figure);
  });
  progress.end();
}

}  // namespace

void add_figure_command(CLI::App& app) {
  auto options = std::make_shared<FigureOptions>();
  CLI::App* command = app.add_subcommand(
      "figure", "Disks in the plane, their parts and their dual complex, as a picture.");
  add_alpha_options(*command, options->alpha, false, "0 for points with weights, otherwise auto");
  const std::string output = "Output", look = "Look";
  command->add_option("-o,--output", options->output, "SVG file, or - for standard output")
      ->type_name("FILE")
      ->capture_default_str()
      ->group(output);
  command
      ->add_option("--plot", options->plot,
                   "also draw all signatures as SVG into this file, the figure's alpha\nmarked")
      ->type_name("FILE")
      ->group(output);
  command
      ->add_option("--panels", options->panels,
                   "which pictures stand side by side, in this order\n")
      ->type_name("NAME[,NAME...]")
      ->capture_default_str()
      ->group(look);
  command->add_option("--style", options->style, "colour, or print: black, white and grey")
      ->type_name("NAME")
      ->check(CLI::IsMember({"colour", "print"}).description(""))
      ->capture_default_str()
      ->group(look);
  command->add_option("--width", options->width, "of each panel, in pixels")
      ->type_name("N")
      ->check(whole_number(50, 20000))
      ->capture_default_str()
      ->group(look);
  command->add_option("--title", options->title, "above the panels (default: the name of INPUT)")
      ->type_name("TEXT")
      ->group(look);
  command
      ->add_flag("--no-legend", options->no_legend, "the panels alone, without words around them")
      ->group(look);
  add_input_options(*command, options->input);
  command->footer(
      "The disks have the squared radii weight + alpha2; imaginary ones are empty. Panels:\n"
      "  disks    every disk, their union and its outline\n"
      "  cells    the union in parts: each disk cut by its power cell\n"
      "  complex  the dual complex: two disks whose parts meet have an edge, three a triangle;\n"
      "           singular edges and vertices border no triangle\n"
      "Circles are exact arcs, which stay sharp at any size.\n\n"
      "Examples:\n"
      "  orthoball figure trees.csv --columns x,y --radius-column crown -o trees.svg\n"
      "  orthoball figure points.csv --alpha 2 --panels complex --no-legend -o complex.svg\n"
      "  orthoball figure points.csv --style print --plot signatures.svg -o figure.svg");
  command->callback([options] { run(*options); });
}
