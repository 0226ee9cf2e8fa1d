// SPDX-License-Identifier: MIT
//
// Wavefront OBJ: the vertices, lines `v x y z`. Four numbers are a rational vertex, of which only
// weight 1 is a point; six or seven carry a colour. Each vertex may have these or not, unless
// columns are chosen or the first has another count of numbers: then all must have as many.
// Everything else in the file is passed over.

#include <utility>

#include "orthoball/error.h"
#include "orthoball/input/fields.h"
#include "orthoball/input/formats.h"
#include "orthoball/input/text_rows.h"

namespace orthoball {
namespace {

// Whether so many numbers are a vertex, perhaps with a weight or a colour.
bool is_usual(std::size_t count) { return count == 3 || count == 4 || count == 6 || count == 7; }

}  // namespace

Reading read_obj(const Source& source, const ReadOptions& options) {
  Lines lines(source.bytes);
  std::string_view line;
  std::vector<std::string_view> fields;
  TextRows sites(source, options);
  std::size_t count = 0;  // numbers of the first vertex
  while (lines.next(line)) {
    line = trimmed(line);
    if (line.size() < 2 || line[0] != 'v' || (line[1] != ' ' && line[1] != '\t')) continue;
    split_at_blanks(line.substr(1, line.find('#') - 1), fields);
    const auto fail = [&](const std::string& message) {
      throw ParseError(source.name, lines.number(), message);
    };
    if (fields.size() < 3) fail("a vertex with fewer than 3 coordinates; x, y and z are needed");
    const bool has_own_use = !options.radius_column.empty() || !options.weight_column.empty();
    if (fields.size() == 4 && !has_own_use &&
        number_at(source, lines.number(), fields[3], "the vertex weight").nearest != 1.0) {
      fail("a rational vertex with weight " + quoted(fields[3]) +
           "; only 1 is a point (a radius is named by --radius-column 4)");
    }
    if (sites.size() == 0) {
      count = fields.size();
      std::vector<std::string> names{"x", "y", "z"};
      names.resize(count);
      sites.name_columns(lines.number(), std::move(names));
    }
    if (!has_own_use && options.columns.empty() && is_usual(fields.size()) && is_usual(count)) {
      fields.resize(count);  // of which 3 are read
    }
    sites.add(lines.number(), fields);
    // A fourth number must be looked at.
    if (fields.size() != 4 || has_own_use) sites.add_plain(lines, {.mark = "v"});
  }
  return std::move(sites).reading();
}

}  // namespace orthoball
