// SPDX-License-Identifier: MIT
#include "orthoball/output/power_cell_files.h"

#include <cstdint>
#include <string>
#include <vector>

#include "orthoball/output/row_names.h"
#include "orthoball/output/vtu_array.h"

namespace orthoball {
namespace {

constexpr std::uint8_t kPolygon = 7, kPolyhedron = 42;  // VTK's cell types

std::int64_t signed_count(std::size_t count) { return static_cast<std::int64_t>(count); }

// What VTK's <Cells> is made of; points are numbered from cell to cell.
struct VtuCells {
  VtuArray points, connectivity, offsets, types, faces, face_offsets;
  std::size_t point_count = 0, face_size = 0;

  template <int D>
  void add(const PowerCell<D>& cell) {
    for (const auto& corner : cell.corners) {
      for (std::size_t axis = 0; axis < 3; ++axis) points.add(axis < D ? corner[axis] : 0.0);
    }
    const std::size_t first = point_count;
    point_count += cell.corners.size();
    for (std::size_t i = first; i < point_count; ++i) connectivity.add(signed_count(i));
    offsets.add(signed_count(point_count));
    types.add(D == 3 ? kPolyhedron : kPolygon);
    if (D == 2) return;  // corners are in order
    faces.add(signed_count(cell.facets.size()));
    for (const PowerFacet& facet : cell.facets) {
      faces.add(std::int64_t{facet.end} - facet.begin);
      for (std::uint32_t i = facet.begin; i < facet.end; ++i) {
        faces.add(signed_count(first + cell.loops[i]));
      }
    }
    face_size += 1 + cell.facets.size() + cell.loops.size();
    face_offsets.add(signed_count(face_size));
  }
};

struct VtuCellData {
  VtuArray row, volume, area, exposed_area, facets, is_clipped;

  template <int D>
  void add(const PowerCell<D>& cell) {
    row.add(cell.row.row());
    volume.add(cell.volume);
    area.add(cell.area);
    exposed_area.add(cell.exposed_area);
    facets.add(cell.facet_count);
    is_clipped.add(static_cast<std::uint8_t>(cell.is_clipped ? 1 : 0));
  }
};

}  // namespace

template <int D>
void write_power_cells(ByteSink& sink, TableFormat format, std::span<const PowerCell<D>> cells,
                       std::size_t rows, const SiteLabels& labels) {
  const RowNames names(labels);
  std::vector<std::string> columns = RowNames::columns();
  for (const char* column : {"element", "volume", "area", "exposed_area", "facets", "is_clipped"}) {
    columns.emplace_back(column);
  }
  TableWriter table(sink, format, columns);
  const PowerCell<D> none;
  auto next = cells.begin();
  for (std::size_t row = 0; row < rows; ++row) {
    const bool has_cell = next != cells.end() && next->row.row() == row;
    const PowerCell<D>& cell = has_cell ? *next++ : none;
    names.write(table, row);
    table.text(names.element(row));
    table.real(cell.volume);
    table.real(cell.area);
    table.real(cell.exposed_area);
    table.integer(cell.facet_count);
    table.integer(cell.is_clipped ? 1 : 0);
  }
  table.finish();
}

template <int D>
void write_power_cells_vtu(ByteSink& sink, std::span<const PowerCell<D>> cells) {
  VtuCells geometry;
  VtuCellData data;
  std::size_t count = 0;
  for (const PowerCell<D>& cell : cells) {
    if (cell.facets.empty()) continue;
    geometry.add(cell);
    data.add(cell);
    ++count;
  }
  sink.text(kVtuHead);
  write_vtu_piece(sink, geometry.point_count, count);
  sink.text("<Points>\n");
  geometry.points.write(sink, "type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\"");
  sink.text("</Points>\n<Cells>\n");
  geometry.connectivity.write(sink, "type=\"Int64\" Name=\"connectivity\"");
  geometry.offsets.write(sink, "type=\"Int64\" Name=\"offsets\"");
  geometry.types.write(sink, "type=\"UInt8\" Name=\"types\"");
  if (D == 3) {
    geometry.faces.write(sink, "type=\"Int64\" Name=\"faces\"");
    geometry.face_offsets.write(sink, "type=\"Int64\" Name=\"faceoffsets\"");
  }
  sink.text("</Cells>\n<CellData Scalars=\"volume\">\n");
  data.row.write(sink, "type=\"UInt32\" Name=\"row\"");
  data.volume.write(sink, "type=\"Float64\" Name=\"volume\"");
  data.area.write(sink, "type=\"Float64\" Name=\"area\"");
  data.exposed_area.write(sink, "type=\"Float64\" Name=\"exposed_area\"");
  data.facets.write(sink, "type=\"UInt32\" Name=\"facets\"");
  data.is_clipped.write(sink, "type=\"UInt8\" Name=\"is_clipped\"");
  sink.text("</CellData>\n");
  sink.text(kVtuTail);
  sink.flush();
}

template <int D>
void write_power_cells_obj(ByteSink& sink, std::span<const PowerCell<D>> cells,
                           std::string_view title) {
  sink.text("# ");
  sink.text(title);
  sink.text("\n");
  std::size_t first = 1;  // OBJ counts from 1
  const auto write_corner = [&](std::uint32_t corner) {
    sink.text(" ");
    sink.integer(signed_count(first + corner));
  };
  for (const PowerCell<D>& cell : cells) {
    if (cell.facets.empty()) continue;
    sink.text("o row_");
    sink.integer(cell.row.row());
    sink.text("\n");
    for (const auto& corner : cell.corners) {
      sink.text("v");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sink.text(" ");
        sink.real(axis < D ? corner[axis] : 0.0);
      }
      sink.text("\n");
    }
    if (D == 2) {
      sink.text("f");
      for (std::uint32_t i = 0; i < cell.corners.size(); ++i) write_corner(i);
      sink.text("\n");
    }
    for (const PowerFacet& facet : cell.facets) {
      if (D == 2) break;
      sink.text("f");
      for (std::uint32_t i = facet.begin; i < facet.end; ++i) write_corner(cell.loops[i]);
      sink.text("\n");
    }
    first += cell.corners.size();
  }
  sink.flush();
}

template void write_power_cells<2>(ByteSink&, TableFormat, std::span<const PowerCell<2>>,
                                   std::size_t, const SiteLabels&);
template void write_power_cells<3>(ByteSink&, TableFormat, std::span<const PowerCell<3>>,
                                   std::size_t, const SiteLabels&);
template void write_power_cells_vtu<2>(ByteSink&, std::span<const PowerCell<2>>);
template void write_power_cells_vtu<3>(ByteSink&, std::span<const PowerCell<3>>);
template void write_power_cells_obj<2>(ByteSink&, std::span<const PowerCell<2>>, std::string_view);
template void write_power_cells_obj<3>(ByteSink&, std::span<const PowerCell<3>>, std::string_view);

}  // namespace orthoball
