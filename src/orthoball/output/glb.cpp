// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/output/mesh_formats.h"

namespace orthoball {
namespace {

constexpr int kPoints = 0, kLines = 1, kTriangles = 4;  // glTF's numbers of primitives

// One draw call: the simplices of one dimension and role.
struct Primitive {
  int mode;
  int material;
  std::vector<std::uint32_t> indices;
};

struct Box {
  std::array<double, 3> middle{};
  std::array<float, 3> low{}, high{};  // of the positions relative to the middle
};

float relative(double x, double middle) { return static_cast<float>(x - middle); }

Box box_of(const ShapeMesh& mesh) {
  Box box;
  for (std::size_t axis = 0; axis < 3 && mesh.vertex_count() > 0; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      low = std::min(low, mesh.coordinates[3 * v + axis]);
      high = std::max(high, mesh.coordinates[3 * v + axis]);
    }
    box.middle[axis] = low / 2 + high / 2;
    box.low[axis] = relative(low, box.middle[axis]);
    box.high[axis] = relative(high, box.middle[axis]);
  }
  return box;
}

template <class Simplices>
void add_primitives(std::vector<Primitive>& primitives, const Simplices& simplices,
                    const std::vector<Role>& roles, int mode) {
  for (const Role role : {Role::regular, Role::singular}) {
    Primitive primitive{mode, role == Role::regular ? 0 : 1, {}};
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      if (roles[i] != role) continue;
      primitive.indices.insert(primitive.indices.end(), simplices[i].begin(), simplices[i].end());
    }
    if (!primitive.indices.empty()) primitives.push_back(std::move(primitive));
  }
}

std::vector<Primitive> primitives_of(const ShapeMesh& mesh) {
  std::vector<Primitive> primitives;
  add_primitives(primitives, mesh.triangles, mesh.triangle_roles, kTriangles);
  add_primitives(primitives, mesh.edges, mesh.edge_roles, kLines);
  if (!mesh.isolated.empty()) primitives.push_back({kPoints, 1, mesh.isolated});
  return primitives;
}

template <class Numbers>
void write_list(ByteSink& json, std::string_view before, const Numbers& numbers) {
  json.text(before);
  json.text("[");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) json.text(",");
    json.real(static_cast<double>(numbers[i]));
  }
  json.text("]");
}

void write_number(ByteSink& json, std::string_view before, std::size_t number) {
  json.text(before);
  json.integer(static_cast<std::int64_t>(number));
}

constexpr std::array<double, 4> kBlue{0.337, 0.706, 0.914, 1.0}, kOrange{0.902, 0.624, 0.0, 1.0};

void write_material(ByteSink& json, std::string_view name, const std::array<double, 4>& colour) {
  json.text("{\"name\":");
  json.json_string(name);
  write_list(json,
             ",\"doubleSided\":true,\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
             "\"roughnessFactor\":0.8,\"baseColorFactor\":",
             colour);
  json.text("}}");
}

// The JSON chunk. Buffer view 0 holds the positions, view i + 1 the indices of primitive i.
std::string json_chunk(const ShapeMesh& mesh, const MeshOptions& options,
                       const std::vector<Primitive>& primitives, const Box& box) {
  std::ostringstream out;
  ByteSink json(out, "0");
  json.text("{\"asset\":{\"version\":\"2.0\",\"generator\":\"orthoball\"},\"scene\":0,");
  json.text("\"extras\":{\"alpha2\":");
  json.text(std::isfinite(options.alpha2) ? shortest_text(options.alpha2) : "null");
  write_number(json, ",\"index\":", mesh.index);
  if (primitives.empty()) {
    json.text("},\"scenes\":[{}]}");
    json.flush();
    return out.str();
  }
  write_list(json,
             "},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"translation\":", box.middle);
  json.text("}],\"materials\":[");
  write_material(json, "regular", kBlue);
  json.text(",");
  write_material(json, "singular", options.roles ? kOrange : kBlue);
  json.text("],\"meshes\":[{\"primitives\":[");
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    write_number(json,
                 i > 0 ? ",{\"attributes\":{\"POSITION\":0},\"mode\":"
                       : "{\"attributes\":{\"POSITION\":0},\"mode\":",
                 static_cast<std::size_t>(primitives[i].mode));
    write_number(json, ",\"indices\":", i + 1);
    write_number(json, ",\"material\":", static_cast<std::size_t>(primitives[i].material));
    json.text("}");
  }
  write_number(json, "]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":",
               mesh.vertex_count());
  write_list(json, ",\"type\":\"VEC3\",\"min\":", box.low);
  write_list(json, ",\"max\":", box.high);
  json.text("}");
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    write_number(json, ",{\"bufferView\":", i + 1);
    write_number(json, ",\"componentType\":5125,\"count\":", primitives[i].indices.size());
    json.text(",\"type\":\"SCALAR\"}");
  }
  std::size_t offset = 12 * mesh.vertex_count();
  write_number(json, "],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":", offset);
  json.text(",\"target\":34962}");
  for (const Primitive& primitive : primitives) {
    write_number(json, ",{\"buffer\":0,\"byteOffset\":", offset);
    write_number(json, ",\"byteLength\":", 4 * primitive.indices.size());
    json.text(",\"target\":34963}");
    offset += 4 * primitive.indices.size();
  }
  write_number(json, "],\"buffers\":[{\"byteLength\":", offset);
  json.text("}]}");
  json.flush();
  return out.str();
}

}  // namespace

void write_glb(ByteSink& sink, const ShapeMesh& mesh, const MeshOptions& options) {
  const std::vector<Primitive> primitives = primitives_of(mesh);
  const Box box = box_of(mesh);
  std::string json = json_chunk(mesh, options, primitives, box);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::size_t binary_size = primitives.empty() ? 0 : 12 * mesh.vertex_count();
  for (const Primitive& primitive : primitives) binary_size += 4 * primitive.indices.size();
  const std::size_t file_size = 12 + 8 + json.size() + (binary_size > 0 ? 8 + binary_size : 0);
  if (file_size > std::numeric_limits<std::uint32_t>::max()) {
    throw LimitError("the GLB would have " + std::to_string(file_size) +
                     " bytes; a GLB holds less than 4 GiB, PLY and VTU hold more");
  }
  sink.text("glTF");
  sink.little_endian(std::uint32_t{2});
  sink.little_endian(static_cast<std::uint32_t>(file_size));
  sink.little_endian(static_cast<std::uint32_t>(json.size()));
  sink.text("JSON");
  sink.text(json);
  if (binary_size == 0) return;
  sink.little_endian(static_cast<std::uint32_t>(binary_size));
  sink.text(std::string_view("BIN\0", 4));
  for (std::size_t i = 0; i < mesh.coordinates.size(); ++i) {
    sink.little_endian(relative(mesh.coordinates[i], box.middle[i % 3]));
  }
  for (const Primitive& primitive : primitives) {
    for (const std::uint32_t v : primitive.indices) sink.little_endian(v);
  }
}

}  // namespace orthoball
