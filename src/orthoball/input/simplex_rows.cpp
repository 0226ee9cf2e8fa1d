// SPDX-License-Identifier: MIT
#include "orthoball/input/simplex_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/input/fields.h"

namespace orthoball {
namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  constexpr std::string_view kBetween = " \t,;";
  std::vector<std::string_view> fields;
  for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBetween, end);
  }
  return fields;
}

}  // namespace

SimplexList read_simplices(const std::string& path, int dimension, std::size_t site_count,
                           bool limited, const MemoryBudget& memory) {
  return read_simplices(read_source(path, limited, memory), dimension, site_count);
}

SimplexList read_simplices(const Source& source, int dimension, std::size_t site_count) {
  require_text(source);
  SimplexList list;
  Lines lines(source.bytes);
  for (std::string_view line; lines.next(line);) {
    const auto refuse = [&](const std::string& message) {
      throw ParseError(source.name, lines.number(), message);
    };
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.empty()) continue;
    if (fields.size() < 2 || fields.size() > static_cast<std::size_t>(dimension) + 1) {
      refuse(fmt::format("{}; a simplex in {} has {}", counted(fields.size(), "corner"),
                         dimension == 2 ? "the plane" : "space",
                         dimension == 2 ? "2 or 3" : "2, 3 or 4"));
    }
    std::vector<SiteId> rows;
    for (const std::string_view field : fields) {
      const std::size_t row = count_at(source, lines.number(), field, "a corner");
      if (row >= site_count) {
        refuse(fmt::format("row {} of {}; rows of the points are counted from 0", row, site_count));
      }
      rows.emplace_back(static_cast<std::uint32_t>(row));
    }
    std::sort(rows.begin(), rows.end());
    const auto twice = std::adjacent_find(rows.begin(), rows.end());
    if (twice != rows.end()) {
      refuse(fmt::format("row {} twice; the corners of a simplex are different", twice->row()));
    }
    list.rows.push_back(std::move(rows));
    list.line.push_back(lines.number());
  }
  if (list.rows.empty()) {
    throw ParseError(source.name, 0,
                     "there is no simplex in it; lines of rows such as \"0 5 7\" are expected");
  }
  return list;
}

}  // namespace orthoball
