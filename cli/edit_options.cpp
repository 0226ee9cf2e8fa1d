// SPDX-License-Identifier: MIT
#include "cli/edit_options.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/alpha_number.h"
#include "cli/input_options.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "orthoball/counted.h"

namespace {

std::optional<double> threshold(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const double number = alpha2_from_text(option, text);
  if (number >= 0.0) return number;
  throw UsageError(fmt::format("{}: {} is below 0; a volume is 0 or more", option, text));
}

}  // namespace

void add_edit_options(CLI::App& command, EditOptions& options) {
  const std::string group = "Parts";
  command
      .add_flag("--regularized", options.regularized,
                "without singular simplices: the solid part only")
      ->group(group);
  command
      .add_option("--hole-threshold", options.hole_threshold,
                  "fill holes of at most this volume [length^3; in the plane length^2]")
      ->type_name("V")
      ->group(group);
  command
      .add_option("--region-threshold", options.region_threshold,
                  "then leave out regions of at most this volume")
      ->type_name("V")
      ->group(group);
  command
      .add_option("--region", options.region,
                  "only the N-th region by volume of those, from 1 (default: all)")
      ->type_name("N")
      ->check(whole_number(1, std::numeric_limits<std::uint32_t>::max()))
      ->group(group);
}

orthoball::ShapeEdits edits(const EditOptions& options) {
  return {.regularized = options.regularized,
          .hole_threshold = threshold("--hole-threshold", options.hole_threshold),
          .region_threshold = threshold("--region-threshold", options.region_threshold),
          .region = options.region};
}

template <int D>
std::string text_of(const orthoball::EditedShape<D>& shape, const EditOptions& options) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  const auto of_volume = [](std::size_t count, double volume) {
    const std::string name = D == 2 ? "area" : "volume";
    return count == 0 ? std::string() : " of " + name + " " + number_text(volume);
  };
  using orthoball::counted;
  if (!options.hole_threshold.empty()) {
    add("filled " + counted(shape.holes_filled, "hole") +
        of_volume(shape.holes_filled, shape.volume_filled));
  }
  if (!options.region_threshold.empty()) {
    add("left out " + counted(shape.regions_dropped, "region") +
        of_volume(shape.regions_dropped, shape.volume_dropped));
    add(counted(shape.region_count - shape.regions_dropped, "region") + " left");
  }
  if (options.region > 0) {
    add(fmt::format("region {} of {}", options.region, shape.region_count - shape.regions_dropped));
  }
  return text;
}

template <int D>
void add_json(nlohmann::ordered_json& json, const orthoball::EditedShape<D>& shape,
              const EditOptions& options) {
  json["region"] = nullptr;
  if (options.region > 0) json["region"] = options.region;
  json["regions"] = nullptr;
  if (options.region > 0 || !options.region_threshold.empty()) {
    json["regions"] = shape.region_count - shape.regions_dropped;
  }
  json["holes_filled"] = shape.holes_filled;
  json["volume_filled"] = shape.volume_filled;
  json["regions_dropped"] = shape.regions_dropped;
  json["volume_dropped"] = shape.volume_dropped;
}

template std::string text_of(const orthoball::EditedShape<2>&, const EditOptions&);
template std::string text_of(const orthoball::EditedShape<3>&, const EditOptions&);
template void add_json(nlohmann::ordered_json&, const orthoball::EditedShape<2>&,
                       const EditOptions&);
template void add_json(nlohmann::ordered_json&, const orthoball::EditedShape<3>&,
                       const EditOptions&);
