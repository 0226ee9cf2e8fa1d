// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>

#include "orthoball/output/mesh_formats.h"
#include "orthoball/output/vtu_array.h"

namespace orthoball {
namespace {

constexpr std::uint8_t kVertex = 1, kLine = 3, kTriangle = 5;  // VTK's cell types

void write_cells(ByteSink& sink, const ShapeMesh& mesh, bool roles) {
  VtuArray connectivity, offsets, types, cell_roles;
  std::int64_t offset = 0;
  const auto add = [&](const auto& corners, std::uint8_t type, Role role) {
    for (const std::uint32_t v : corners) connectivity.add(static_cast<std::int64_t>(v));
    offset += static_cast<std::int64_t>(corners.size());
    offsets.add(offset);
    types.add(type);
    cell_roles.add(static_cast<std::uint8_t>(role));
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    add(mesh.triangles[t], kTriangle, mesh.triangle_roles[t]);
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) add(mesh.edges[e], kLine, mesh.edge_roles[e]);
  for (const std::uint32_t v : mesh.isolated) add(std::array{v}, kVertex, Role::singular);

  sink.text("<Cells>\n");
  connectivity.write(sink, "type=\"Int64\" Name=\"connectivity\"");
  offsets.write(sink, "type=\"Int64\" Name=\"offsets\"");
  types.write(sink, "type=\"UInt8\" Name=\"types\"");
  sink.text("</Cells>\n");
  if (!roles) return;
  sink.text("<CellData Scalars=\"role\">\n");  // 1 singular, 2 regular
  cell_roles.write(sink, "type=\"UInt8\" Name=\"role\"");
  sink.text("</CellData>\n");
}

}  // namespace

void write_vtu(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options) {
  const std::size_t cells = mesh.triangles.size() + mesh.edges.size() + mesh.isolated.size();
  sink.text(kVtuHead);
  sink.text("<FieldData>\n");
  VtuArray alpha2, index;
  alpha2.add(options.alpha2);
  alpha2.write(sink, "type=\"Float64\" Name=\"alpha2\" NumberOfTuples=\"1\"");
  index.add(mesh.index);
  index.write(sink, "type=\"UInt32\" Name=\"index\" NumberOfTuples=\"1\"");
  sink.text("</FieldData>\n");
  write_vtu_piece(sink, mesh.vertex_count(), cells);
  sink.text("<Points>\n");
  {
    VtuArray positions;
    for (const double x : mesh.coordinates) positions.add(x);
    positions.write(sink, "type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\"");
  }
  sink.text("</Points>\n");
  write_cells(sink, mesh, options.roles);
  sink.text("<PointData>\n");
  VtuArray rows;
  for (const SiteId row : mesh.rows) rows.add(row.row());
  rows.write(sink, "type=\"UInt32\" Name=\"row\"");
  sink.text("</PointData>\n");
  sink.text(kVtuTail);
}

}  // namespace orthoball
