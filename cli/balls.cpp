// SPDX-License-Identifier: MIT
#include "cli/balls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cli/alpha_number.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "orthoball/error.h"
#include "orthoball/input/probe_radius.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/output/row_names.h"

void add_balls_options(CLI::App& command, BallsOptions& options) {
  command
      .add_option("--probe", options.probe,
                  "radius R of a probe [length]: every radius r becomes r + R")
      ->type_name("R")
      ->capture_default_str()
      ->group("Balls");
  add_alpha_options(command, options.alpha, false, "0, the balls as they are");
}

orthoball::ProbeRadius checked_probe(const BallsOptions& options) {
  check(options.alpha, false);
  const std::string& text = options.probe;
  if (alpha2_from_text("--probe", text) < 0.0) {
    throw UsageError(fmt::format("--probe: \"{}\" is below 0; the radius of a probe is 0 or more",
                                 text.substr(0, 40)));
  }
  return orthoball::probe_radius(text);
}

orthoball::Reading with_probe(orthoball::Reading reading, const orthoball::ProbeRadius& probe) {
  try {
    reading.points = orthoball::with_probe(reading.points, probe);
  } catch (const orthoball::InputError& error) {
    const auto& lines = reading.labels.line;
    const std::size_t line = error.row() < lines.size() ? lines[error.row()] : 0;
    throw orthoball::ParseError(reading.file, line, error.what());
  }
  return reading;
}

ChosenAlpha chosen_alpha(const BallsOptions& options, const Loaded& input) {
  AlphaOptions alpha = options.alpha;
  if (!alpha.is_given()) alpha.alpha2 = "0";
  return chosen_alphas(alpha, input).front();
}

std::string balls_text(const Loaded& input, const ChosenBalls& balls) {
  std::string text = input_text(input);
  if (balls.probe.nearest > 0.0) {
    const std::string unit = input.unit().empty() ? "" : " " + input.unit();
    text += report_line("probe", number_text(balls.probe.nearest) + unit);
  }
  return text + report_line("at", text_of(balls.at));
}

nlohmann::ordered_json balls_json(const Loaded& input, const ChosenBalls& balls,
                                  std::size_t& missing) {
  using Json = nlohmann::ordered_json;
  const ChosenAlpha& at = balls.at;
  const bool has_alpha = !orthoball::is_of_empty_complex(at.index, at.alpha2);
  Json json;
  json["input"] = input_json(input);
  json["dimension"] = input.shapes.points().dimension();
  json["name"] = at.name.empty() ? Json() : Json(at.name);
  json["alpha2"] = has_alpha ? finite(at.alpha2, missing) : Json();
  json["alpha"] = has_alpha ? finite(at.alpha, missing) : Json();
  json["index"] = at.index;
  json["probe"] = balls.probe.nearest;
  return json;
}

void add_lining(nlohmann::ordered_json& json, std::span<const orthoball::LiningBall> lining,
                bool has_areas, const Loaded& input, std::size_t& missing) {
  using Json = nlohmann::ordered_json;
  std::vector<orthoball::SiteId> rows;
  Json atoms = Json::array(), areas = Json::array();
  for (const orthoball::LiningBall& ball : lining) {
    rows.push_back(ball.row);
    atoms.push_back(ball.row.row());
    if (has_areas) areas.push_back(finite(ball.area, missing));
  }
  json["atoms"] = std::move(atoms);
  json["atom_names"] = names_json(rows, input);
  json["atom_areas"] = has_areas ? std::move(areas) : Json();
}

nlohmann::ordered_json names_json(std::span<const orthoball::SiteId> rows, const Loaded& input) {
  const orthoball::RowNames names(input.reading.labels);
  if (!names.has_any()) return nullptr;
  auto json = nlohmann::ordered_json::array();
  for (const orthoball::SiteId row : rows) json.push_back(names.path(row.row()));
  return json;
}

std::uint64_t union_memory(const UnionWork& work) {
  const bool is_space = work.dimension == 3;
  const std::uint64_t of_balls = is_space ? 255 : 80;
  const std::uint64_t of_voids = is_space ? 415 : 200;
  constexpr std::uint64_t kPart = 16, kDerivatives = 100;  // a site: what is kept
  constexpr std::uint64_t kContact = 52, kKeptContact = sizeof(orthoball::Contact);
  const std::uint64_t derivatives = work.derivatives ? kDerivatives * work.sites : 0;
  return derivatives + std::max(of_balls * work.sites + kContact * work.contacts,
                                (kPart + of_voids) * work.sites + kKeptContact * work.contacts);
}

std::uint64_t molecular_memory(const orthoball::Filtration<3>& filtration, std::uint32_t index) {
  constexpr std::uint64_t kSite = 150, kTriangle = 1300;  // if all probes reach through
  std::uint64_t boundary = 0;
  const std::uint32_t first = filtration.table().first(2);
  for (std::uint32_t i = 0; i < filtration.count(2); ++i) {
    const orthoball::SimplexId triangle(first + i);
    boundary +=
        filtration.enters(triangle) <= index && filtration.interior(triangle) > index ? 1U : 0U;
  }
  return kSite * filtration.triangulation().site_count() + kTriangle * boundary;
}

std::uint64_t pockets_memory(int dimension, std::size_t cells) {
  return std::uint64_t{dimension == 3 ? 32U : 82U} * cells;
}

std::uint64_t report_memory(std::size_t balls, const Loaded& input) {
  const bool has_names = orthoball::RowNames(input.reading.labels).has_any();
  return std::uint64_t{has_names ? 560U : 380U} * balls;
}

void warn_without_balls(const InputOptions& options, const Loaded& input, double alpha2) {
  const orthoball::WeightedPoints& points = input.shapes.points();
  if (points.size() == 0) return;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (orthoball::ball_radius(points, row, alpha2).value_or(0.0) > 0.0) return;
  }
  const bool has_weights = points.weight_kind() != orthoball::WeightKind::none;
  say(options, fmt::format("warning: no ball has a radius above 0 at this alpha2; give {}--probe R "
                           "or a larger --alpha2",
                           has_weights ? "" : "radii (--radii, --radius-column), "));
}
