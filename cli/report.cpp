// SPDX-License-Identifier: MIT
#include "cli/report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "cli/json_text.h"
#include "orthoball/counted.h"

using Json = nlohmann::ordered_json;

std::string report_line(const std::string& label, const std::string& text) {
  return fmt::format("{:<17}{}\n", label, text);
}

std::string number_text(double number) {
  return std::isfinite(number) ? fmt::format("{}", number + 0.0) : "beyond double range";
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string betti_text(std::span<const std::uint32_t> betti) {
  constexpr std::array<std::string_view, 3> kNouns{"component", "tunnel", "void"};
  std::vector<std::string> words;
  for (std::size_t k = 0; k < betti.size(); ++k) {
    words.push_back(orthoball::counted(betti[k], kNouns[k]));
  }
  return joined(words);
}

Json finite(double number, std::size_t& missing) {
  if (std::isfinite(number)) return number + 0.0;
  ++missing;
  return nullptr;
}

std::string input_text(const Loaded& input) {
  const orthoball::WeightedPoints& points = input.shapes.points();
  const orthoball::Reading& reading = input.reading;
  std::string text = report_line("input", reading.file + " (" + reading.format + ")");
  text += report_line("sites", fmt::format("{} in {}", points.size(),
                                           points.dimension() == 3 ? "space" : "the plane"));
  text += report_line("numbers",
                      points.decimals()
                          ? fmt::format("exact decimals, {} after the point", *points.decimals())
                          : std::string("doubles"));
  text += report_line("radii", reading.radii);
  for (const std::string& note : reading.notes) text += report_line("note", note);
  return text;
}

Json input_json(const Loaded& input) {
  const auto& points = input.shapes.points();
  return {{"file", input.reading.file},
          {"format", input.reading.format},
          {"sites", points.size()},
          {"decimals", points.decimals() ? Json(*points.decimals()) : Json()},
          {"radii", input.reading.radii},
          {"notes", input.reading.notes}};
}

std::string json_report_text(const Json& json) {
  std::vector<std::string> lines;
  for (const auto& [key, value] : json.items()) {
    std::string text = json_text(value);
    if (value.is_array() && !value.empty() && value[0].is_object()) {
      std::vector<std::string> objects;
      for (const Json& object : value) objects.push_back(json_text(object));
      text = fmt::format("[\n    {}\n  ]", fmt::join(objects, ",\n    "));
    }
    lines.push_back(fmt::format("  {}: {}", json_text(Json(key)), text));
  }
  return fmt::format("{{\n{}\n}}\n", fmt::join(lines, ",\n"));
}
