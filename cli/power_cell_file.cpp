// SPDX-License-Identifier: MIT
#include "cli/power_cell_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "cli/alpha_number.h"
#include "cli/named_outputs.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/output/power_cell_files.h"

namespace {

std::vector<double> numbers(const std::string& option, const std::string& text) {
  std::vector<double> result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    result.push_back(alpha2_from_text(option, text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return result;
}

double tolerance_of(const PowerCellFile& file) {
  constexpr double kLeastTolerance = orthoball::PowerCellOptions::kLeastTolerance;
  constexpr double kLargestTolerance = orthoball::PowerCellOptions::kLargestTolerance;
  const double tolerance = alpha2_from_text("--cells-tolerance", file.tolerance);
  if (!(tolerance >= kLeastTolerance && tolerance <= kLargestTolerance)) {
    throw UsageError(fmt::format("--cells-tolerance: {} is not from {} to {}", file.tolerance,
                                 kLeastTolerance, kLargestTolerance));
  }
  return tolerance;
}

// The box as typed.
template <int D>
orthoball::Box<D> typed_box(const std::string& text) {
  const std::vector<double> typed = numbers("--cells-box", text);
  if (typed.size() != 2 * std::size_t{D}) {
    throw UsageError(fmt::format("--cells-box: {} numbers; in {} it takes {}: {}", typed.size(),
                                 D == 3 ? "space" : "the plane", 2 * D,
                                 D == 3 ? "X,Y,Z of the lower corner, then of the upper one"
                                        : "X,Y of the lower corner, then of the upper one"));
  }
  orthoball::Box<D> box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.lower[axis] = typed[axis];
    box.upper[axis] = typed[axis + D];
    if (!(box.lower[axis] < box.upper[axis])) {
      throw UsageError(fmt::format("--cells-box: {} from {} to {}; the first must be the smaller",
                                   "xyz"[axis], number_text(box.lower[axis]),
                                   number_text(box.upper[axis])));
    }
  }
  return box;
}

// "-1,-1,2,2", as --cells-box takes it.
template <int D>
std::string box_text(const orthoball::Box<D>& box) {
  std::vector<std::string> words;
  for (const double x : box.lower) words.push_back(orthoball::shortest_text(x));
  for (const double x : box.upper) words.push_back(orthoball::shortest_text(x));
  return fmt::format("{}", fmt::join(words, ","));
}

// "power cells of 1ubq.pdb with a probe of 1.4, within the balls at alpha2 0, index 7"
std::string title_of(const PowerCellFile& file, const Loaded& input, const ChosenBalls& chosen,
                     const std::string& box) {
  const std::string probe =
      chosen.probe.nearest > 0.0 ? " with a probe of " + number_text(chosen.probe.nearest) : "";
  const std::string within =
      file.is_within_balls()
          ? "the balls at " + orthoball::alpha_text(chosen.at.alpha2, chosen.at.index)
          : "the box " + box;
  std::string title =
      fmt::format("power cells of {}{}, within {}",
                  std::filesystem::path(input.reading.file).filename().string(), probe, within);
  std::replace_if(
      title.begin(), title.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return title;
}

// For a site, of the cells and of a file that is written at once.
std::uint64_t bytes_for_site(const PowerCellFile& file, int dimension, double tolerance) {
  const std::string ending = ending_of(file.path);
  if (ending == "csv" || ending == "json") return 300;
  const double facets = dimension == 3 ? 45.0 : 10.0;
  const double on_sphere = !file.is_within_balls() ? 0.0
                           : dimension == 3        ? 4.0 / tolerance
                                                   : 3.0 / std::sqrt(tolerance);
  return static_cast<std::uint64_t>((facets + on_sphere) * (dimension == 3 ? 100.0 : 80.0));
}

}  // namespace

void add_power_cell_options(CLI::App& command, PowerCellFile& file, const std::string& group) {
  auto* const cells =
      command
          .add_option("--cells", file.path,
                      "the power cells; FILE ends in .csv or .json (their\nvolumes), .vtu or .obj")
          ->type_name("FILE")
          ->group(group);
  command.add_option("--cells-within", file.within, "what power cells are cut by: box or balls")
      ->type_name("NAME")
      ->check(CLI::IsMember({"box", "balls"}).description(""))
      ->capture_default_str()
      ->needs(cells)
      ->group(group);
  command
      .add_option("--cells-box", file.box,
                  "lower corner, then upper corner of the box [length]:\n"
                  "X,Y,Z,X,Y,Z, in the plane X,Y,X,Y\n"
                  "(default: around all balls, moved out by a tenth)")
      ->type_name("LIST")
      ->needs(cells)
      ->group(group);
  command
      .add_option("--cells-tolerance", file.tolerance,
                  "how far surfaces in .vtu and .obj may be from spheres,\nas a share of radii")
      ->type_name("T")
      ->capture_default_str()
      ->needs(cells)
      ->group(group);
}

void check_power_cells(const PowerCellFile& file, int dimension) {
  if (file.path.empty()) return;
  (void)tolerance_of(file);
  if (file.box.empty()) return;
  if (file.is_within_balls()) {
    throw UsageError("--cells-box: there is no box with --cells-within balls");
  }
  dimension == 3 ? void(typed_box<3>(file.box)) : void(typed_box<2>(file.box));
}

template <int D>
void write_power_cells(const PowerCellFile& file, const InputOptions& options, const Loaded& input,
                       const ChosenBalls& chosen, const orthoball::Filtration<D>& filtration,
                       const orthoball::UnionOfBalls& balls, MissingNumbers& missing) {
  if (file.path.empty()) return;
  const std::string ending = ending_of(file.path);
  const bool is_table = ending == "csv" || ending == "json";
  const double tolerance = tolerance_of(file);
  require_memory(options, bytes_for_site(file, D, tolerance) * filtration.count(0),
                 "the power cells");
  const orthoball::PowerCellOptions wanted{!is_table, tolerance, threads_of(options)};
  std::vector<orthoball::PowerCell<D>> cells;
  std::string box_words;
  if (file.is_within_balls()) {
    cells = power_cells_in_balls(filtration, balls, wanted);
  } else {
    const orthoball::Box<D> box = file.box.empty()
                                      ? orthoball::box_around(filtration, chosen.at.alpha2)
                                      : typed_box<D>(file.box);
    cells = power_cells(filtration, box, wanted);
    box_words = box_text(box);
    if (file.box.empty()) say(options, "power cells end at the box " + box_words);
  }
  const std::span<const orthoball::PowerCell<D>> all(cells);
  if (is_table) {
    write_table(file.path, missing, [&](orthoball::ByteSink& sink, orthoball::TableFormat format) {
      orthoball::write_power_cells<D>(sink, format, all, input.shapes.points().size(),
                                      input.reading.labels);
    });
    return;
  }
  missing.empty_fields += write_output(file.path, "", [&](orthoball::ByteSink& sink) {
    if (ending == "vtu") {
      write_power_cells_vtu<D>(sink, all);
    } else {
      write_power_cells_obj<D>(sink, all, title_of(file, input, chosen, box_words));
    }
  });
}

template void write_power_cells<2>(const PowerCellFile&, const InputOptions&, const Loaded&,
                                   const ChosenBalls&, const orthoball::Filtration<2>&,
                                   const orthoball::UnionOfBalls&, MissingNumbers&);
template void write_power_cells<3>(const PowerCellFile&, const InputOptions&, const Loaded&,
                                   const ChosenBalls&, const orthoball::Filtration<3>&,
                                   const orthoball::UnionOfBalls&, MissingNumbers&);
