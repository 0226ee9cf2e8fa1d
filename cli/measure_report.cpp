// SPDX-License-Identifier: MIT
#include "cli/measure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/report.h"
#include "orthoball/counted.h"

namespace {

using Json = nlohmann::ordered_json;

template <int D>
Json json_of(const Loaded& input, const orthoball::Void<D>& hole, bool is_of_balls,
             std::size_t& missing) {
  const auto number = [&](double x) { return finite(x, missing); };
  Json centre = Json::array();
  for (const double x : hole.largest_ball_centre) centre.push_back(number(x));
  Json json;
  json["volume"] = number(hole.volume);
  json["area"] = number(hole.area);
  add_lining(json, hole.lining, is_of_balls, input, missing);
  json["born"] = number(hole.born_alpha2);
  json["dies"] = number(hole.dies_alpha2);
  json["largest_ball"] = nullptr;
  if (hole.largest_ball_radius > 0.0) {
    json["largest_ball"] = {{"centre", std::move(centre)},
                            {"radius", number(hole.largest_ball_radius)}};
  }
  return json;
}

// "486 exposed, 12 buried": those that there are, exposed ones always.
std::string counts_text(const BallCounts& counts) {
  std::vector<std::string> words{fmt::format("{} exposed", counts.exposed)};
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count > 0) words.push_back(fmt::format("{} {}", count, what));
  };
  add(counts.buried, "buried by others");
  add(counts.hidden, "hidden inside others");
  add(counts.duplicates, orthoball::noun_of(counts.duplicates, "duplicate"));
  add(counts.empty, "empty");
  return joined(words);
}

// The first of the voids, a line each.
template <int D>
std::string voids_text(const Measured<D>& measured, const std::string& unit) {
  const std::vector<orthoball::Void<D>>& voids = measured.voids;
  if (voids.empty()) return {};
  const bool is_of_balls = measured.voids_of == orthoball::VoidsOf::balls;
  constexpr std::size_t kShown = 7;
  const auto head = [&](const std::string& what, const char* power) {
    return unit.empty() ? what : fmt::format("{} [{}{}]", what, unit, power);
  };
  const auto row = [](const auto& first, const std::string& volume, const std::string& area,
                      const auto& balls, const std::string& radius) {
    const std::string text = fmt::format("{:<7}{:>22} {:>22} {:>6}", first, volume, area, balls);
    return radius.empty() ? text + "\n" : fmt::format("{} {:>26}\n", text, radius);
  };
  const std::string text_of_ball =
      !is_of_balls ? "" : head(D == 3 ? "largest ball inside" : "largest disk inside", "");
  std::string text = is_of_balls ? "\n" : "\nin the alpha shape\n";
  text += (D == 3 ? row("voids", head("volume", "³"), head("area", "²"), "balls", text_of_ball)
                  : row("holes", head("area", "²"), head("perimeter", ""), "disks", text_of_ball));
  for (std::size_t i = 0; i < std::min(voids.size(), kShown); ++i) {
    const orthoball::Void<D>& hole = voids[i];
    text += row(fmt::format("  {}", i + 1), number_text(hole.volume), number_text(hole.area),
                hole.lining.size(), is_of_balls ? number_text(hole.largest_ball_radius) : "");
  }
  if (voids.size() > kShown) {
    text += fmt::format("  and {} smaller; --voids FILE lists all\n", voids.size() - kShown);
  }
  return text;
}

}  // namespace

template <int D>
BallCounts ball_counts(const Loaded& input, const orthoball::Filtration<D>& filtration,
                       const orthoball::UnionOfBalls& balls) {
  const auto& triangulation = filtration.triangulation();
  BallCounts counts;
  std::vector<bool> has_cell(balls.areas.size(), true);
  for (const orthoball::SiteId row : triangulation.hidden()) has_cell[row.row()] = false;
  for (const orthoball::Duplicate& d : triangulation.duplicates()) has_cell[d.row.row()] = false;
  counts.duplicates = triangulation.duplicates().size();
  counts.hidden = triangulation.hidden().size();
  for (std::size_t row = 0; row < has_cell.size(); ++row) {
    const bool has_inside =
        orthoball::ball_radius(input.shapes.points(), row, balls.alpha2).value_or(0.0) > 0.0;
    if (!has_cell[row]) continue;
    ++(balls.areas[row] > 0.0 ? counts.exposed : has_inside ? counts.buried : counts.empty);
  }
  return counts;
}

template <int D>
std::string json_report(const Loaded& input, const Measured<D>& measured, std::size_t& missing) {
  const auto number = [&](double x) { return finite(x, missing); };
  const orthoball::UnionOfBalls& balls = measured.balls;
  const BallCounts& counts = measured.counts;
  Json json = balls_json(input, measured.chosen, missing);
  json["volume"] = number(balls.volume);
  json["area"] = number(balls.area);
  json["mean_curvature"] = D == 3 ? number(balls.mean_curvature) : Json();
  json["molecular_surface"] = nullptr;
  if (const auto& surface = measured.molecular_surface) {
    json["molecular_surface"] = {{"volume", number(surface->volume)},
                                 {"area", number(surface->area)},
                                 {"convex_area", number(surface->convex_area)},
                                 {"toroidal_area", number(surface->toroidal_area)},
                                 {"concave_area", number(surface->concave_area)}};
  }
  json["euler"] = balls.euler;
  json["betti"] = measured.betti;
  json["balls"] = {{"exposed", counts.exposed},
                   {"buried", counts.buried},
                   {"hidden", counts.hidden},
                   {"duplicates", counts.duplicates},
                   {"empty", counts.empty}};
  const bool is_of_balls = measured.voids_of == orthoball::VoidsOf::balls;
  json["voids_of"] = is_of_balls ? "balls" : "shape";
  json["void_count"] = measured.voids.size();
  json["voids"] = Json::array();
  for (const orthoball::Void<D>& hole : measured.voids) {
    json["voids"].push_back(json_of(input, hole, is_of_balls, missing));
  }
  return json_report_text(json);
}

template <int D>
std::string text_report(const Loaded& input, const Measured<D>& measured) {
  const auto unit = [&](const char* power) {
    return input.reading.is_molecule ? " Å" + std::string(power) : std::string();
  };
  const orthoball::UnionOfBalls& balls = measured.balls;
  std::string text = balls_text(input, measured.chosen);
  text += report_line(input.reading.is_molecule ? "atoms"
                      : D == 3                  ? "balls"
                                                : "disks",
                      counts_text(measured.counts));
  text +=
      report_line(D == 3 ? "volume" : "area", number_text(balls.volume) + unit(D == 3 ? "³" : "²"));
  text +=
      report_line(D == 3 ? "area" : "perimeter", number_text(balls.area) + unit(D == 3 ? "²" : ""));
  if (D == 3) text += report_line("mean curvature", number_text(balls.mean_curvature) + unit(""));
  if (const auto& surface = measured.molecular_surface) {
    text += report_line("molecular volume", number_text(surface->volume) + unit("³"));
    text += report_line("molecular area", number_text(surface->area) + unit("²"));
    text += report_line(
        "  of it",
        fmt::format("convex {}, toroidal {}, concave {}", number_text(surface->convex_area),
                    number_text(surface->toroidal_area), number_text(surface->concave_area)));
  }
  text += report_line("euler", fmt::format("{}", balls.euler));
  text += report_line("betti", betti_text(measured.betti));
  return text + voids_text(measured, input.unit());
}

template BallCounts ball_counts(const Loaded&, const orthoball::Filtration<2>&,
                                const orthoball::UnionOfBalls&);
template std::string json_report(const Loaded&, const Measured<2>&, std::size_t&);
template std::string text_report(const Loaded&, const Measured<2>&);
template BallCounts ball_counts(const Loaded&, const orthoball::Filtration<3>&,
                                const orthoball::UnionOfBalls&);
template std::string json_report(const Loaded&, const Measured<3>&, std::size_t&);
template std::string text_report(const Loaded&, const Measured<3>&);
