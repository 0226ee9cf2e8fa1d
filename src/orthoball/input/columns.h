// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "orthoball/input/read.h"

namespace orthoball {

/// Which columns of a table are read, and as what.
struct Columns {
  int dimension = 3;
  std::vector<std::size_t> coordinates;  ///< [axis] 0-based
  WeightKind weight_kind = WeightKind::none;
  std::size_t weight = 0;  ///< 0-based; unused for WeightKind::none
  std::string radii;       ///< in words: "none", "column 4", "weights in column 4"
  std::string note;        ///< in words, where coordinates are not simply all columns
};

/// What the rows of a table look like.
struct TableShape {
  std::span<const std::string> names;  ///< [column] or empty; empty names for nameless columns
  std::size_t columns = 0;
  std::size_t numbers = 0;  ///< how many columns of the first row hold numbers
  std::size_t line = 0;     ///< of that row
};

/// The columns that `options` ask for. By default coordinates are the columns named x, y[, z], or
/// lon, lat, or longitude, latitude, in any case of letters, else the first columns that are not
/// the radius or weight. Their number is by default that of the named ones, else 3 where there
/// are three numbers or more without the radius or weight, 2 where there are two.
/// @throws InputError for a column that is not there and for options that contradict each other.
/// @throws ParseError at `shape.line` where there are too few columns.
[[nodiscard]] Columns chosen_columns(const std::string& file, const ReadOptions& options,
                                     const TableShape& shape);

/// The dimension of a table without rows, by the same rules: 3 where nothing tells it.
[[nodiscard]] int dimension_without_rows(const ReadOptions& options,
                                         std::span<const std::string> names);

}  // namespace orthoball
