// SPDX-License-Identifier: MIT
#include "orthoball/input/columns.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/source.h"

namespace orthoball {
namespace {

[[noreturn]] void fail(const std::string& message) {
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow, message);
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<std::size_t> column_named(const TableShape& shape, std::string_view name) {
  const auto begin = shape.names.begin();
  auto found = std::find(begin, shape.names.end(), name);
  if (found == shape.names.end()) {
    found = std::find_if(begin, shape.names.end(),
                         [&](const std::string& other) { return same_letters(other, name); });
  }
  if (found == shape.names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - begin);
}

std::size_t column_asked_for(const std::string& file, const std::string& column,
                             const TableShape& shape) {
  const bool is_number = !column.empty() && column.size() < 10 &&
                         column.find_first_not_of("0123456789") == std::string::npos;
  if (is_number) {
    const std::size_t number = std::stoul(column);
    if (number >= 1 && number <= shape.columns) return number - 1;
    fail(file + ": there is no column " + column + "; columns count from 1 to " +
         std::to_string(shape.columns));
  }
  if (const auto found = column_named(shape, column); found && !column.empty()) return *found;
  std::string names;
  for (const std::string& name : shape.names) {
    if (names.size() < 200 && !name.empty()) names += (names.empty() ? "" : ", ") + quoted(name);
  }
  fail(file + ": there is no column named " + quoted(column) + "; " +
       (names.empty() ? "its columns have numbers only" : "its columns are " + names));
}

// The columns that names tell to be coordinates; empty if none do.
std::vector<std::size_t> named_coordinates(const TableShape& shape, std::optional<int> dimension) {
  constexpr std::array<std::array<std::string_view, 2>, 3> kPairs = {
      {{"x", "y"}, {"lon", "lat"}, {"longitude", "latitude"}}};
  for (const auto& [first, second] : kPairs) {
    const auto x = column_named(shape, first), y = column_named(shape, second);
    if (!x || !y) continue;
    const auto z = first == "x" ? column_named(shape, "z") : std::nullopt;
    if (z && dimension.value_or(3) == 3) return {*x, *y, *z};
    if (dimension.value_or(2) == 2) return {*x, *y};
  }
  return {};
}

std::string column_words(const TableShape& shape, std::size_t column) {
  const bool has_name = column < shape.names.size() && !shape.names[column].empty();
  return std::to_string(column + 1) + (has_name ? " (" + quoted(shape.names[column]) + ")" : "");
}

}  // namespace

Columns chosen_columns(const std::string& file, const ReadOptions& options,
                       const TableShape& shape) {
  Columns chosen;
  chosen.radii = "none";
  const bool has_weight = !options.radius_column.empty() || !options.weight_column.empty();
  if (!options.radius_column.empty()) {
    chosen.weight_kind = WeightKind::radius;
    chosen.weight = column_asked_for(file, options.radius_column, shape);
    chosen.radii = "column " + column_words(shape, chosen.weight);
  } else if (has_weight) {
    chosen.weight_kind = WeightKind::weight;
    chosen.weight = column_asked_for(file, options.weight_column, shape);
    chosen.radii = "weights in column " + column_words(shape, chosen.weight);
  }

  for (const std::string& column : options.columns) {
    chosen.coordinates.push_back(column_asked_for(file, column, shape));
  }
  if (chosen.coordinates.empty()) {
    chosen.coordinates = named_coordinates(shape, options.dimension);
  }
  if (chosen.coordinates.empty()) {
    const std::size_t numbers = shape.numbers - (has_weight && shape.numbers > 0 ? 1 : 0);
    const std::size_t needed = options.dimension ? static_cast<std::size_t>(*options.dimension)
                                                 : std::clamp<std::size_t>(numbers, 2, 3);
    for (std::size_t column = 0; column < shape.columns; ++column) {
      if (chosen.coordinates.size() == needed) break;
      if (!has_weight || column != chosen.weight) chosen.coordinates.push_back(column);
    }
    if (chosen.coordinates.size() < needed) {
      throw ParseError(file, shape.line,
                       counted(shape.columns, "column") + " for " + std::to_string(needed) +
                           " coordinates" + (has_weight ? " and a weight" : "") +
                           "; one column each is needed");
    }
  }
  chosen.dimension = static_cast<int>(chosen.coordinates.size());

  if (shape.columns != chosen.coordinates.size() + (has_weight ? 1 : 0)) {
    for (const std::size_t column : chosen.coordinates) {
      chosen.note += (chosen.note.empty() ? "" : ", ") + column_words(shape, column);
    }
    chosen.note = "coordinates are columns " + chosen.note + " of " + std::to_string(shape.columns);
  }
  return chosen;
}

int dimension_without_rows(const ReadOptions& options, std::span<const std::string> names) {
  if (options.dimension) return *options.dimension;
  if (!options.columns.empty()) return static_cast<int>(options.columns.size());
  const auto named = named_coordinates({names, names.size(), 0, 0}, std::nullopt);
  return named.empty() ? 3 : static_cast<int>(named.size());
}

}  // namespace orthoball
