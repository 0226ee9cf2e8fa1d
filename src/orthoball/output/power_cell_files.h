// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "orthoball/input/site_labels.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/queries/power_cells.h"

namespace orthoball {

/// `row,chain,residue,atom,element,volume,area,exposed_area,facets,is_clipped`, one line an input
/// row, as those of the other tables of balls. Rows without a power cell, hidden and equal ones
/// included, end in zeros. `facets` is the number of neighbours, `is_clipped` 1 or 0.
/// @param cells  by row.
/// @param rows   of the input.
/// @throws OutputError
template <int D>
void write_power_cells(ByteSink& sink, TableFormat format, std::span<const PowerCell<D>> cells,
                       std::size_t rows, const SiteLabels& labels);

/// VTK's unstructured grid: a polyhedron, in the plane a polygon, for every power cell that has a
/// surface, each with corners of its own, and cell data `row`, `volume`, `area`, `exposed_area`,
/// `facets`, `is_clipped`. Arrays as base64.
/// @throws OutputError
template <int D>
void write_power_cells_vtu(ByteSink& sink, std::span<const PowerCell<D>> cells);

/// Wavefront OBJ: an object `row_N` for every power cell that has a surface, its facets polygons
/// that turn counterclockwise as seen from outside. In the plane one polygon each, with z = 0.
/// @param title  one line, a comment.
/// @throws OutputError
template <int D>
void write_power_cells_obj(ByteSink& sink, std::span<const PowerCell<D>> cells,
                           std::string_view title);

extern template void write_power_cells<2>(ByteSink&, TableFormat, std::span<const PowerCell<2>>,
                                          std::size_t,
                                          const SiteLabels&);  // in power_cell_files.cpp
extern template void write_power_cells<3>(ByteSink&, TableFormat, std::span<const PowerCell<3>>,
                                          std::size_t, const SiteLabels&);
extern template void write_power_cells_vtu<2>(ByteSink&, std::span<const PowerCell<2>>);
extern template void write_power_cells_vtu<3>(ByteSink&, std::span<const PowerCell<3>>);
extern template void write_power_cells_obj<2>(ByteSink&, std::span<const PowerCell<2>>,
                                              std::string_view);
extern template void write_power_cells_obj<3>(ByteSink&, std::span<const PowerCell<3>>,
                                              std::string_view);

}  // namespace orthoball
