// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <string_view>

#include "orthoball/error.h"
#include "orthoball/input/formats.h"

namespace orthoball {

namespace {

// The first line of the file that should be a ball.
std::size_t first_row(const Source& source) {
  Lines lines(source.bytes);
  std::string_view line;
  while (lines.next(line)) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && line[begin] != '#') return lines.number();
  }
  return 0;
}

}  // namespace

// Balls as `x y z r`, one a line, what follows ignored: a table whose columns are known.
Reading read_xyzr(const Source& source, const ReadOptions& options) {
  if (options.dimension.value_or(3) != 3) {
    throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow,
                     "dimension 2 does not fit the format xyzr, which holds balls in space");
  }
  ReadOptions table = options;
  table.dimension = 3;
  if (table.columns.empty()) table.columns = {"1", "2", "3"};
  if (table.radius_column.empty() && table.weight_column.empty())
    table.radius_column = std::string("4");
  try {
    return read_table(source, table);
  } catch (const InputError&) {
    // Columns that nobody asked for are missing: that is the file's fault.
    const bool is_asked = !options.columns.empty() || !options.radius_column.empty() ||
                          !options.weight_column.empty();
    if (is_asked) throw;
    throw ParseError(source.name, first_row(source),
                     "fewer than four columns; a ball is x y z r on one line");
  }
}

}  // namespace orthoball
