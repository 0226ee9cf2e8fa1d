// SPDX-License-Identifier: MIT
#include "orthoball/output/mesh.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "orthoball/error.h"
#include "orthoball/output/alpha_text.h"
#include "orthoball/output/mesh_formats.h"

namespace orthoball {
namespace {

constexpr std::array<std::pair<std::string_view, MeshFormat>, 6> kFormats{
    {{"ply", MeshFormat::ply},
     {"obj", MeshFormat::obj},
     {"off", MeshFormat::off},
     {"stl", MeshFormat::stl},
     {"vtu", MeshFormat::vtu},
     {"glb", MeshFormat::glb}}};

void put(ByteSink& sink, std::string_view before, std::size_t number, std::string_view after) {
  sink.text(before);
  sink.integer(static_cast<std::int64_t>(number));
  sink.text(after);
}

std::string title(const ShapeMesh& mesh, const MeshOptions& options) {
  return "boundary of the alpha shape at " + alpha_text(options.alpha2, mesh.index);
}

void write_ply(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options) {
  sink.text("ply\nformat binary_little_endian 1.0\ncomment ");
  sink.text(title(mesh, options));
  if (options.roles) sink.text("\ncomment role: 1 singular, 2 regular");
  put(sink, "\nelement vertex ", mesh.vertex_count(),
      "\nproperty double x\nproperty double y\nproperty double z\nproperty uint row\n");
  const std::string_view role = options.roles ? "property uchar role\n" : "";
  put(sink, "element face ", mesh.triangles.size(), "\nproperty list uchar int vertex_indices\n");
  sink.text(role);
  if (!mesh.edges.empty()) {
    put(sink, "element edge ", mesh.edges.size(), "\nproperty int vertex1\nproperty int vertex2\n");
    sink.text(role);
  }
  sink.text("end_header\n");

  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sink.little_endian(mesh.coordinates[3 * v + axis]);
    }
    sink.little_endian(mesh.rows[v].row());
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sink.little_endian(std::uint8_t{3});
    for (const std::uint32_t v : mesh.triangles[t]) sink.little_endian(v);
    if (options.roles) sink.little_endian(static_cast<std::uint8_t>(mesh.triangle_roles[t]));
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    for (const std::uint32_t v : mesh.edges[e]) sink.little_endian(v);
    if (options.roles) sink.little_endian(static_cast<std::uint8_t>(mesh.edge_roles[e]));
  }
}

void write_coordinates(ByteSink& sink, const ShapeMesh& mesh, std::string_view before) {
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    sink.text(before);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis > 0) sink.text(" ");
      sink.real(mesh.coordinates[3 * v + axis]);
    }
    sink.text("\n");
  }
}

template <class Corners>
void write_corners(ByteSink& sink, std::string_view before, const Corners& corners,
                   std::uint32_t first) {
  sink.text(before);
  for (const std::uint32_t v : corners) put(sink, " ", std::size_t{v} + first, "");
  sink.text("\n");
}

void write_obj(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options) {
  sink.text("# ");
  sink.text(title(mesh, options));
  sink.text("\n");
  write_coordinates(sink, mesh, "v ");
  for (const Role role : {Role::regular, Role::singular}) {
    if (options.roles) sink.text(role == Role::regular ? "g regular\n" : "g singular\n");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.triangle_roles[t] == role) write_corners(sink, "f", mesh.triangles[t], 1);
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      if (mesh.edge_roles[e] == role) write_corners(sink, "l", mesh.edges[e], 1);
    }
    if (role == Role::regular) continue;
    for (const std::uint32_t v : mesh.isolated) write_corners(sink, "p", std::array{v}, 1);
  }
}

void write_off(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options) {
  sink.text("OFF\n# ");
  sink.text(title(mesh, options));
  put(sink, "\n", mesh.vertex_count(), " ");
  put(sink, "", mesh.triangles.size(), " 0\n");
  write_coordinates(sink, mesh, "");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sink.text("3");
    for (const std::uint32_t v : mesh.triangles[t]) put(sink, " ", v, "");
    if (options.roles) {
      sink.text(mesh.triangle_roles[t] == Role::regular ? " 86 180 233" : " 230 159 0");
    }
    sink.text("\n");
  }
}

std::array<double, 3> unit_normal(const std::array<std::array<double, 3>, 3>& corners) {
  std::array<double, 3> u, v;
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = corners[1][i] - corners[0][i];
    v[i] = corners[2][i] - corners[0][i];
    largest = std::max({largest, std::abs(u[i]), std::abs(v[i])});
  }
  if (!(largest > 0.0) || !std::isfinite(largest)) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] /= largest;  // so that no product over- or underflows
    v[i] /= largest;
  }
  std::array<double, 3> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                               u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (!(length > 0.0)) return {};
  for (double& x : normal) x /= length;
  return normal;
}

void write_stl(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options) {
  std::string header = title(mesh, options);
  header.resize(80, ' ');
  sink.text(header);
  if (mesh.triangles.size() > 0xFFFFFFFFU) throw LimitError("an STL holds at most 2^32 triangles");
  sink.little_endian(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        corners[i][axis] = mesh.coordinates[3 * std::size_t{triangle[i]} + axis];
      }
    }
    for (const double x : unit_normal(corners)) sink.little_endian(static_cast<float>(x));
    for (const auto& corner : corners) {
      for (const double x : corner) sink.little_endian(static_cast<float>(x));
    }
    sink.little_endian(std::uint16_t{0});
  }
}

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view ending) {
  for (const auto& [name, format] : kFormats) {
    if (name == ending) return format;
  }
  return std::nullopt;
}

bool holds_roles(MeshFormat format) { return format != MeshFormat::stl; }

bool holds_edges(MeshFormat format) {
  return format != MeshFormat::off && format != MeshFormat::stl;
}

void write_mesh(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options) {
  switch (options.format) {
    case MeshFormat::ply:
      write_ply(sink, mesh, options);
      break;
    case MeshFormat::obj:
      write_obj(sink, mesh, options);
      break;
    case MeshFormat::off:
      write_off(sink, mesh, options);
      break;
    case MeshFormat::stl:
      write_stl(sink, mesh, options);
      break;
    case MeshFormat::vtu:
      write_vtu(sink, mesh, options);
      break;
    case MeshFormat::glb:
      write_glb(sink, mesh, options);
      break;
  }
  sink.flush();
}

}  // namespace orthoball
