// SPDX-License-Identifier: MIT
#include "orthoball/output/solid_table.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace orthoball {

template <int D>
void write_solid_changes(ByteSink& sink, TableFormat format, const AlphaComplex<D>& shape,
                         const ManifoldSolid<D>& solid) {
  const Filtration<D>& filtration = shape.filtration();
  std::vector<std::string> columns{"change", "cells", "volume"};
  for (std::size_t axis = 0; axis < D; ++axis) columns.emplace_back(1, "xyz"[axis]);
  columns.emplace_back("rows");
  TableWriter table(sink, format, columns);
  const auto row_of = [](SiteId row) { return row.row(); };
  for (const SolidChange<D>& change : solid.changes) {
    table.text(change.is_added ? "added" : "removed");
    table.integer(static_cast<std::int64_t>(change.cells.size()));
    table.real(change.volume);
    for (const double x : change.centre) table.real(x);
    table.integers(change.rows, row_of);
  }
  for (std::uint32_t simplex = 0; simplex < filtration.table().first(D); ++simplex) {
    if (shape.role(SimplexId(simplex)) != Role::singular) continue;
    table.text("dropped");
    for (std::size_t column = 0; column < D + 2; ++column) table.none();
    const auto rows = filtration.rows(SimplexId(simplex));
    table.integers(std::vector<SiteId>(rows.begin(), rows.end()), row_of);
  }
  table.finish();
}

template void write_solid_changes<2>(ByteSink&, TableFormat, const AlphaComplex<2>&,
                                     const ManifoldSolid<2>&);
template void write_solid_changes<3>(ByteSink&, TableFormat, const AlphaComplex<3>&,
                                     const ManifoldSolid<3>&);

}  // namespace orthoball
