// SPDX-License-Identifier: MIT
#include "orthoball/output/location_table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace orthoball {
namespace {

template <int D>
void write_rows(TableWriter& table, const Filtration<D>& filtration, SimplexId simplex) {
  if (!simplex.exists()) return table.none();
  const auto rows = filtration.rows(simplex);
  table.integers(std::span(rows.begin(), rows.size()), [](SiteId row) { return row.row(); });
}

}  // namespace

template <int D>
void write_locations(ByteSink& sink, TableFormat format, const Filtration<D>& filtration,
                     std::span<const Location<D>> locations) {
  std::vector<std::string> columns{"row", "inside", "region", "distance", "x", "y"};
  if (D == 3) columns.emplace_back("z");
  columns.insert(columns.end(), {"nearest", "simplex"});
  TableWriter table(sink, format, std::move(columns));
  std::int64_t row = 0;
  for (const Location<D>& location : locations) {
    table.integer(row++);
    table.integer(location.region > 0 ? 1 : 0);
    location.region > 0 ? table.integer(location.region) : table.none();
    const bool has_nearest = location.nearest.simplex.exists();
    has_nearest ? table.real(location.nearest.distance) : table.none();
    for (const double x : location.nearest.point) has_nearest ? table.real(x) : table.none();
    write_rows(table, filtration, location.nearest.simplex);
    write_rows(table, filtration, location.simplex);
  }
  table.finish();
}

template void write_locations<2>(ByteSink&, TableFormat, const Filtration<2>&,
                                 std::span<const Location<2>>);
template void write_locations<3>(ByteSink&, TableFormat, const Filtration<3>&,
                                 std::span<const Location<3>>);

}  // namespace orthoball
