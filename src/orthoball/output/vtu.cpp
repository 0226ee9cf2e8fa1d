// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "orthoball/output/mesh_formats.h"

namespace orthoball {
namespace {

// Collects the little-endian bytes of one array, then writes them as a DataArray in base64: the
// number of bytes, encoded by itself, then the bytes.
class DataArray {
 public:
  template <class T>
  void add(T number) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    bytes_.append(bytes.data(), bytes.size());
  }
  void write(ByteSink& sink, std::string_view attributes) {
    sink.text("<DataArray ");
    sink.text(attributes);
    sink.text(" format=\"binary\">");
    DataArray size;
    size.add(static_cast<std::uint64_t>(bytes_.size()));
    base64(sink, size.bytes_);
    base64(sink, bytes_);
    sink.text("</DataArray>\n");
  }

 private:
  static void base64(ByteSink& sink, std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t i) -> std::uint32_t {
      return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
    };
    // In pieces that the sink does not see, so that nothing is read again after each digit.
    std::array<char, 4096> piece;
    std::size_t size = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
      piece[size] = kDigits[three >> 18U];
      piece[size + 1] = kDigits[three >> 12U & 63U];
      piece[size + 2] = i + 1 < bytes.size() ? kDigits[three >> 6U & 63U] : '=';
      piece[size + 3] = i + 2 < bytes.size() ? kDigits[three & 63U] : '=';
      size += 4;
      if (size < piece.size()) continue;
      sink.text({piece.data(), size});
      size = 0;
    }
    sink.text({piece.data(), size});
  }

  std::string bytes_;
};

constexpr std::uint8_t kVertex = 1, kLine = 3, kTriangle = 5;  // VTK's cell types

void write_cells(ByteSink& sink, const ShapeMesh& mesh, bool roles) {
  DataArray connectivity, offsets, types, cell_roles;
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
  sink.text(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n");
  DataArray alpha2, index;
  alpha2.add(options.alpha2);
  alpha2.write(sink, "type=\"Float64\" Name=\"alpha2\" NumberOfTuples=\"1\"");
  index.add(mesh.index);
  index.write(sink, "type=\"UInt32\" Name=\"index\" NumberOfTuples=\"1\"");
  sink.text("</FieldData>\n<Piece NumberOfPoints=\"");
  sink.integer(static_cast<std::int64_t>(mesh.vertex_count()));
  sink.text("\" NumberOfCells=\"");
  sink.integer(static_cast<std::int64_t>(cells));
  sink.text("\">\n<Points>\n");
  {
    DataArray positions;
    for (const double x : mesh.coordinates) positions.add(x);
    positions.write(sink, "type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\"");
  }
  sink.text("</Points>\n");
  write_cells(sink, mesh, options.roles);
  sink.text("<PointData>\n");
  DataArray rows;
  for (const SiteId row : mesh.rows) rows.add(row.row());
  rows.write(sink, "type=\"UInt32\" Name=\"row\"");
  sink.text("</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace orthoball
