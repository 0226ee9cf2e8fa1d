// SPDX-License-Identifier: MIT
//
// Point files of the 1995 alpha shape programs (Delcx, Mkalf, Alvis, Volbl): one point a line, with
// commands in lines that begin with #. `#fix: W.A` announces numbers of up to W digits, A of them
// decimals; `#scale: S` multiplies all lengths by S; `#title:` and other # lines are comments.
// After the coordinates may follow the point's signed radius: -r stands for the imaginary radius r
// sqrt(-1).   @cite akkiraju_1995_alpha

#include <algorithm>
#include <optional>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/text_rows.h"

namespace orthoball {
namespace {

// What follows `#name:` in a command line.
std::optional<std::string_view> command(std::string_view line, std::string_view name) {
  line = trimmed(line);
  if (line.empty() || line.front() != '#') return std::nullopt;
  line = trimmed(line.substr(1));
  if (line.substr(0, name.size()) != name) return std::nullopt;
  line = trimmed(line.substr(name.size()));
  if (line.empty() || line.front() != ':') return std::nullopt;
  return trimmed(line.substr(1));
}

// The A of "W.A", if the text is that.
std::optional<int> announced_decimals(std::string_view text) {
  const auto is_short_number = [](std::string_view part) {
    return !part.empty() && part.size() <= 3 &&
           part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos || !is_short_number(text.substr(0, point)) ||
      !is_short_number(text.substr(point + 1))) {
    return std::nullopt;
  }
  return std::stoi(std::string(text.substr(point + 1)));
}

// The signed radius is the number after the coordinates, if there is one.
ReadOptions with_radius_column(ReadOptions options, std::size_t numbers) {
  const bool is_chosen =
      !options.columns.empty() || !options.radius_column.empty() || !options.weight_column.empty();
  const auto coordinates =
      static_cast<std::size_t>(options.dimension.value_or(numbers < 3 ? 2 : 3));
  if (!is_chosen && numbers > coordinates) options.radius_column = std::to_string(coordinates + 1);
  return options;
}

}  // namespace

bool is_alpha_1995(std::string_view text) {
  Lines lines(text);
  std::string_view line;
  while (lines.next(line)) {
    if (const auto fix = command(line, "fix")) return announced_decimals(*fix).has_value();
    line = trimmed(line);
    if (!line.empty() && line.front() != '#') return false;
  }
  return false;
}

Reading read_alpha_1995(const Source& source, const ReadOptions& options) {
  Lines lines(source.bytes);
  std::string_view line;
  std::vector<std::string_view> fields;
  std::optional<int> decimals;
  std::optional<DecimalNumber> scale;
  std::vector<std::string> notes;
  ReadOptions with_radius = options;
  TextRows sites(source, with_radius);
  while (lines.next(line)) {
    const auto fail = [&](const std::string& message) {
      throw ParseError(source.name, lines.number(), message);
    };
    if (const auto text = command(line, "fix")) {
      decimals = announced_decimals(*text);
      if (!decimals)
        fail("#fix: " + quoted(*text) + "; two counts of digits such as 7.5 are needed");
    } else if (const auto factor = command(line, "scale")) {
      scale = number_at(source, lines.number(), *factor, "the scale");
      if (scale->nearest <= 0.0) fail("the scale is " + quoted(*factor) + "; it must be positive");
      if (sites.size() > 0) fail("a scale after the first point; it must come before");
      sites.scale_by(*scale);
      notes.push_back("all lengths are multiplied by the file's scale, " + std::string(*factor));
    } else if (const auto title = command(line, "title")) {
      notes.push_back("title: " + quoted(*title));
    }
    split_at_blanks(line, fields);
    if (fields.empty() || fields[0].front() == '#') continue;
    if (sites.size() == 0) with_radius = with_radius_column(options, fields.size());
    sites.add(lines.number(), fields);
  }
  const int most_decimals = sites.decimals();
  Reading reading = std::move(sites).reading();
  if (with_radius.radius_column != options.radius_column) reading.radii = "the file's own";
  reading.notes.insert(reading.notes.begin(), notes.begin(), notes.end());
  if (decimals && most_decimals > *decimals) {
    reading.warnings.push_back("numbers have up to " + std::to_string(most_decimals) +
                               " decimals, " + std::to_string(*decimals) +
                               " announced; all of them are used");
  }
  return reading;
}

}  // namespace orthoball
