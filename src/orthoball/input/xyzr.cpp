// SPDX-License-Identifier: MIT
#include <string>

#include "orthoball/error.h"
#include "orthoball/input/formats.h"

namespace orthoball {

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
  return read_table(source, table);
}

}  // namespace orthoball
