// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "orthoball/ids.h"
#include "orthoball/input/source.h"
#include "orthoball/memory_budget.h"

namespace orthoball {

/// Simplices that a file lists, one a line.
struct SimplexList {
  std::vector<std::vector<SiteId>> rows;  ///< [simplex]: 2 to 4 rows of the input, ascending
  std::vector<std::size_t> line;          ///< [simplex]: 1-based line of the file
};

/// Reads a text of simplices: on every line the rows of the input, from 0, of the corners of an
/// edge, triangle or tetrahedron, with blanks, commas or semicolons between. Empty lines and lines
/// that begin with # are passed over. gzip is unpacked; - is standard input.
/// @param dimension   of the points: 2 allows 2 or 3 corners, 3 also 4.
/// @param site_count  of the points; rows are below it.
/// @throws ParseError `FILE:LINE: what is wrong; what would be right`, also for a file without any
///         simplex or one that cannot be opened.
/// @throws LimitError for a file that is larger than `memory` allows.
[[nodiscard]] SimplexList read_simplices(const std::string& path, int dimension,
                                         std::size_t site_count, bool limited = true,
                                         const MemoryBudget& memory = {});

/// The same from bytes that are there.
[[nodiscard]] SimplexList read_simplices(const Source& source, int dimension,
                                         std::size_t site_count);

}  // namespace orthoball
